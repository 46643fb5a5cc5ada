#pragma once

// The driver of load steps of the built-in engine. It is common to all bulk
// models: approach, equilibrium, evaluation, and the initial guess of the next
// step. A derived class defines how the block moves and how equilibrium is
// found.

#include "md/contact/atomic_contact.hpp"
#include "md/contact/dump.hpp"
#include "md/dynamics/dynamics_run.hpp"
#include "md/minimise/relaxation.hpp"
#include "md/minimise/system.hpp"

#include <span>
#include <vector>

namespace asperity::md {

class LoadStepDriver : public AtomicContact {
public:
  AtomStep solve(const mechanics::LoadTarget& target, int step,
                 const Watch& watch) final;

  std::vector<double> state() const final { return state_; }

  void restore(std::span<const double> state) final;

protected:
  /// Result of the search for the equilibrium of one load step.
  struct Balance {
    Relaxation relaxation;
    TimeAverage average; ///< at finite temperature; otherwise it has no samples
  };

  /// @param request  moved into the driver
  explicit LoadStepDriver(AtomRequest request);

  /// Initialises the state. The constructor of the class that owns the system
  /// must call this once.
  void start();

  const AtomRequest& request() const { return request_; }

  virtual System& system() = 0;
  virtual const System& system() const = 0;

  /// Relaxes `state` to an approximate equilibrium at the prescribed height.
  virtual Relaxation approach(std::vector<double>& state,
                              const RelaxationSettings& settings) = 0;

  /// Relaxes `state` to equilibrium by the minimiser that the case selects.
  virtual Balance balance(const Load& load, int step,
                          std::vector<double>& state,
                          const RelaxationSettings& settings,
                          const Watch& watch) = 0;

  /// Returns the atoms of the block for a dump.
  virtual std::vector<AtomGroup> block_atoms(std::span<const double> state,
                                             const AtomStep& step) const = 0;

  std::filesystem::path file_of(int step, const char* ending) const;

private:
  RelaxationSettings settings_for(double contact_force) const;
  void raise_to(double height);
  double contact_force();
  Relaxation descend_to(double height);
  Balance balance_at(const Load& load, int step, const Watch& watch);
  void read_average(const Load& load, const TimeAverage& average,
                    AtomStep& result) const;

  AtomRequest request_;
  std::vector<double> state_; ///< of the last valid step, initially above the
                              ///< substrate
};

} // namespace asperity::md
