#pragma once

// A decorator of an elastic operator that measures CPU time without changes to
// the contact solver.

#include "contact/operators/surface_operator.hpp"

#include <memory>

namespace asperity::methods {

/// Forwards all calls and accumulates the CPU time of the operator
/// applications. Clones and coarser operators add to the same tally, so a tally
/// belongs to one solver and its thread.
class TimedOperator final : public contact::SurfaceOperator {
public:
  /// Accumulated CPU time [s].
  struct Tally {
    double cpu_time = 0.0;
  };

  /// @param n_threads  number of threads that an application may use, see
  ///                   CpuClock
  TimedOperator(std::unique_ptr<contact::SurfaceOperator> measured,
                std::shared_ptr<Tally> tally, int n_threads);

  std::unique_ptr<contact::SurfaceOperator> clone() const override;
  const Grid& grid() const override;
  const SharedRows* shared_rows() const override;
  std::span<const double> nodal_weights() const override;
  void displacement(std::span<const double> pressure,
                    std::span<double> displacement) override;
  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change) override;
  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure) override;
  bool has_inverse() const override;
  void pressure_of(std::span<const double> displacement,
                   std::span<double> pressure) override;
  const Grid& wide_grid() const override;
  void wide_pressure_estimate(std::span<const float> gap,
                              double local_compliance,
                              std::span<float> pressure) override;
  double short_wave_compliance() const override;
  bool is_periodic() const override;
  bool is_shift_invariant() const override;
  int threads() const override;
  std::unique_ptr<contact::SurfaceOperator> periodic_extension() const override;
  std::unique_ptr<contact::SurfaceOperator> coarsened() const override;
  std::unique_ptr<contact::SurfaceOperator>
  on_tiles(const contact::Tiles& tiles) const override;

private:
  /// Another operator that adds to the same tally; null for null.
  std::unique_ptr<contact::SurfaceOperator>
  timed(std::unique_ptr<contact::SurfaceOperator> other) const;

  std::unique_ptr<contact::SurfaceOperator> measured_;
  std::shared_ptr<Tally> tally_;
  int n_threads_;
};

} // namespace asperity::methods
