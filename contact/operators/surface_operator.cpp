#include "contact/operators/surface_operator.hpp"

#include "base/cpu_clock.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace asperity::contact {

template <class Work>
void SurfaceOperator::measured(const Work& work) {
  if (!cpu_time_) {
    work();
    return;
  }
  const CpuClock clock(threads());
  work();
  *cpu_time_ += clock.seconds();
}

void SurfaceOperator::displacement(std::span<const double> pressure,
                                   std::span<double> displacement,
                                   std::span<std::byte> lent) {
  lent_ = lent;
  measured([&] { do_displacement(pressure, displacement); });
}

void SurfaceOperator::displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change, std::span<std::byte> lent) {
  lent_ = lent;
  measured(
      [&] { do_displacement_change(pressure_change, displacement_change); });
}

void SurfaceOperator::pressure_estimate(std::span<const float> gap,
                                        double local_compliance,
                                        std::span<float> pressure) {
  measured([&] { do_pressure_estimate(gap, local_compliance, pressure); });
}

void SurfaceOperator::pressure_of(std::span<const double> displacement,
                                  std::span<double> pressure) {
  measured([&] { do_pressure_of(displacement, pressure); });
}

void SurfaceOperator::do_displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change) {
  const std::vector<double> pressure(pressure_change.begin(),
                                     pressure_change.end());
  std::vector<double> displaced(pressure.size());
  do_displacement(pressure, displaced);
  std::ranges::transform(
      displaced, displacement_change.begin(),
      [](double displacement) { return static_cast<float>(displacement); });
}

void SurfaceOperator::do_pressure_estimate(std::span<const float> gap,
                                           double local_compliance,
                                           std::span<float> pressure) {
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  const auto stiffness =
      static_cast<float>(1.0 / (short_wave_compliance() + local_compliance));
  std::ranges::transform(gap, pressure.begin(),
                         [=](float own) { return stiffness * own; });
}

void SurfaceOperator::do_pressure_of(std::span<const double> /*displacement*/,
                                     std::span<double> /*pressure*/) {
  throw std::logic_error("this surface operator has no exact inverse");
}

} // namespace asperity::contact
