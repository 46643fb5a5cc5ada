#pragma once

// Computes the results of a load step from positions and normal forces: gap,
// area and energies.

#include "md/contact/atomic_contact.hpp"
#include "md/minimise/system.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace asperity::md {

struct ReadingDistances {
  double contact = 0.0; ///< d_c [m]
  double close = 0.0;   ///< of a penetrating pair [m]
};

/// Sets the maps, the nominal pressure (the mean of the pressure map), the
/// contact count and the inspection of `step`, and leaves its other members
/// unchanged.
/// @param atoms          of the lowest layer of the block
/// @param normal_forces  on them [N]
void read_maps(const Interface& interface, const Grid& layer,
               const LayerView& atoms, std::span<const double> normal_forces,
               const ReadingDistances& distances, AtomStep& step);

/// Sets the mean gap and the energies, too.
/// @param state          of the system [m]
/// @param normal_forces  on the atoms of the lowest layer [N]
void read_step(const System& system, std::span<const double> state,
               std::span<const double> normal_forces,
               const ReadingDistances& distances, AtomStep& step);

/// Accuracy of the mean gap under a prescribed height, over d_c.
inline constexpr double gap_accuracy = 1e-6;

/// The mean of the absolute values.
double mean_size(std::span<const double> values);

/// Returns why an equilibrium is not valid in spite of its residual, e.g.
/// "3.1 % of the atoms are below the substrate ..."; empty if no atom has
/// penetrated.
std::string invalidity_reason(const Inspection& inspection, std::size_t atoms);

} // namespace asperity::md
