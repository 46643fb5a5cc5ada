#pragma once

// The engines that can press a block of atoms, and the choice between them.
// Other modules include this header and atomic_contact.hpp, and nothing else.

#include "md/contact/atomic_contact.hpp"

#include <memory>
#include <string>

namespace asperity::md {

/// Whether what the engine needs is installed; to be asked before anything is
/// written.
/// @throws cases::CaseError  a program is not, with the package that has it
void require_engine(const cases::MdSettings& settings);

/// Which program answers, where it is not this one: path, size and time of the
/// file that would be started; empty for our own engine, or if there is none.
std::string engine_identity(const cases::MdSettings& settings);

/// @throws cases::CaseError   settings that do not go together, a program that
///                            is not installed
/// @throws std::domain_error  what a part refuses
std::unique_ptr<AtomicContact> make_atomic_contact(AtomRequest request);

} // namespace asperity::md
