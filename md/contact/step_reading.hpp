#pragma once

// From positions and normal forces to what a load step reports. Owns how gap,
// area and energies are read off a system.

#include "md/contact/atomic_contact.hpp"
#include "md/minimise/system.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace asperity::md {

struct ReadingDistances {
  double contact = 0.0; ///< d_c [m]
  double close = 0.0;   ///< of a pair that went through [m]
};

/// Sets the maps, the nominal pressure, which is their mean, mean gap, contact
/// count, energies and inspection of `step`, and leaves the rest.
/// @param state          of the system [m]
/// @param normal_forces  on the atoms of the lowest layer [N]
void read_step(const System& system, std::span<const double> state,
               std::span<const double> normal_forces,
               const ReadingDistances& distances, AtomStep& step);

/// Why a balance is no result in spite of its residual: "3.1 % of the atoms
/// are below the substrate ..."; empty if nothing went through.
std::string fault_of(const Inspection& inspection, std::size_t atoms);

} // namespace asperity::md
