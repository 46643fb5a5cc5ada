#pragma once

// The interface of atomistic contact engines. An engine solves the load steps
// one after another and returns the quantities that are common to all methods.

#include "base/grid.hpp"
#include "md/interface/interface.hpp"
#include "md/minimise/relaxation.hpp"
#include "mechanics/loading.hpp"
#include "mechanics/md_settings.hpp"
#include "mechanics/quantity.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::md {

/// Complete definition of the block and the substrate.
struct AtomRequest {
  mechanics::MdSettings settings;
  mechanics::Scales scales;
  double youngs_modulus = 0.0; ///< effective modulus of the single elastic
                               ///< block that represents both bodies [Pa]
  double poisson_ratio = 0.0;  ///< [1]
  Grid layer;                  ///< grid of the block's lowest layer of atoms
  Grid substrate;              ///< grid of the rigid atoms
  std::vector<double> heights; ///< of the rigid atoms [m], mean 0
  int threads = 1;
  std::filesystem::path scratch; ///< folder for checkpoints, dumps and the
                                 ///< files of a child process
};

/// Result of one load step. Maps are on the grid of the lowest layer.
struct AtomStep {
  std::vector<double> pressure; ///< normal force per atom divided by a^2 [Pa]
  std::vector<double> gap;      ///< z - h(x) - d_c [m]; negative where the soft
                                ///< repulsion is compressed
  double nominal_pressure = 0.0; ///< [Pa]
  double mean_gap = 0.0;         ///< u = d - d_c [m]
  /// By how much both may miss what is prescribed [Pa], [m]: what residual
  /// forces within the tolerance add up to at most, or the fluctuations at T >
  /// 0, and 1e-6 d_c.
  double pressure_tolerance = 0.0;
  double gap_tolerance = 0.0;
  double contact_count = 0.0;    ///< fraction of atoms with a pair closer than
                                 ///< d_c [1]
  double elastic_energy = 0.0;   ///< bulk, per nominal area [J/m^2]
  double interface_energy = 0.0; ///< all pairs, per nominal area [J/m^2]
  Inspection inspection;
  int evaluations = 0;    ///< of energy and forces
  int linearisations = 0; ///< evaluations of the second derivatives, each a sum
                          ///< over all pairs
  int products = 0;       ///< products with the second derivatives
  double residual = 0.0;  ///< as RelaxationSettings::tolerance
  bool converged = false; ///< in equilibrium, and no atom has penetrated
  std::string note;       ///< why it did not converge, or the fluctuations at
                          ///< T > 0; empty otherwise
};

class AtomicContact {
public:
  virtual ~AtomicContact() = default;

  /// Solves the next step of the loading path. The initial guess is the
  /// previous solution or, in the first step, the block above the substrate.
  /// @param step  index in the loading path, used in the names of dump files
  virtual AtomStep solve(const mechanics::LoadTarget& target, int step,
                         const Watch& watch = {}) = 0;

  /// Returns the initial guess of the next step, so that another process can
  /// continue; empty if the engine does not support this.
  virtual std::vector<double> state() const { return {}; }

  /// Restores an initial guess returned by state().
  /// @param state  of an identical block
  /// @throws std::domain_error  the size is not that of this block
  virtual void restore(std::span<const double> state) {
    static_cast<void>(state);
  }

  /// Returns a one-line description for the report: lattice, bulk and effective
  /// modulus.
  virtual std::string description() const = 0;

  /// Returns the effective contact modulus E* at q a = 0.1 [Pa].
  virtual double effective_contact_modulus() const = 0;
};

} // namespace asperity::md
