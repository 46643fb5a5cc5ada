#include "methods/timed_operator.hpp"

#include "base/cpu_clock.hpp"

#include <utility>

namespace asperity::methods {

TimedOperator::TimedOperator(std::unique_ptr<contact::SurfaceOperator> measured,
                             std::shared_ptr<Tally> tally, int n_threads)
    : measured_(std::move(measured)),
      tally_(std::move(tally)),
      n_threads_(n_threads) {}

std::unique_ptr<contact::SurfaceOperator> TimedOperator::clone() const {
  return timed(measured_->clone());
}

const Grid& TimedOperator::grid() const {
  return measured_->grid();
}

const SharedRows* TimedOperator::shared_rows() const {
  return measured_->shared_rows();
}

std::span<const double> TimedOperator::nodal_weights() const {
  return measured_->nodal_weights();
}

void TimedOperator::displacement(std::span<const double> pressure,
                                 std::span<double> displacement) {
  const CpuClock clock(n_threads_);
  measured_->displacement(pressure, displacement);
  tally_->cpu_time += clock.seconds();
}

void TimedOperator::displacement_change(std::span<const float> pressure_change,
                                        std::span<float> displacement_change) {
  const CpuClock clock(n_threads_);
  measured_->displacement_change(pressure_change, displacement_change);
  tally_->cpu_time += clock.seconds();
}

void TimedOperator::pressure_estimate(std::span<const float> gap,
                                      double local_compliance,
                                      std::span<float> pressure) {
  const CpuClock clock(n_threads_);
  measured_->pressure_estimate(gap, local_compliance, pressure);
  tally_->cpu_time += clock.seconds();
}

bool TimedOperator::has_inverse() const {
  return measured_->has_inverse();
}

void TimedOperator::pressure_of(std::span<const double> displacement,
                                std::span<double> pressure) {
  const CpuClock clock(n_threads_);
  measured_->pressure_of(displacement, pressure);
  tally_->cpu_time += clock.seconds();
}

const Grid& TimedOperator::wide_grid() const {
  return measured_->wide_grid();
}

void TimedOperator::wide_pressure_estimate(std::span<const float> gap,
                                           double local_compliance,
                                           std::span<float> pressure) {
  const CpuClock clock(n_threads_);
  measured_->wide_pressure_estimate(gap, local_compliance, pressure);
  tally_->cpu_time += clock.seconds();
}

double TimedOperator::short_wave_compliance() const {
  return measured_->short_wave_compliance();
}

bool TimedOperator::is_periodic() const {
  return measured_->is_periodic();
}

bool TimedOperator::is_shift_invariant() const {
  return measured_->is_shift_invariant();
}

int TimedOperator::threads() const {
  return measured_->threads();
}

std::unique_ptr<contact::SurfaceOperator>
TimedOperator::timed(std::unique_ptr<contact::SurfaceOperator> other) const {
  if (!other)
    return nullptr;
  return std::make_unique<TimedOperator>(std::move(other), tally_, n_threads_);
}

std::unique_ptr<contact::SurfaceOperator> TimedOperator::coarsened() const {
  return timed(measured_->coarsened());
}

std::unique_ptr<contact::SurfaceOperator>
TimedOperator::periodic_extension() const {
  return timed(measured_->periodic_extension());
}

std::unique_ptr<contact::SurfaceOperator>
TimedOperator::on_tiles(const contact::Tiles& tiles) const {
  return timed(measured_->on_tiles(tiles));
}

} // namespace asperity::methods
