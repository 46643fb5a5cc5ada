#pragma once

// The contact surface of a solved block as files for ParaView: gap, pressure
// and contact status on the faces of the mesh.
// Include this header in .cpp files of fem/ only.

#include "fem/newton/contact_state.hpp"
#include "fem/parallel/step_files.hpp"
#include "fem/solution/face_maps.hpp"

#include <deal.II/base/data_out_base.h>

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
///                   truncated at 0, or that of the nearest Gauss point of the
///                   face
///     contact       1 where that point is under pressure, otherwise 0; NaN at
///                   hanging nodes, where no contact condition is posed
///     level         how often the cell of the face has been halved
///
/// Gap, pressure and contact are NaN before the first solution. A second-order
/// face is written as four faces of half its width, or as a triangle with six
/// nodes.
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

} // namespace asperity::fem
