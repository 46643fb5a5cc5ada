#include "run/methods/winkler_method.hpp"

#include "contact/solvers/winkler.hpp"
#include "run/methods/curve_row.hpp"

#include <fmt/format.h>

namespace asperity::methods {
namespace {

/// Of sums over the nodes, which end the search.
constexpr double sum_accuracy = 1e-10;

class WinklerSolver final : public StepSolver {
public:
  WinklerSolver(double stiffness, const SurfaceOfCase& surface)
      : stiffness_(stiffness), surface_(surface) {}

  StepAnswer find(const StepTarget& target) override {
    Observation observation;
    observation.resolves_boundary = false; // each node has its part of the area
    contact::ContactSolution solution = contact::winkler_contact(
        surface_.record.heights, stiffness_, target.load);
    const Reached reached{
        .nominal_pressure = solution.nominal_pressure,
        .mean_gap = solution.mean_gap,
        .imbalance = 0.0, // each node has the pressure of its spring
        .pressure_tolerance = sum_accuracy * solution.nominal_pressure,
        .gap_tolerance = sum_accuracy * surface_.scales.rms_height};
    StepAnswer answer = observe(std::move(solution), observation, surface_);
    answer.reached = reached;
    answer.row.area_fraction_corrected = answer.row.area_fraction;
    return answer;
  }

private:
  double stiffness_; ///< [Pa/m]
  const SurfaceOfCase& surface_;
};

} // namespace

MethodDescription describe(const mechanics::WinklerSettings& settings) {
  const bool is_relative =
      settings.stiffness.reference ==
      mechanics::ReferenceUnit::contact_modulus_per_spacing;
  return {"winkler",
          fmt::format("Winkler foundation of stiffness {:g} {}, hard contact",
                      settings.stiffness.value, is_relative ? "E*/h" : "Pa/m"),
          false};
}

std::unique_ptr<StepSolver>
make_winkler_solver(const mechanics::WinklerSettings& settings,
                    const SurfaceOfCase& surface) {
  return std::make_unique<WinklerSolver>(
      settings.stiffness.in_si(surface.scales), surface);
}

} // namespace asperity::methods
