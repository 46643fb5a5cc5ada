#pragma once

// Output of solved blocks as files for ParaView. This file defines the fields
// of the block and of its contact surface; block_stress.hpp computes the
// stress, and parallel/step_files.hpp names the files.
// Include this header in .cpp files of fem/ only.

#include "fem/newton/contact_state.hpp"
#include "fem/parallel/step_files.hpp"
#include "fem/solution/block_stress.hpp"
#include "fem/solution/face_maps.hpp"

#include <deal.II/base/data_out_base.h>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// The faces of the first body's contact surface with these fields at their
/// nodes, in SI units. Nodes are not shared between faces, and those on both
/// periodic sides are written.
///
///     displacement  u, vector
///     gap           d + w - h, negative where penalty contact penetrates
///     pressure      p >= 0: interpolated like u_z from nodal values and
///                   truncated at 0
///     contact       1 where that point is under pressure, otherwise 0; NaN at
///                   hanging nodes, where no contact condition is posed
///     level         how often the cell of the face has been halved
///
/// Gap, pressure and contact are NaN before the first solution. A second-order
/// face is written as four faces of half its width.
class SurfaceOutput {
public:
  /// This call is collective.
  /// @param displacement  u at all unknowns of this rank's cells, including
  ///                      constrained ones [m]
  /// @param heights       of the grid [m]; empty before the first solution
  SurfaceOutput(const FaceMaps& maps, const ContactState& state,
                const dealii::TrilinosWrappers::MPI::Vector& displacement,
                std::span<const double> heights);

  /// This object must outlive the series.
  StepSeries series(const std::string& stem,
                    const dealii::DataOutBase::VtkFlags& flags) const;

private:
  using Patch = dealii::DataOutBase::Patch<2, 3>;

  std::vector<Patch> patches_;
};

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
