#pragma once

// A block of atoms on a surface, one load step after the other, answered in
// the quantities every method answers in.

#include "base/grid.hpp"
#include "cases/types/case.hpp"
#include "md/interface/interface.hpp"
#include "md/minimise/relaxation.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::md {

/// Everything that defines the block.
struct AtomRequest {
  cases::MdSettings settings;
  cases::Scales scales;
  double youngs_modulus = 0.0; ///< of the one block that stands for the pair
                               ///< [Pa]
  double poisson_ratio = 0.0;  ///< [1]
  Grid layer;                  ///< the block's lowest layer of atoms
  Grid substrate;              ///< the rigid atoms
  std::vector<double> heights; ///< of the rigid atoms [m], mean 0
  int threads = 1;
  std::filesystem::path scratch; ///< folder for checkpoints, dumps and what a
                                 ///< child process reads and writes
};

/// One load step. Maps are on the grid of the lowest layer.
struct AtomStep {
  std::vector<double> pressure; ///< normal force an atom over a^2 [Pa]
  std::vector<double> gap;      ///< z - h(x) - d_c [m], negative where the soft
                                ///< potential is pressed in
  double nominal_pressure = 0.0; ///< [Pa]
  double mean_gap = 0.0;         ///< u = d - d_c [m]
  double contact_count = 0.0;    ///< share of atoms with a pair nearer than
                                 ///< d_c [1]
  double elastic_energy = 0.0;   ///< of the bulk per nominal area [J/m^2]
  double interface_energy = 0.0; ///< of all pairs per nominal area [J/m^2]
  Inspection inspection;
  int evaluations = 0;    ///< of energy and forces
  int linearisations = 0; ///< of the second derivatives, a sum over all pairs
  int products = 0;       ///< of the second derivatives with a step
  double residual = 0.0;  ///< as RelaxationSettings::tolerance
  bool converged = false; ///< in balance, and nothing went through
  std::string note;       ///< why not, or by how much a hot step fluctuates;
                          ///< empty otherwise
};

class AtomicContact {
public:
  virtual ~AtomicContact() = default;

  /// The next step of the load program: warm from the one before, or from
  /// above where there is none.
  /// @param amount  nominal pressure [Pa] or mean gap [m]
  /// @param step    index in the program, names what is dumped
  virtual AtomStep solve(cases::Control control, double amount, int step,
                         const Watch& watch = {}) = 0;

  /// Where the next step starts from, to go on in another process; empty for a
  /// block that cannot.
  virtual std::vector<double> state() const { return {}; }

  /// @param state  of an equal block
  /// @throws std::domain_error  it is not of this block's size
  virtual void restore(std::span<const double> state) {
    static_cast<void>(state);
  }

  /// One line for the report: lattice, bulk, modulus really shown.
  virtual std::string description() const = 0;

  /// E* that a wave of wavevector q a = 0.1 really meets [Pa].
  virtual double shown_contact_modulus() const = 0;
};

} // namespace asperity::md
