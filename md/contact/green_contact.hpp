#pragma once

// The block as its surface stiffness (bulk = "green"), brought to balance load
// after load.

#include "md/contact/atomic_contact.hpp"

#include <memory>

namespace asperity::md {

/// The block is settings.depth deep, rounded to whole cells, its top clamped.
/// The first load is come to from above, where nothing touches; each further
/// one starts from the answer before. A mean gap is come down to in short
/// steps, so that the surface gives way and no atom is pushed through.
///
/// @throws cases::CaseError   another engine, bulk or minimizer than this one
/// @throws std::domain_error  what a part refuses
std::unique_ptr<AtomicContact> make_green_contact(AtomRequest request);

} // namespace asperity::md
