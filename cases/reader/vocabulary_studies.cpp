// The rows of the studies and of [sweep].
#include "cases/reader/bound_key.hpp"

namespace asperity::cases {
namespace {

using Magnification = MagnificationStudy;
using Adhesion = AdhesionStudy;
using Leak = LeakStudy;
using Flow = FlowStudy;
using Friction = FrictionStudy;
using Spots = SpotsStudy;
using Conductance = ConductanceStudy;

constexpr const char* for_theory =
    "Optional; needs a [theory] whose spectrum is the formula.";
constexpr const char* for_theory_or_map =
    "Optional; needs a [theory] whose spectrum is the formula, or a measured "
    "map.";

Table magnification_table() {
  return {
      .name = "magnification",
      .when = for_theory_or_map,
      .description = "The contact at magnifications zeta = q/q_ref, Eqs. (23) "
                     "to (28) of Yang and Persson (2008): area, separation, "
                     "and the separation where contact is lost.",
      .keys = {
          key<&Magnification::nominal_pressures>(
              "nominal_pressure",
              {Dimension::pressure,
               positive(),
               {mechanics::ReferenceUnit::contact_modulus}},
              "Loads at which the contact is evaluated.",
              needed("[\"1 MPa\", \"10 MPa\"]")),
          key<&Magnification::from>("from", positive(), "Lowest magnification.",
                                    needed("1.0")),
          key<&Magnification::to>("to", positive(), "Highest magnification.",
                                  needed("100.0")),
          key<&Magnification::points>(
              "points", between(2, 10000),
              "Number of magnifications, at equal ratios.", needed("120")),
          key<&Magnification::reference_wavevector>(
              "reference_wavevector", Dimension::wavevector,
              "q_ref, the wavevector at which zeta = 1.",
              eg("6.283e5", "default: the roll-off of a self-affine surface; "
                            "needed for other kinds, or reference_wavelength")),
          key("reference_wavelength",
              {Dimension::length,
               positive(),
               {mechanics::ReferenceUnit::length}},
              "Reference wavelength 2 pi/q_ref.",
              eg("1 length", "instead of reference_wavevector")),
      }};
}

Table leak_table() {
  return {
      .name = "magnification.leak",
      .when = "Optional.",
      .description = "Leakage of a sealed fluid, an estimate: the flow through "
                     "the one pore at which the open area percolates.",
      .keys = {
          key<&Leak::density>("density", {Dimension::density, at_least(0.0)},
                              "Density of the fluid.", needed("1000 kg/m^3")),
          key<&Leak::viscosity>("viscosity", Dimension::viscosity,
                                "Viscosity of the fluid.", needed("1 mPa s")),
          key<&Leak::pressure_drop>(
              "pressure_drop", {Dimension::pressure, at_least(0.0)},
              "Pressure drop across the seal.", needed("10 kPa")),
          key<&Leak::critical_area>(
              "critical_area", inside(0.0, 1.0),
              "A/A_0 at which the open area percolates.",
              eg("0.42", "default: 1 minus the threshold of site percolation "
                         "on the square lattice")),
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
          key<&Adhesion::work_of_adhesion>(
              "work_of_adhesion", Dimension::energy_per_area,
              "Work of adhesion Delta gamma of flat surfaces.",
              needed("0.1 J/m^2")),
          key<&Adhesion::from>("from", positive(),
                               "Lowest ratio of h_rms to that of the case.",
                               needed("0.5")),
          key<&Adhesion::to>("to", positive(), "Highest ratio.", needed("1.5")),
          key<&Adhesion::points>("points", between(2, 10000),
                                 "Number of ratios, at equal differences.",
                                 needed("120")),
          key<&Adhesion::detachment_factor>(
              "detachment_factor", positive(),
              "Factor c of the stress that detaches a contact, sigma_a^2 = c "
              "E* gamma_eff q; not in the paper.",
              eg("0.64", "default: 2/pi, which reproduces the transition of "
                         "the paper")),
          key<&Adhesion::sphere_radius>(
              "sphere_radius", Dimension::length,
              "Radius of a sphere on the surface, for its pull-off force (3 "
              "pi/2) R gamma_eff.",
              eg("1 mm", "default: no pull-off force")),
          key<&Adhesion::steps>(
              "steps", between(10, 100000),
              "Steps of the discretisation between the longest and the "
              "shortest wavelength; second order."),
      }};
}

Table flow_table() {
  return {
      .name = "flow",
      .when = "Optional; needs a method with a gap.",
      .description =
          "The flow of a fluid through the gap of each load step, by Reynolds' "
          "equation (docs/numerics/flow.md), along x and along y.",
      .keys = {
          key<&Flow::viscosity>("viscosity", Dimension::viscosity,
                                "Viscosity of the fluid.", needed("1 mPa s")),
          key<&Flow::pressure_drop>(
              "pressure_drop", {Dimension::pressure, at_least(0.0)},
              "Pressure drop across the seal.", needed("10 kPa")),
          key<&Flow::length>("length", Dimension::length,
                             "Length of the seal along the flow.",
                             eg("5 mm", "default: that of a square")),
          key<&Flow::width>("width", Dimension::length,
                            "Width of the seal across the flow.",
                            eg("100 mm", "default: that of a square")),
      }};
}

Table friction_table() {
  return {
      .name = "friction",
      .when = "Optional; needs a [theory] or a [halfspace] without thickness, "
              "adhesion and hardness, and material.poisson_ratio.",
      .description =
          "Partial slip under a normal load and tangential loads up to "
          "sliding, from the lighter normal loads of the case "
          "(docs/numerics/friction.md).",
      .keys = {
          key<&Friction::coefficient>("coefficient", positive(),
                                      "Coefficient of friction mu.",
                                      needed("0.5")),
          key<&Friction::normal_load>(
              "normal_load",
              {Dimension::pressure,
               positive(),
               {mechanics::ReferenceUnit::contact_modulus,
                mechanics::ReferenceUnit::contact_modulus_times_slope}},
              "Normal load P over the nominal area. It becomes a load step, "
              "unless it is one.",
              eg("10 MPa", "default: the largest load")),
          key<&Friction::tangential_loads>(
              "tangential_load", inside(0.0, 1.0),
              "Tangential loads Q over that of sliding mu P. Each adds the "
              "load step P - Q/mu, unless the case has it.",
              eg("[0.5, 0.9]",
                 "default: those that belong to the loads of the case")),
      }};
}

Table spots_table() {
  return {
      .name = "spots",
      .when = "Optional; needs a method with a contact map.",
      .description =
          "The spots of contact of each load step, and the connected parts of "
          "its gap (docs/numerics/conductance.md): their number, the largest, "
          "whether they percolate, and the dimension by area and perimeter.",
      .keys = {
          key<&Spots::smallest>(
              "smallest", between(1, 1000000),
              "Nodes of the smallest cluster that counts in a dimension."),
      }};
}

template <auto member>
Key conductivity_key(const char* name, const char* description,
                     const char* example) {
  return key<member>(name, Dimension::thermal_conductivity, description,
                     eg(example, "default: no thermal_conductance"));
}

template <auto member>
Key resistivity_key(const char* name, const char* description,
                    const char* example) {
  return key<member>(name, Dimension::resistivity, description,
                     eg(example, "default: no electrical_conductance"));
}

Table conductance_table() {
  return {
      .name = "conductance",
      .when = "Optional; needs a method with a contact map.",
      .description =
          "Heat and current through the spots of contact of each load step, "
          "and the incremental normal stiffness of the contact "
          "(docs/numerics/conductance.md).",
      .keys = {
          conductivity_key<&Conductance::thermal_conductivity>(
              "thermal_conductivity", "Thermal conductivity of the block.",
              "0.2 W/(m K)"),
          conductivity_key<&Conductance::counter_thermal_conductivity>(
              "counter_thermal_conductivity",
              "Thermal conductivity of the body on it, also of a rigid one.",
              "16 W/(m K)"),
          resistivity_key<&Conductance::resistivity>(
              "resistivity", "Electrical resistivity of the block.",
              "17 nOhm m"),
          resistivity_key<&Conductance::counter_resistivity>(
              "counter_resistivity",
              "Electrical resistivity of the body on it, also of a rigid one.",
              "24 nOhm m"),
          key<&Conductance::gap_conductivity>(
              "gap_conductivity", Dimension::thermal_conductivity,
              "Thermal conductivity of the medium in the gap.",
              eg("0.026 W/(m K)", "default: no heat through the gap")),
          key<&Conductance::smallest_gap>(
              "smallest_gap", Dimension::length,
              "Gap below which the medium conducts no better, such as the mean "
              "free path of a gas; required with gap_conductivity.",
              eg("70 nm", "default: no heat through the gap")),
      }};
}

} // namespace

Table case_sweep_table() {
  return {.name = "sweep",
          .when = "Optional.",
          .description =
              "Parameter sweep: this file describes many cases, its points "
              "(docs/reference/sweeps.md). Every other key names a key of the "
              "case with its table, in quotes, and lists its values: "
              "\"surface.hurst\" = [0.5, 0.7, 0.9].",
          .keys = {
              key("combine", {"product", "zip"},
                  "Points: every value of each key with every value of the "
                  "others, or the lists side by side.",
                  or_else("\"product\"")),
          }};
}

std::vector<Table> study_tables() {
  return {magnification_table(), leak_table(),  adhesion_table(),
          flow_table(),          spots_table(), conductance_table(),
          friction_table()};
}

} // namespace asperity::cases
