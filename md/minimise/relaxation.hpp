#pragma once

// From a state to the nearest balance of forces: L-BFGS with the system's own
// preconditioner, and FIRE. Owns when to stop and when to give up.

#include "md/minimise/system.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::md {

struct RelaxationSettings {
  double tolerance = 1e-4;        ///< root mean square of the forces, relative
                                  ///< to Evaluation::contact_force [1]
  int max_evaluations = 20000;    ///< of energy and forces
  double largest_step = 0.3e-10;  ///< of any unknown in one step [m]
  int memory = 12;                ///< pairs that L-BFGS keeps
  double contact_stiffness = 1.2; ///< k_c of System::precondition [N/m],
                                  ///< about 0.075 eV/angstrom^2
};

struct Progress {
  int evaluations = 0;
  double energy = 0.0;   ///< [J]
  double residual = 0.0; ///< as `tolerance`
};

struct Relaxation {
  bool converged = false;
  int evaluations = 0;    ///< of energy and forces
  int linearisations = 0; ///< of the second derivatives (Newton's method)
  int products = 0;       ///< of them with a step, likewise
  double energy = 0.0;    ///< [J]
  double residual = 0.0;  ///< root mean square, as `tolerance`
  double largest_residual = 0.0; ///< largest force on any unknown, likewise
  std::string note;              ///< why it did not converge; empty otherwise
};

/// Called now and then; false ends the relaxation, not converged.
using Watch = std::function<bool(const Progress&)>;

/// Preconditioned L-BFGS from `state`, which it overwrites with the answer.
Relaxation relax(const System& system, std::vector<double>& state,
                 const RelaxationSettings& settings, const Watch& watch = {});

/// The residual of forces, as RelaxationSettings::tolerance has it; infinity
/// where nothing touches.
double residual_of(const Evaluation& evaluation,
                   std::span<const double> forces);

} // namespace asperity::md
