#pragma once

// Bulk green behind the room's front door: the block as its surface stiffness,
// brought to balance load after load.

#include "md/atomic_contact.hpp"

#include <cstddef>
#include <memory>
#include <string>

namespace asperity::md {

/// The block is settings.depth deep, rounded to whole cells, its top clamped.
/// The first load is come to from above, where nothing touches; each further
/// one starts from the answer before. A mean gap is come down to in short
/// steps, so that the surface gives way and no atom is pushed through.
///
/// @throws cases::CaseError   another engine, bulk or minimizer than this one
/// @throws std::domain_error  what a part refuses
std::unique_ptr<AtomicContact> make_green_contact(AtomRequest request);

/// Why a balance is no result in spite of its residual: "3.1 % of the atoms
/// are below the substrate ..."; empty if nothing went through.
std::string fault_of(const Inspection& inspection, std::size_t atoms);

} // namespace asperity::md
