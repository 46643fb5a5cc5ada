#pragma once

// The functions that select and create an atomistic engine. Of this module,
// other modules include only this header and atomic_contact.hpp.

#include "md/contact/atomic_contact.hpp"

#include <memory>
#include <string>

namespace asperity::md {

/// Checks whether the programs that the engine needs are installed. It is
/// called before any output is written.
/// @throws input::InputError  a program is missing; the message names the
///                            package that provides it
void require_engine(const mechanics::MdSettings& settings);

/// Identifies the external program that computes the result by the path, size
/// and modification time of its executable. The string is empty for the
/// built-in engine, or if the program is not found.
std::string engine_identity(const mechanics::MdSettings& settings);

/// Creates the engine that the request selects.
/// @throws input::InputError   incompatible settings, or a program that is not
///                             installed
/// @throws std::domain_error  an argument of a component is out of range
std::unique_ptr<AtomicContact> make_atomic_contact(AtomRequest request);

} // namespace asperity::md
