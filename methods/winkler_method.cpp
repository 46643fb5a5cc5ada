#include "methods/winkler_method.hpp"

#include "contact/solvers/winkler.hpp"
#include "methods/curve_row.hpp"

#include <fmt/format.h>

namespace asperity::methods {
namespace {

class WinklerSolver final : public StepSolver {
public:
  WinklerSolver(double stiffness, const SurfaceOfCase& surface)
      : stiffness_(stiffness), surface_(surface) {}

  StepAnswer solve(const StepTarget& target) override {
    Observation observation;
    observation.resolves_boundary = false; // each node has its part of the area
    StepAnswer answer =
        observe(contact::winkler_contact(surface_.record.heights, stiffness_,
                                         target.load),
                observation, surface_);
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
