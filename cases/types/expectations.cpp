#include "cases/types/expectations.hpp"

#include "cases/types/quantity_at_load.hpp"

namespace asperity::cases {

const std::vector<ExpectationName>& expectation_names() {
  using enum SurfaceKind;
  static const std::vector<ExpectationName> names = {
      {.name = "gamma_slope",
       .description = "u_0 / h_rms of p ~ exp(-u / u_0), from ln p against u "
                      "[1].",
       .theory_answers = true},
      {.name = "gamma_theory",
       .description = "The parameter of (10) with which theory fits the "
                      "method's u(p) best [1]."},
      {.name = "beta",
       .description = "p / E* that the exponential u(p) has at u = 0 [1].",
       .theory_answers = true},
      {.name = "kappa",
       .description = "Slope of the area fraction at light load, against "
                      "p / (E* rms slope) [1].",
       .theory_answers = true},
      {.name = "area_excess",
       .description = "Counted area over theory's at light load, minus 1 [1].",
       .needs_theory = true},
      {.name = "area_scale",
       .description = "Least-squares factor from theory's A(p) to the counted "
                      "one, over all loads [1].",
       .needs_theory = true},
      {.name = "area_scale_corrected",
       .description = "Least-squares factor from theory's A(p) to the "
                      "corrected one, over all loads [1].",
       .needs_theory = true},
      {.name = "area_excess_fit",
       .description = "Area by (21) of the fitted pressure distribution over "
                      "theory's at light load, minus 1 [1].",
       .needs_theory = true},
      {.name = "area_excess_moment",
       .description = "Area by (21) of the pressures' second moment over "
                      "theory's at light load, minus 1 [1].",
       .needs_theory = true},
      {.name = "gap_deviation",
       .description = "Largest |u - u of theory| / h_rms where "
                      "0.3 < u / h_rms < 1.5 [1].",
       .needs_theory = true},
      {.name = "pressure_difference",
       .description = "Of a variant, \"md.explicit\": largest relative "
                      "difference of p at equal u to its method, \"md\" [1].",
       .variants_only = true},
      {.name = "mean_gap_error",
       .description = "Largest |mean gap - exact| / amplitude [1].",
       .surfaces = {wave_1d, wave_2d}},
      {.name = "area_error",
       .description = "Largest |corrected area fraction - exact| [1].",
       .surfaces = {wave_1d, wave_2d, sphere}},
      {.name = "contact_radius_error",
       .description = "Largest relative error of Hertz's contact radius [1].",
       .surfaces = {sphere}},
      {.name = "approach_error",
       .description = "Largest relative error of Hertz's approach [1].",
       .surfaces = {sphere}},
      {.name = "von_mises_error",
       .description = "Largest relative error of the strongest von Mises "
                      "stress under Hertz's contact; needs [report] "
                      "stress_inside [1].",
       .surfaces = {sphere}},
      {.name = "von_mises_depth_error",
       .description = "Largest relative error of its depth [1].",
       .surfaces = {sphere}},
      {.name = "penetration",
       .description = "Largest penetration / h_rms in the maps kept [1]."},
      {.name = "epsilon",
       .description = "eps of (16) with the case's gamma [1].",
       .theory_answers = true,
       .theory_only = true},
      {.name = "gap_pressure_dependence",
       .description = "Largest |u(zeta) / u'(zeta) - 1| of the two lightest "
                      "loads of [magnification], from twice the zeta on where "
                      "roughness begins [1].",
       .theory_answers = true,
       .theory_only = true,
       .study = Study::magnification},
      {.name = "adhesion_flip",
       .description = "h_rms / h_rms0 at which complete and partial contact "
                      "have one gamma_eff [1].",
       .theory_answers = true,
       .theory_only = true,
       .study = Study::adhesion},
      {.name = "adhesion_flip_area",
       .description = "A/A_0 of the partial contact at the flip [1].",
       .theory_answers = true,
       .theory_only = true,
       .study = Study::adhesion},
      {.name = "complete_contact_binding",
       .description = "gamma_eff / Delta gamma of complete contact on the "
                      "case's surface [1].",
       .theory_answers = true,
       .theory_only = true,
       .study = Study::adhesion},
      {.name = "iterations_max",
       .description = "Most iterations a step took [1]."},
  };
  return names;
}

const ExpectationName* expectation_called(const std::string& name) {
  const QuantityAtLoadReading reading = read_quantity_at_load(name);
  const auto& known = !reading.at_load ? expectation_names()
                      : reading.at_load->magnification
                          ? quantities_at_magnification()
                          : quantities_at_load();
  const std::string& sought =
      reading.at_load ? reading.at_load->quantity : name;
  for (const ExpectationName& entry : known)
    if (entry.name == sought)
      return &entry;
  return nullptr;
}

} // namespace asperity::cases
