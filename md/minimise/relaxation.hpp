#pragma once

// The minimisers' settings and results, and the preconditioned L-BFGS method.

#include "md/minimise/system.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::md {

struct RelaxationSettings {
  double tolerance = 1e-4;        ///< root mean square of the forces, relative
                                  ///< to Evaluation::contact_force [1]
  int max_evaluations = 20000;    ///< of energy and forces
  double largest_step = 0.3e-10;  ///< of any unknown per step [m]
  int memory = 12;                ///< pairs stored by L-BFGS
  double contact_stiffness = 1.2; ///< k_c of System::precondition [N/m], about
                                  ///< 0.075 eV/angstrom^2
};

struct Progress {
  int evaluations = 0;
  double energy = 0.0;   ///< [J]
  double residual = 0.0; ///< as `tolerance`
};

struct Relaxation {
  bool converged = false;
  int evaluations = 0;    ///< of energy and forces
  int linearisations = 0; ///< evaluations of second derivatives (Newton's
                          ///< method)
  int products = 0;       ///< products with second derivatives (Newton's
                          ///< method)
  double energy = 0.0;    ///< [J]
  double residual = 0.0;  ///< root mean square, as `tolerance`
  double largest_residual = 0.0; ///< largest force on any unknown, likewise
                                 ///< relative
  std::string note;              ///< why it did not converge; empty otherwise
};

/// Called at intervals; the return value false stops the relaxation without
/// convergence.
using Watch = std::function<bool(const Progress&)>;

/// Minimises the energy from `state` by preconditioned L-BFGS and overwrites
/// `state` with the solution.
Relaxation relax(const System& system, std::vector<double>& state,
                 const RelaxationSettings& settings, const Watch& watch = {});

/// Returns the residual of the forces as defined by
/// RelaxationSettings::tolerance; infinity if there is no contact force.
double residual_of(const Evaluation& evaluation,
                   std::span<const double> forces);

} // namespace asperity::md
