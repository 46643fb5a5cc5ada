#pragma once

// Solved blocks as files for ParaView. Owns names, steps and the form of the
// files; the stress in them is block_stress.hpp's.
// Include from .cpp files of fem/ only.

#include "fem/block/block_stress.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity::fem {

/// The files of FullBlock::write. Fields, all in SI:
///
///     displacement       u, vector                  quadratic where u is
///     stress             sigma, tensor              nodal averages
///     von_mises          sqrt(3 J_2) of that sigma
///     vertical_pressure  -sigma_zz
///     youngs_modulus     E of the cell
///     subdomain          rank of the cell
///
/// A cell of second order is written as eight of half the width, or as a
/// tetrahedron of ten nodes. Time is the nominal pressure, cycle the step.
class BlockOutput {
public:
  /// Collective. The step is the count of calls with this stem before.
  /// @param folder_and_stem   "out/block"; the folder is made if need be
  /// @param nominal_pressure  of the solution [Pa]
  /// @throws std::runtime_error  on every rank if one could not write; files of
  ///                             earlier steps are then untouched
  void write(const std::string& folder_and_stem, const BlockSystem& system,
             BlockStress& stress, double nominal_pressure);

private:
  std::map<std::string, std::vector<double>> steps_; ///< [Pa], by stem
};

/// What a PVD file calls the time of each step: the nominal pressure if it
/// grows from step to step, or else the number of the step, because ParaView
/// lays files of one time over each other.
std::vector<double> times_of(const std::vector<double>& nominal_pressures);

} // namespace asperity::fem
