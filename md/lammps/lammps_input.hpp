#pragma once

// Generates the input script of one load step: constraints, load and
// minimisation in LAMMPS. It defines the names of the exchanged files.

#include "md/lammps/lammps_block.hpp"
#include "mechanics/loading.hpp"
#include "mechanics/md_settings.hpp"

#include <string>

namespace asperity::md {

/// File names in the working folder of the child process.
namespace lammps_file {
inline constexpr const char* block = "block.data";
inline constexpr const char* table = "pair.table";
inline constexpr const char* start = "start.dump";
inline constexpr const char* input = "step.in";
inline constexpr const char* answer = "answer.dump"; ///< block: x y z fx fy fz
inline constexpr const char* contact = "contact.dump";  ///< forces of the
                                                        ///< substrate on the
                                                        ///< lowest layer
inline constexpr const char* energies = "energies.txt"; ///< bonds, pairs [eV]
} // namespace lammps_file

/// Parameters of one load step.
struct LammpsTask {
  mechanics::Control control = mechanics::Control::nominal_pressure;
  double amount = 0.0; ///< p_0 [Pa] >= 0, or mean z of the lowest layer [m]
  double start_height = 0.0; ///< mean z of the lowest layer at the start [m]
  double tolerance = 0.0;    ///< as RelaxationSettings::tolerance
  int max_evaluations = 0;
};

/// Returns the input script. The following are constrained: the substrate is
/// fixed; the uppermost layer is a rigid plate, free to move as a whole; and
/// the mean in-plane displacement of the lowest layer is fixed (see System).
///
/// The load p_0 a^2 per atom acts on the lowest layer, as in the Green's
/// function engine, or the mean height of this layer is prescribed and
/// approached in short steps from above. A load on the plate would compress the
/// entire block. This compression is not part of the problem and, at
/// p_0 = 0.01 E*, changes the bending stiffness of the springs by 0.3 %.
///
/// The minimiser is the conjugate gradient method of LAMMPS, which has no
/// L-BFGS. The target residual is below the tolerance by a tenth, as a margin
/// for the residual evaluated afterwards.
std::string input_script(const LammpsBlock& block, const LammpsTask& task);

} // namespace asperity::md
