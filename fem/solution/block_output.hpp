#pragma once

// Output of solved blocks as files for ParaView. This file defines the fields
// of the block; surface_output.hpp defines those of its contact surface,
// block_stress.hpp computes the stress, and parallel/step_files.hpp names the
// files.
// Include this header in .cpp files of fem/ only.

#include "fem/solution/block_stress.hpp"
#include "fem/solution/surface_output.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::fem {

/// Writes the files of FullBlock::write: the block as <stem>, its contact
/// surface as <stem>_surface. The fields of the block are, in SI units:
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
             BlockStress& stress, const SurfaceOutput& surface,
             double nominal_pressure);

private:
  std::map<std::string, std::vector<double>> steps_; ///< nominal pressures
                                                     ///< [Pa], by stem
};

} // namespace asperity::fem
