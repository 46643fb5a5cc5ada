#pragma once

// The input script of one load step: how LAMMPS holds the block, loads it and
// seeks the balance of forces. Owns the names of the files they exchange.

#include "cases/types/case.hpp"
#include "md/lammps/lammps_block.hpp"

#include <string>

namespace asperity::md {

/// In the working folder of the child process.
namespace lammps_file {
inline constexpr const char* block = "block.data";
inline constexpr const char* table = "pair.table";
inline constexpr const char* start = "start.dump";
inline constexpr const char* input = "step.in";
inline constexpr const char* answer = "answer.dump"; ///< block: x y z fx fy fz
inline constexpr const char* contact = "contact.dump";  ///< lowest layer: what
                                                        ///< the substrate does
inline constexpr const char* energies = "energies.txt"; ///< bonds, pairs [eV]
} // namespace lammps_file

/// One load step.
struct LammpsTask {
  cases::Control control = cases::Control::nominal_pressure;
  double amount = 0.0; ///< p_0 [Pa] >= 0, or mean z of the lowest layer [m]
  double start_height = 0.0; ///< mean z of the lowest layer at the start [m]
  double tolerance = 0.0;    ///< as RelaxationSettings::tolerance
  int max_evaluations = 0;
  cases::AtomMinimizer minimizer = cases::AtomMinimizer::automatic;
};

/// Held: the substrate; the uppermost layer as a rigid plate, free as a whole;
/// the mean in-plane displacement of the lowest layer (System says why).
///
/// The load is on the lowest layer, p_0 a^2 an atom, as our own engine has it,
/// or the layer's mean height is kept, to which the block is brought in short
/// steps from above. Loading the plate would compress the whole block, which
/// is no part of the problem and, at p_0 = 0.01 E*, changes how stiff springs
/// are to bending waves by 0.3 %.
///
/// lbfgs is LAMMPS' conjugate gradients (it has no L-BFGS), fire its FIRE. The
/// residual goes below the tolerance by a tenth, for what is measured
/// afterwards.
std::string input_script(const LammpsBlock& block, const LammpsTask& task);

} // namespace asperity::md
