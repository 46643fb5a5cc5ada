#include "input/types/expectations.hpp"

#include "input/types/quantity_at_load.hpp"

#include <algorithm>

namespace asperity::cases {
namespace {

/// Quantities of the curves of rough surfaces.
std::vector<ExpectationName> rough_surface_names() {
  return {
      {.name = "gamma_slope",
       .description = "u_0 / h_rms of p ~ exp(-u / u_0), from the slope of ln "
                      "p against u [1].",
       .theory_answers = true},
      {.name = "gamma_matched",
       .description = "gamma of Eq. (10) of Yang and Persson (2008) with which "
                      "theory has the method's slope of u against ln p for 1 "
                      "<= u / h_rms <= 2 [1]."},
      {.name = "gamma_curve",
       .description = "gamma of Eq. (10) of Yang and Persson (2008) with which "
                      "theory best fits the method's u(p) up to 2 h_rms [1]."},
      {.name = "gamma_energy",
       .description = "gamma of Eq. (10) of Yang and Persson (2008) with which "
                      "theory has the method's elastic energy at light load "
                      "[1]."},
      {.name = "beta",
       .description = "p / E* of the exponential u(p) at u = 0 [1].",
       .theory_answers = true},
      {.name = "kappa",
       .description = "Area-load coefficient: slope of the area fraction at "
                      "light load, against p / (E* rms slope) [1].",
       .theory_answers = true},
      {.name = "area_excess",
       .description =
           "Counted area over that of theory at light load, minus 1 [1].",
       .needs_theory = true},
      {.name = "area_scale",
       .description = "Least-squares factor between theory's A(p) and the "
                      "counted area, over all loads [1].",
       .needs_theory = true},
      {.name = "area_scale_corrected",
       .description = "Least-squares factor between theory's A(p) and the "
                      "corrected area, over all loads [1].",
       .needs_theory = true},
      {.name = "area_excess_fit",
       .description = "Area by Eq. (21) of Yang and Persson (2008) from the "
                      "fitted pressure distribution, over that of theory at "
                      "light load, minus 1 [1].",
       .needs_theory = true},
      {.name = "area_excess_moment",
       .description =
           "Area by Eq. (21) of Yang and Persson (2008) from the second moment "
           "of the pressure, over that of theory at light load, minus 1 [1].",
       .needs_theory = true},
      {.name = "gap_deviation",
       .description = "Largest |u - u of theory| / h_rms for 0.3 < u / h_rms < "
                      "1.5, of any "
                      "realisation [1].",
       .needs_theory = true},
      {.name = "mean_gap_deviation",
       .description = "Largest |mean of u - u of theory| / h_rms for 0.3 < u / "
                      "h_rms < 1.5, with the mean over the realisations [1].",
       .needs_theory = true},
      {.name = "pressure_difference",
       .description = "Largest relative difference of p at equal u between a "
                      "variant, \"md.explicit\", and its method, \"md\" [1].",
       .variants_only = true},
  };
}

/// Quantities of the theory, and how far its laws are from the numbers.
std::vector<ExpectationName> law_names() {
  return {
      {.name = "epsilon",
       .description = "eps of Eq. (16) of Yang and Persson (2008) with the "
                      "case's gamma [1].",
       .theory_answers = true,
       .theory_only = true},
      {.name = "law_area_error",
       .description = "Root mean square over the loads of the relative "
                      "deviation of a theory's area from that of the first "
                      "other method, at 1 % <= A/A_0 <= 99 % [1].",
       .theory_answers = true,
       .theory_only = true},
      {.name = "law_energy_error",
       .description = "The same of the elastic energy [1].",
       .theory_answers = true,
       .theory_only = true},
      {.name = "law_gap_error",
       .description = "The same of u / h_rms, absolute, at 0 < u <= 2 h_rms "
                      "[1].",
       .theory_answers = true,
       .theory_only = true},
  };
}

/// Errors of a numerical solution.
std::vector<ExpectationName> error_names() {
  using enum mechanics::SurfaceKind;
  return {
      {.name = "mean_gap_error",
       .description = "Largest |mean gap - exact| / amplitude [1].",
       .surfaces = {wave_1d, wave_2d}},
      {.name = "area_error",
       .description = "Largest |corrected area fraction - exact| [1].",
       .surfaces = {wave_1d, wave_2d, sphere, cone, rounded_punch}},
      {.name = "contact_radius_error",
       .description = "Largest relative error of Hertz's contact radius, or of "
                      "that of the punch or cone, over loads whose contact "
                      "fits into the square [1].",
       .surfaces = {sphere, punch, cone, rounded_punch}},
      {.name = "approach_error",
       .description = "Largest relative error of Hertz's approach, or of that "
                      "of the punch or cone [1].",
       .surfaces = {sphere, punch, cone, rounded_punch}},
      {.name = "von_mises_error",
       .description = "Largest relative error of the maximum von Mises stress "
                      "of Hertz's contact; needs [report] stress_inside [1].",
       .surfaces = {sphere}},
      {.name = "von_mises_depth_error",
       .description =
           "Largest relative error of the depth of that maximum [1].",
       .surfaces = {sphere}},
      {.name = "normal_stiffness_error",
       .description = "Largest relative error of the normal stiffness of a "
                      "single contact, 2 E* a; needs [fem] stiffness [1].",
       .surfaces = {sphere, punch}},
      {.name = "tangential_stiffness_error",
       .description = "Largest relative error of Mindlin's tangential "
                      "stiffness, 8 a G/(2 - nu); needs [fem] stiffness [1].",
       .surfaces = {sphere, punch}},
      {.name = "moment_error",
       .description = "Largest relative error of the moment of a tilted punch "
                      "whose whole end is in contact [1].",
       .surfaces = {punch}},
      {.name = "penetration",
       .description = "Largest penetration / h_rms in the saved fields [1]."},
  };
}

/// Quantities of contact with adhesion.
std::vector<ExpectationName> adhesion_names() {
  return {
      {.name = "unloaded_area_approach",
       .description = "A/A_0 of the first state without load on the way in "
                      "[1]."},
      {.name = "unloaded_area_retraction",
       .description = "A/A_0 of the first state without load on the way out "
                      "[1]."},
      {.name = "unloaded_gap_approach",
       .description =
           "Mean gap / h_rms of the first state without load on the way in "
           "[1]."},
      {.name = "unloaded_gap_retraction",
       .description =
           "Mean gap / h_rms of the first state without load on the way out "
           "[1]."},
      {.name = "effective_work_approach",
       .description = "Work that separates the first state without load on the "
                      "way in, gamma_eff, over the work of adhesion [1]."},
      {.name = "effective_work_retraction",
       .description = "Work that separates the first state without load on the "
                      "way out, gamma_eff, over the work of adhesion [1]."},
      {.name = "pull_off_pressure",
       .description = "Largest tension -p / E* of the loading path, with "
                      "adhesion [1]."},
      {.name = "dissipated_energy",
       .description = "Work -sum p du of a loading path that ends at the gap "
                      "where it began, over the work of adhesion [1]."},
      {.name = "adhesive_difference",
       .description = "Largest |p - p of the first method with adhesion| at "
                      "equal mean gap, over the largest tension of that "
                      "method; needs loads by mean gap [1]."},
      {.name = "adhesive_wave_error",
       .description = "Largest |p - p of adhesion without range (JKR)| at "
                      "equal contact area, over the pressure of full contact "
                      "without adhesion [1].",
       .surfaces = {mechanics::SurfaceKind::wave_1d}},
      {.name = "adhesive_sphere_error",
       .description = "Largest |p - p of Maugis (1992)| at equal contact "
                      "area, over the pull-off pressure of the latter; with "
                      "contact = \"dugdale\" [1].",
       .surfaces = {mechanics::SurfaceKind::sphere}},
  };
}

/// Quantities of curves at one load.
std::vector<ExpectationName> names_at_one_load() {
  return {
      {.name = "area_fraction",
       .description = "A/A_0 as counted; for theory, Eq. (4) of Yang and "
                      "Persson (2008) [1].",
       .theory_answers = true,
       .of = QuantityOf::load},
      {.name = "area_fraction_corrected",
       .description = "A/A_0, the best estimate of the method [1].",
       .theory_answers = true,
       .of = QuantityOf::load},
      {.name = "area_fraction_fit",
       .description = "A/A_0 by Eq. (21) of Yang and Persson (2008) from Eq. "
                      "(20) fitted to the pressure distribution [1].",
       .of = QuantityOf::load},
      {.name = "area_fraction_moment",
       .description = "A/A_0 by Eq. (21) of Yang and Persson (2008) from the "
                      "second moment of the pressure [1].",
       .of = QuantityOf::load},
      {.name = "area_excess",
       .description = "Counted area over that of theory, minus 1 [1].",
       .needs_theory = true,
       .of = QuantityOf::load},
      {.name = "area_excess_fit",
       .description = "Area by Eq. (21) of Yang and Persson (2008) from the "
                      "fit, over that of theory, minus 1 [1].",
       .needs_theory = true,
       .of = QuantityOf::load},
      {.name = "plastic_area",
       .description = "Area at the hardness; needs a hardness and a step at "
                      "this load [1].",
       .theory_answers = true,
       .of = QuantityOf::load},
      {.name = "reduced_mean_gap",
       .description = "u / h_rms [1].",
       .theory_answers = true,
       .of = QuantityOf::load},
  };
}

std::vector<ExpectationName> solver_names() {
  return {
      {.name = "iterations_max",
       .description = "Largest number of iterations of a step [1]."},
  };
}

std::vector<ExpectationName>& all_names() {
  static std::vector<ExpectationName> all = [] {
    std::vector<ExpectationName> known;
    for (const std::vector<ExpectationName>& names :
         {rough_surface_names(), law_names(), error_names(), adhesion_names(),
          names_at_one_load(), solver_names()})
      known.insert(known.end(), names.begin(), names.end());
    return known;
  }();
  return all;
}

} // namespace

std::vector<ExpectationName> expectation_names(QuantityOf of) {
  std::vector<ExpectationName> names = all_names();
  std::erase_if(names,
                [of](const ExpectationName& name) { return name.of != of; });
  return names;
}

void add_expectation(const ExpectationName& quantity) {
  all_names().push_back(quantity);
}

const ExpectationName* expectation_called(const std::string& name) {
  const std::optional<QuantityAtLoad> at_load =
      read_quantity_at_load(name).at_load;
  const QuantityOf of = !at_load                 ? QuantityOf::curve
                        : at_load->magnification ? QuantityOf::magnification
                                                 : QuantityOf::load;
  const std::string& sought = at_load ? at_load->quantity : name;
  const auto found =
      std::ranges::find_if(all_names(), [&](const ExpectationName& one) {
        return one.of == of && one.name == sought;
      });
  return found == all_names().end() ? nullptr : &*found;
}

} // namespace asperity::cases
