#pragma once

// Output of solved blocks as files for ParaView. This file defines the names,
// the steps and the format of the files; block_stress.hpp computes the stress.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_stress.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity::fem {

/// Writes the files of FullBlock::write. The fields are, in SI units:
///
///     displacement       u, vector                  quadratic where u is
///     stress             sigma, tensor              nodal averages
///     von_mises          sqrt(3 J_2) of that sigma
///     vertical_pressure  -sigma_zz
///     youngs_modulus     E of the cell
///     subdomain          rank of the cell
///     level              how often the cell has been halved
///
/// A second-order hexahedron is written as eight cells of half the width, a
/// second-order tetrahedron with its ten nodes. The time of a step is the
/// nominal pressure, the cycle is the number of the step.
class BlockOutput {
public:
  /// Writes one step; its number is the number of earlier calls with this stem.
  /// This call is collective.
  /// @param folder_and_stem   for example "out/block"; the folder is created if
  ///                          necessary
  /// @param nominal_pressure  nominal pressure of the solution [Pa]
  /// @throws std::runtime_error  on every rank if one of them could not write;
  ///                             files of earlier steps are then unchanged
  void write(const std::string& folder_and_stem, const BlockSystem& system,
             BlockStress& stress, double nominal_pressure);

private:
  std::map<std::string, std::vector<double>> steps_; ///< nominal pressures
                                                     ///< [Pa], by stem
};

/// Times of the steps in a PVD file: the nominal pressures if they increase
/// from step to step, otherwise the numbers of the steps, because ParaView
/// superimposes files with equal times.
std::vector<double> times_of(const std::vector<double>& nominal_pressures);

} // namespace asperity::fem
