#pragma once

// One load step of a block of our own: approach, balance, reading, and what is
// kept for the next step. Owns these for every bulk; a bulk says how it moves
// and how its forces are balanced.

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
  AtomStep solve(cases::Control control, double amount, int step,
                 const Watch& watch) final;

  std::vector<double> state() const final { return state_; }

  void restore(std::span<const double> state) final;

protected:
  /// How the balance of one load step was found.
  struct Balance {
    Relaxation relaxation;
    TimeAverage average; ///< of motion at a temperature; no samples without
  };

  /// @param request  kept by the driver
  explicit LoadStepDriver(AtomRequest request);

  /// To be called once, by the constructor of the class that owns the system.
  void start();

  const AtomRequest& request() const { return request_; }

  virtual System& system() = 0;
  virtual const System& system() const = 0;

  /// Adds `change` [m] to the height of every atom of the block.
  virtual void lift(std::span<double> state, double change) const = 0;

  /// From `state` to a rough balance at the height that is held.
  virtual Relaxation approach(std::vector<double>& state,
                              const RelaxationSettings& settings) = 0;

  /// From `state` to the balance, by the minimiser that was asked for.
  virtual Balance balance(const Load& load, int step,
                          std::vector<double>& state,
                          const RelaxationSettings& settings,
                          const Watch& watch) = 0;

  /// The atoms of the block, for a dump.
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
  std::vector<double> state_; ///< of the last valid step, or over the substrate
};

} // namespace asperity::md
