#pragma once

// The engine with bulk = "green", in which the block is represented by its
// surface stiffness.

#include "md/contact/atomic_contact.hpp"

#include <memory>

namespace asperity::md {

/// Creates a block of depth settings.depth, rounded to whole cells, with a
/// clamped far boundary. The first load step starts from above, without
/// contact; each further one starts from the previous solution. A prescribed
/// mean gap is approached in short steps, so that the surface can deform and no
/// atom is pushed through the substrate.
///
/// @throws input::InputError   the engine, bulk or minimizer is not supported
///                             here
/// @throws std::domain_error  an argument of a component is out of range
std::unique_ptr<AtomicContact> make_green_contact(AtomRequest request);

} // namespace asperity::md
