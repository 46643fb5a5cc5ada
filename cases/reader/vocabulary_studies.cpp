#include "cases/reader/vocabulary.hpp"

namespace asperity::cases {
namespace {

constexpr const char* for_theory =
    "Optional; needs a [theory] whose spectrum is the formula.";

Key positive_number(const std::string& name, const std::string& example,
                    const std::string& description) {
  return {.name = name,
          .range = positive(),
          .need = Need::always,
          .example = example,
          .show = Show::no,
          .description = description};
}

Key points_key(const std::string& description) {
  return {.name = "points",
          .type = ValueType::integer,
          .range = between(2, 10000),
          .need = Need::always,
          .example = "120",
          .show = Show::no,
          .description = description};
}

Table magnification_table() {
  return {.name = "magnification",
          .when = for_theory,
          .description =
              "The contact at magnifications zeta = q/q_ref, Eqs. (23) to (28) "
              "of Yang and Persson (2008): area, separation, and the "
              "separation where contact is lost.",
          .keys = {
              {.name = "nominal_pressure",
               .type = ValueType::program,
               .dimension = Dimension::pressure,
               .range = positive(),
               .references = {mechanics::ReferenceUnit::contact_modulus},
               .need = Need::always,
               .example = "[\"1 MPa\", \"10 MPa\"]",
               .show = Show::no,
               .description = "Loads at which the contact is evaluated."},
              positive_number("from", "1.0", "Lowest magnification."),
              positive_number("to", "100.0", "Highest magnification."),
              points_key("Number of magnifications, at equal ratios."),
              {.name = "reference_wavevector",
               .dimension = Dimension::wavevector,
               .range = positive(),
               .when = "default: the roll-off of a self-affine surface; needed "
                       "for other kinds, or reference_wavelength",
               .example = "6.283e5",
               .show = Show::no,
               .description = "q_ref, the wavevector at which zeta = 1."},
              {.name = "reference_wavelength",
               .dimension = Dimension::length,
               .range = positive(),
               .references = {mechanics::ReferenceUnit::length},
               .when = "instead of reference_wavevector",
               .example = "\"1 length\"",
               .show = Show::no,
               .description = "Reference wavelength 2 pi/q_ref."},
          }};
}

Table leak_table() {
  return {.name = "magnification.leak",
          .when = "Optional.",
          .description =
              "Leakage of a sealed fluid, an estimate: the flow through the "
              "one pore at which the open area percolates.",
          .keys = {
              {.name = "density",
               .dimension = Dimension::density,
               .range = at_least(0.0),
               .need = Need::always,
               .example = "\"1000 kg/m^3\"",
               .show = Show::no,
               .description = "Density of the fluid."},
              {.name = "viscosity",
               .dimension = Dimension::viscosity,
               .range = positive(),
               .need = Need::always,
               .example = "\"1 mPa s\"",
               .show = Show::no,
               .description = "Viscosity of the fluid."},
              {.name = "pressure_drop",
               .dimension = Dimension::pressure,
               .range = at_least(0.0),
               .need = Need::always,
               .example = "\"10 kPa\"",
               .show = Show::no,
               .description = "Pressure drop across the seal."},
              {.name = "critical_area",
               .range = inside(0.0, 1.0),
               .when = "default: 1 minus the threshold of site percolation on "
                       "the square lattice",
               .example = "0.42",
               .show = Show::no,
               .description = "A/A_0 at which the open area percolates."},
          }};
}

Table adhesion_table() {
  return {
      .name = "adhesion",
      .when = for_theory,
      .description =
          "Rough contact held by adhesion alone, Sec. 9 of Yang and Persson "
          "(2008), on the case's surface with all heights scaled.",
      .keys = {
          {.name = "work_of_adhesion",
           .dimension = Dimension::energy_per_area,
           .range = positive(),
           .need = Need::always,
           .example = "\"0.1 J/m^2\"",
           .show = Show::no,
           .description = "Work of adhesion Delta gamma of flat surfaces."},
          positive_number("from", "0.5",
                          "Lowest ratio of h_rms to that of the case."),
          positive_number("to", "1.5", "Highest ratio."),
          points_key("Number of ratios, at equal differences."),
          {.name = "detachment_factor",
           .range = positive(),
           .when =
               "default: 2/pi, which reproduces the transition of the paper",
           .example = "0.64",
           .show = Show::no,
           .description = "Factor c of the stress that detaches a contact, "
                          "sigma_a^2 = c E* gamma_eff q; not in the paper."},
          {.name = "sphere_radius",
           .dimension = Dimension::length,
           .range = positive(),
           .when = "default: no pull-off force",
           .example = "\"1 mm\"",
           .show = Show::no,
           .description = "Radius of a sphere on the surface, for its pull-off "
                          "force (3 pi/2) R gamma_eff."},
          {.name = "steps",
           .type = ValueType::integer,
           .range = between(10, 100000),
           .fallback = "400",
           .example = "400",
           .show = Show::no,
           .description = "Steps of the discretisation between the longest and "
                          "the shortest wavelength; second order."},
      }};
}

} // namespace

Table case_sweep_table() {
  return {
      .name = "sweep",
      .when = "Optional.",
      .description =
          "Parameter sweep: this file describes many cases, its points "
          "(docs/reference/sweeps.md). Every other key names a key of the case "
          "with its table, in quotes, and lists its values: "
          "\"surface.hurst\" = [0.5, 0.7, 0.9].",
      .keys = {
          {.name = "combine",
           .type = ValueType::word,
           .words = {"product", "zip"},
           .fallback = "\"product\"",
           .example = "\"product\"",
           .show = Show::no,
           .description = "Points: every value of each key with every value of "
                          "the others, or the lists side by side."},
      }};
}

std::vector<Table> study_tables() {
  return {magnification_table(), leak_table(), adhesion_table()};
}

} // namespace asperity::cases
