// Draws problems from a seed and an index, as the text of a case.
#include "base/require.hpp"
#include "input/input_error.hpp"
#include "input/reader/study_keys.hpp"
#include "input/types/case.hpp"
#include "mechanics/contact_law.hpp"
#include "suite/robustness/draft.hpp"
#include "suite/robustness/flaws.hpp"
#include "suite/robustness/shapes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

/// Lattice spacing of the block of atoms in Sec. 4 of Yang and Persson (2008)
/// [m].
constexpr double atom_spacing = 2.6e-10;

/// What has been drawn of a problem and decides on the rest.
struct Problem {
  std::string family;
  std::string method; ///< name of its table
  int points = 32;
  double length = 1.0;          ///< [m]
  double rms_slope = 0.1;       ///< [1]
  double contact_modulus = 1e9; ///< E* [Pa]
  double poisson_ratio = 0.3;
  double thickness = 1.0; ///< [length]
  int degree = 1;
  std::string law = "hard";
  std::string shape = "rough";
  std::string mesh = "layers";
  std::string counter = "none";
  double counter_radius = 0.4; ///< [length]
  std::string edges = "periodic";
  bool by_pressure = true;
  double load = 0.0;    ///< the first pressure [E* h'], or gap [h_rms]
  double tension = 0.0; ///< smallest pressure of a law with adhesion [Pa] <= 0

  bool is(std::initializer_list<const char*> families) const {
    return std::ranges::count(families, family) > 0;
  }

  bool has_elements() const {
    return is({"condensed-q1", "condensed-q2", "full-block"});
  }

  bool is_block() const { return family == "slab" || has_elements(); }

  /// With a contact law.
  bool is_continuum() const { return family == "halfspace" || is_block(); }

  bool is_adhesive() const { return tension < 0.0; }

  double spacing() const { return length / points; }
};

std::string family_of(const cases::MethodSpec& method) {
  if (const auto* half =
          std::get_if<mechanics::HalfspaceSettings>(&method.settings))
    return half->thickness ? "slab" : "halfspace";
  if (const auto* fem = std::get_if<mechanics::FemSettings>(&method.settings))
    return fem->solver == mechanics::FemSolver::full      ? "full-block"
           : fem->block.element == mechanics::Element::q1 ? "condensed-q1"
                                                          : "condensed-q2";
  return std::holds_alternative<mechanics::MdSettings>(method.settings)
             ? "atoms"
             : "theory";
}

void draw_family(Draft& draft, Problem& problem) {
  if (const Base* base = draft.base()) {
    problem.method = base->method;
    problem.family = family_of(*std::ranges::find(
        base->contact_case.methods, base->method, &cases::MethodSpec::name));
    draft.label("family", problem.family);
    return;
  }
  problem.family = draft.word("family", {{"halfspace", 25.0},
                                         {"slab", 21.0},
                                         {"condensed-q1", 16.0},
                                         {"condensed-q2", 14.0},
                                         {"full-block", 2.0},
                                         {"atoms", 1.0},
                                         {"theory", 11.0},
                                         {"flawed", 10.0}});
  if (problem.family == "flawed") {
    const std::string flaw = draft.word("flaw", equally(flaw_names()));
    problem.family = needs_elements(flaw) ? "condensed-q2"
                     : draft.coin("flawed method") || needs_block(flaw)
                         ? "slab"
                         : "halfspace";
  }
  problem.method = problem.has_elements()       ? "fem"
                   : problem.family == "atoms"  ? "md"
                   : problem.family == "theory" ? "theory"
                                                : "halfspace";
}

/// The mesh and the counter-body of a full block, which restrict its size.
void draw_bodies(Draft& draft, Problem& problem) {
  if (problem.family != "full-block" || draft.base() != nullptr)
    return;
  problem.degree =
      draft.word("element", {{"Q1", 1.0}, {"Q2", 1.0}}) == "Q1" ? 1 : 2;
  problem.counter = draft.word(
      "counter-body",
      {{"none", 7.0}, {"sphere", 1.0}, {"cylinder", 1.0}, {"cuboid", 1.0}});
  const bool is_alone = problem.counter == "none";
  problem.mesh = draft.word("mesh", {{"layers", 4.0},
                                     {"hanging", 2.0},
                                     {"adaptive", is_alone ? 2.0 : 0.0},
                                     {"gmsh", 2.0}});
  problem.counter_radius = draft.uniform("counter_radius", 0.25, 0.45);
}

/// Full blocks are small, so that a direct solver takes seconds: second-order
/// cells of gmsh have some ten times as many unknowns as graded layers. A cell
/// fits into the fine region of a ball, which has at most 0.4 R.
void draw_points(Draft& draft, Problem& problem) {
  if (!problem.is({"full-block", "atoms"})) {
    problem.points = std::stoi(
        draft.word("points", equally({"8", "16", "24", "32", "48", "64"})));
    return;
  }
  const bool is_ball = problem.counter == "sphere";
  if (is_ball && problem.mesh == "gmsh")
    draft.label("element", "Q1");
  problem.degree = draft.has_label("element", "Q2") ? 2 : 1;
  const bool is_gmsh2 = problem.mesh == "gmsh" && problem.degree == 2;
  problem.points = is_ball && problem.degree == 2                        ? 16
                   : is_gmsh2 || draft.uniform("points", 0.0, 6.0) < 5.0 ? 8
                                                                         : 16;
  draft.label("points", std::to_string(problem.points));
  if (is_ball)
    problem.counter_radius = std::max(problem.counter_radius,
                                      2.75 * problem.degree / problem.points);
}

void draw_scales(Draft& draft, Problem& problem) {
  const bool is_atoms = problem.family == "atoms";
  problem.length = is_atoms ? problem.points * atom_spacing
                            : draft.number("length", 1e-12, 1e6);
  problem.rms_slope = is_atoms ? draft.number("rms-slope", 1e-3, 0.2)
                               : draft.number("rms-slope", 1e-6, 10.0);
  problem.contact_modulus = is_atoms ? draft.number("modulus", 1e10, 1e11)
                                     : draft.number("modulus", 1.0, 1e12);
  if (problem.counter == "sphere") // a paraboloid of its radius
    problem.rms_slope = 1.0 / (std::sqrt(6.0) * problem.counter_radius);
  if (!problem.is_block() && !is_atoms)
    return;
  std::string ratio = draft.word("nu", {{"0", 1.0},
                                        {"0.3", 1.0},
                                        {"0.49", 1.0},
                                        {"0.4999", is_atoms ? 0.0 : 1.0}});
  problem.poisson_ratio = std::stod(ratio);
}

/// Half of the finite-element blocks have a coating of 0.05 to 20 times the
/// modulus, full blocks of 1e-3 to 1e3 times.
std::string coating(Draft& draft, const Problem& problem,
                    double youngs_modulus) {
  if (!problem.has_elements())
    return "";
  const double most = problem.family == "full-block" ? 1e3 : 20.0;
  const double stiffness =
      draft.coin("coating")
          ? draft.log_uniform("coating_stiffness", 1.0 / most, most)
          : 1.0;
  draft.label("coating", stiffness < 1.0   ? "softer"
                         : stiffness > 1.0 ? "stiffer"
                                           : "none");
  return stiffness == 1.0
             ? ""
             : fmt::format(
                   ", layers = [{{ thickness = {}, youngs_modulus = {}, "
                   "poisson_ratio = {} }}]",
                   quantity(draft.uniform("coating_thickness", 0.02, 0.5) *
                                problem.thickness,
                            "length"),
                   draft.pressure(stiffness * youngs_modulus),
                   problem.poisson_ratio);
}

/// The moduli of half of the full blocks differ from cell to cell. A wave much
/// shorter than a cell is as good as random numbers.
std::string variation(Draft& draft, const Problem& problem) {
  if (problem.family != "full-block" || draft.base() != nullptr)
    return "";
  const double ratio =
      draft.coin("variation") ? draft.number("modulus-ratio", 1.0, 1e3) : 1.0;
  draft.label("modulus-ratio", bin_of("modulus-ratio", ratio));
  return ratio == 1.0
             ? ""
             : fmt::format(", variation = {{ kind = \"function\", factor = "
                           "\"exp({:.17g} * sin(997 * x + 1317 * y + 733 * z + "
                           "{}))\" }}",
                           std::log(ratio), draft.index());
}

void draw_material(Draft& draft, const Problem& problem) {
  const double youngs_modulus =
      problem.contact_modulus *
      (1.0 - problem.poisson_ratio * problem.poisson_ratio);
  std::string table = fmt::format(
      "{{ {} = {}, poisson_ratio = {}",
      problem.counter == "none" ? "contact_modulus" : "youngs_modulus",
      draft.pressure(problem.counter == "none" ? problem.contact_modulus
                                               : youngs_modulus),
      problem.poisson_ratio);
  table += coating(draft, problem, youngs_modulus);
  table += variation(draft, problem);
  if (problem.counter != "none")
    table += fmt::format(
        ", counter = {{ youngs_modulus = {}, poisson_ratio = 0.3 }}",
        draft.pressure(draft.log_uniform("counter_stiffness", 1e-2, 1e2) *
                       problem.contact_modulus * (1.0 - 0.09)));
  draft.set("modulus", "material", table + " }");
}

/// The cells of the surface layer are cubic or, in a thin block, half as high
/// as it.
void draw_block(Draft& draft, Problem& problem) {
  if (!problem.is_block())
    return;
  const std::string table = problem.method + ".";
  problem.thickness = draft.log_uniform("thickness", 0.01, 10.0);
  const bool is_full = problem.family == "full-block";
  if (is_full) {
    const bool is_gmsh = problem.mesh == "gmsh";
    const double thickest = is_gmsh && problem.degree == 2 ? 0.6
                            : problem.points == 8          ? 2.0
                                                           : 0.5;
    problem.thickness =
        std::clamp(problem.thickness, is_gmsh ? 4.0 / problem.points : 0.1,
                   problem.mesh == "adaptive" ? 0.5 * thickest : thickest);
  }
  draft.label("thickness", bin_of("thickness", problem.thickness));
  draft.set("thickness",
            table + (problem.has_elements() ? "depth" : "thickness"),
            quantity(problem.thickness, "length"));
  const bool has_counter = problem.counter != "none";
  draft.set(
      "top", table + "top",
      in_quotes(draft.word("top", {{"clamped", 1.0},
                                   {"sliding", 1.0},
                                   {"pressure", has_counter ? 0.0 : 1.0}})));
  if (!problem.has_elements())
    return;
  const double growth =
      std::max(is_full ? 1.5 : 1.0, draft.uniform("growth", 0.8, 3.0));
  draft.label("growth", bin_of("growth", growth));
  draft.set("growth", table + "growth", number(growth));
  if (draft.base() != nullptr)
    return;
  if (!is_full)
    problem.degree = problem.family == "condensed-q1" ? 1 : 2;
  draft.set(table + "element", in_quotes(fmt::format("Q{}", problem.degree)));
  draft.set(table + "solver", in_quotes(is_full ? "full" : "condensed"));
  draft.set(table + "surface_cell_depth",
            number(std::min(1.0, 0.5 * problem.thickness * problem.points /
                                     problem.degree)));
}

void draw_counter(Draft& draft, const Problem& problem) {
  if (problem.counter == "none")
    return;
  draft.set("fem.bodies", "2");
  draft.set("mesh.counter.shape", in_quotes(problem.counter));
  draft.set("mesh.counter.size_far", quantity(2.0, "h"));
  if (problem.counter == "sphere")
    draft.set("mesh.counter.fine_radius",
              quantity(0.399 * problem.counter_radius, "length"));
  else
    draft.set("mesh.counter.radius",
              quantity(problem.counter_radius, "length"));
}

/// What only full blocks have.
void draw_full_block(Draft& draft, const Problem& problem) {
  if (problem.family != "full-block" || draft.base() != nullptr)
    return;
  draft.set("mesh.kind", in_quotes(problem.mesh));
  if (problem.mesh == "adaptive")
    draft.set("mesh.halvings", problem.points == 8 ? "1" : "2");
  if (problem.mesh == "gmsh") {
    draft.set("mesh.geometry", in_quotes("block"));
    draft.set("mesh.size_far", quantity(2.0, "h"));
  }
  draw_counter(draft, problem);
  draft.set("fem.sides",
            in_quotes(draft.word(
                "sides",
                {{"periodic", 1.0},
                 {"free", draft.has_label("top", "pressure") ? 0.0 : 1.0}})));
  draft.set("fem.linear_solver",
            in_quotes(draft.word(
                "linear-solver",
                {{"auto", 1.0},
                 {"multigrid", problem.poisson_ratio > 0.49 ? 0.0 : 1.0}})));
}

/// The share of a law without adhesion. Two bodies need springs.
double weight_of(const mechanics::ContactLawTraits& law,
                 const Problem& problem) {
  switch (law.block_solver) {
  case mechanics::BlockSolver::wall:
    return problem.counter == "none" ? 3.0 : 0.0;
  case mechanics::BlockSolver::springs:
    return law.has_wall ? 2.0 : 4.0;
  case mechanics::BlockSolver::none:
    break;
  }
  return problem.family == "full-block" ? 0.0 : 2.0;
}

std::vector<std::pair<std::string, double>> laws(const Draft& draft,
                                                 const Problem& problem) {
  const bool may_stick = draft.base() == nullptr &&
                         !draft.has_label("family", "flawed") &&
                         problem.is({"halfspace", "slab", "condensed-q1"});
  std::vector<std::pair<std::string, double>> weighted;
  for (const mechanics::ContactLawTraits& law : mechanics::contact_laws())
    if (!mechanics::is_adhesive(law.law))
      weighted.emplace_back(law.name, weight_of(law, problem));
    else if (may_stick)
      weighted.emplace_back(law.name, 9.0 / 24.0);
  return weighted;
}

/// Work and range of an adhesion. The energy of conformity of a wave of slope
/// h' and four spacings is E* h'^2 lambda/(16 pi).
void draw_adhesion(Draft& draft, Problem& problem,
                   const mechanics::ContactLawTraits& law) {
  const double work = draft.log_uniform("adhesion", 1e-3, 10.0) *
                      problem.contact_modulus * problem.rms_slope *
                      problem.rms_slope * 4.0 * problem.spacing() /
                      (16.0 * std::numbers::pi);
  mechanics::ContactInterface contact =
      mechanics::ContactSettings{.law = law.law, .work_of_adhesion = work}
          .in_si({.contact_modulus = problem.contact_modulus,
                  .spacing = problem.spacing()});
  contact.adhesion_range *=
      std::sqrt(mechanics::accurate_grid_number /
                draft.log_uniform("grid_number", 1e-3, 1.0));
  problem.tension = contact.pressure_bounds().smallest;
  draft.set(problem.method + ".work_of_adhesion", draft.energy(work));
  draft.set(problem.method + ".range", draft.length(contact.adhesion_range));
}

/// A number of E*/h in a case goes up to 1e9.
void draw_penalty(Draft& draft, const Problem& problem) {
  const bool is_absolute = draft.base() == nullptr;
  const double penalty =
      draft.number("penalty", 1e-6, is_absolute ? 1e15 : 1e9);
  draft.set("law", problem.method + ".penalty",
            is_absolute ? draft.stiffness(penalty * problem.contact_modulus /
                                          problem.spacing())
                        : quantity(penalty, "E*/h"));
}

void draw_contact(Draft& draft, Problem& problem) {
  if (!problem.is_continuum())
    return;
  problem.law = draft.word("law", laws(draft, problem));
  const auto law = *std::ranges::find(mechanics::contact_laws(), problem.law,
                                      &mechanics::ContactLawTraits::name);
  draft.set("law", problem.method + ".contact", in_quotes(problem.law));
  if (law.needs_penalty)
    draw_penalty(draft, problem);
  if (mechanics::is_adhesive(law.law))
    draw_adhesion(draft, problem, law);
}

void draw_atoms(Draft& draft, const Problem& problem) {
  if (problem.family != "atoms" || draft.base() != nullptr)
    return;
  // Values of Sec. 4 of Yang and Persson (2008). A block of atoms has intrinsic
  // lengths and energies, which cannot be removed by scaling.
  draft.set("md.contact_distance", "4.3615e-10");
  draft.set("md.interaction_distance", "3.28e-10");
  draft.set("md.cutoff", "10e-10");
  draft.set("md.interaction_energy", "1.192021805256e-20"); // 74.4 meV
  draft.set("md.tolerance", "1e-8");
  draft.set("md.modes",
            in_quotes(problem.poisson_ratio == 0.0 || draft.coin("modes")
                          ? "vector"
                          : "normal"));
}

/// A self-affine surface. At least two periods of the shortest wave fit into
/// the roll-off length.
void draw_rough(Draft& draft, const Problem& problem) {
  const bool is_atoms = problem.family == "atoms";
  const std::string word =
      draft.word("shortest-wave", {{"2", is_atoms ? 0.0 : 1.0},
                                   {"2.1", is_atoms ? 0.0 : 2.0},
                                   {"3", is_atoms ? 0.0 : 1.0},
                                   {"4", 1.0},
                                   {"8", 1.0}});
  const double shortest = std::min(std::stod(word), 0.5 * problem.points);
  const double roll_off =
      std::clamp(draft.uniform("roll_off", 1.0, 4.0), 1.0,
                 std::max(1.0, 0.5 * problem.points / shortest));
  // Both limits are drawn with finite probability, because part of a spectral
  // moment is a logarithm there.
  double hurst = std::clamp(draft.uniform("hurst", -0.1, 1.1), 1e-3, 1.0);
  if (draft.base() != nullptr && draft.keeps("hurst") &&
      draft.base()->contact_case.surface.hurst > 0.0)
    hurst = draft.base()->contact_case.surface.hurst;
  draft.label("hurst", bin_of("hurst", hurst));
  draft.set("surface.kind", in_quotes("self-affine"));
  draft.set("surface.seed", std::to_string(draft.index()));
  draft.set("surface.hurst", number(hurst));
  draft.set("surface.rms_slope", number(problem.rms_slope));
  draft.set("surface.wavelength_long", quantity(1.0, "length"));
  draft.set("surface.wavelength_roll_off", quantity(1.0 / roll_off, "length"));
  draft.set("surface.wavelength_short", quantity(shortest, "h"));
  if (problem.is_continuum() && problem.family != "full-block") {
    const std::string count =
        draft.word("realizations", {{"1", 3.0}, {"2", 1.0}});
    draft.set("surface.realizations", count);
  }
}

void draw_surface(Draft& draft, Problem& problem) {
  problem.shape = "rough";
  if (problem.counter == "sphere")
    problem.shape = "paraboloid";
  else if (problem.is_continuum())
    problem.shape = draft.word("shape", {{"rough", 8.0},
                                         {"wave", 1.0},
                                         {"paraboloid", 1.0},
                                         {"spike", 1.0},
                                         {"step", 1.0},
                                         {"sawtooth", 1.0},
                                         {"terraces", 1.0},
                                         {"checkerboard", 1.0}});
  draft.label("shape", problem.shape);
  draft.set("surface.length", draft.length(problem.length));
  const double slope = problem.rms_slope;
  if (problem.shape == "rough") {
    draw_rough(draft, problem);
  } else if (problem.shape == "wave") {
    draft.set("surface.kind", in_quotes("wave-2d"));
    draft.set("surface.wavelength", quantity(1.0, "length"));
    draft.set("surface.amplitude",
              draft.length(slope * problem.length /
                           (std::numbers::sqrt2 * std::numbers::pi)));
  } else if (problem.shape == "paraboloid") {
    draft.set("surface.kind", in_quotes("sphere"));
    draft.set("surface.radius",
              draft.length(problem.length / (std::sqrt(6.0) * slope)));
  } else {
    draft.set("surface.kind", in_quotes("measured"));
    draft.set("surface.file", in_quotes("map.txt"));
    draft.set("surface.format", in_quotes("plain"));
    draft.set("surface.level", in_quotes("none"));
    draft.set("surface.fill", in_quotes("none"));
    draft.set("surface.height_unit", "1.0");
    draft.set_map(map_of_shape(problem.shape, problem.points, problem.length,
                               slope, draft));
    return;
  }
  draft.set("surface.points", std::to_string(problem.points));
}

/// Maps continue in each of four ways, and other surfaces of half-spaces
/// periodically or not at all.
void draw_edges(Draft& draft, Problem& problem) {
  if (!problem.is_continuum() || problem.family == "full-block" ||
      draft.base() != nullptr)
    return;
  const bool is_map = draft.has_map();
  const bool may_be_free = problem.family == "halfspace" &&
                           problem.by_pressure && problem.shape != "wave";
  problem.edges = draft.word("edges", {{"periodic", 3.0},
                                       {"window", is_map ? 0.5 : 0.0},
                                       {"mirror", is_map ? 1.0 : 0.0},
                                       {"free", may_be_free ? 1.5 : 0.0}});
  if (problem.edges != "periodic" || is_map)
    draft.set("surface.edges", in_quotes(problem.edges));
  if (problem.edges == "window")
    draft.set("surface.press_windowed_map", "true");
}

/// Pressures relative to the load of the instance, or gaps in h_rms that are
/// added to its gap.
std::vector<double> steps_of(const std::string& program, bool by_pressure) {
  if (program == "increments")
    return by_pressure ? std::vector{0.5, 1.0, 1.01}
                       : std::vector{0.5, 0.0, -0.01};
  if (program == "jump")
    return by_pressure ? std::vector{1e-6, 1.0, 1.01}
                       : std::vector{10.0, 0.0, -0.01};
  return by_pressure ? std::vector{0.25, 0.5, 1.0, 0.5, 0.25}
                     : std::vector{1.0, 0.5, 0.0, 0.5, 1.0};
}

/// Pressures are log-uniform, with half of the draws in the range in which
/// contact changes most; gaps lie where the surfaces touch. Beyond a load,
/// adhesion has tensions, the last of which no node can hold.
void draw_load(Draft& draft, Problem& problem) {
  const bool is_contact = problem.is_continuum();
  problem.by_pressure =
      !is_contact || problem.counter != "none" ||
      draft.word("control", {{"pressure", 7.0}, {"gap", 3.0}}) == "pressure";
  if (problem.counter != "none")
    draft.label("control", "pressure");
  const std::string program =
      is_contact
          ? draft.word("program", equally({"increments", "jump", "cycle"}))
          : "increments";
  const double load =
      problem.family == "atoms"    ? draft.number("load", 1e-3, 0.3)
      : problem.family == "theory" ? draft.number("load", 1e-12, 100.0)
      : !problem.by_pressure       ? draft.number("gap", 1e-3, 4.0)
      : draft.coin("load")         ? draft.number("load", 1e-9, 100.0)
                                   : draft.number("load", 1e-3, 10.0);
  problem.load = load;
  std::vector<std::string> targets;
  for (const double step : steps_of(program, problem.by_pressure))
    targets.push_back(
        problem.by_pressure
            ? quantity(load * step, "E* h'")
            : quantity(load + step * (step < 0.0 ? load : 1.0), "h_rms"));
  if (problem.is_adhesive() && problem.by_pressure)
    for (const double share : {0.0, 0.01, 1.01})
      targets.push_back(draft.pressure(share * problem.tension));
  draft.set(problem.by_pressure ? "load.nominal_pressure" : "load.mean_gap",
            fmt::format("[{}]", fmt::join(targets, ", ")));
  if (problem.is_adhesive() && !problem.by_pressure && draft.coin("spring"))
    draft.set("load.spring", quantity(draft.log_uniform("spring", 1e-2, 1e4) *
                                          std::numbers::pi / problem.points,
                                      "E*/h"));
}

/// A quarter of the full blocks that can flow do, from contacts that hardly do
/// to those that all do. A block with free sides carries no more than its yield
/// stress, and all of it flows far beyond this stress between periodic ones.
void draw_flow(Draft& draft, const Problem& problem) {
  const bool is_possible = problem.family == "full-block" &&
                           draft.base() == nullptr &&
                           problem.counter == "none" && problem.by_pressure &&
                           problem.mesh != "adaptive" &&
                           (problem.mesh != "gmsh" || problem.degree == 2) &&
                           problem.poisson_ratio < 0.49;
  if (!is_possible ||
      draft.word("material-law", {{"elastic", 3.0}, {"plastic", 1.0}}) ==
          "elastic")
    return;
  const double least =
      (draft.has_label("sides", "free") ? 4.0 : 1.0) * problem.load;
  const double ratio =
      std::max(least, draft.log_uniform("yield_stress", 0.1, 10.0));
  draft.set("fem.yield_stress", quantity(ratio * problem.rms_slope, "E*"));
}

/// A process and a result file cost as much as some hundred problems. Studies
/// are a matter of whole runs.
void draw_path(Draft& draft, const Problem& problem) {
  const bool is_full = problem.family == "full-block";
  const bool is_flawed = draft.has_label("family", "flawed");
  const double runs = draft.base() != nullptr || !problem.is_continuum() ? 0.0
                      : is_full || problem.is_adhesive()                 ? 0.0
                      : is_flawed                                        ? 9.9
                                                                         : 0.99;
  const std::string path = draft.word(
      "path", {{"library", is_full ? 90.0 : 98.0},
               {"program", runs},
               {"report", is_flawed ? 0.0 : runs},
               {"two-ranks", is_full && draft.base() == nullptr ? 10.0 : 0.0}});
  if ((path != "program" && path != "report") || is_flawed)
    return;
  const bool can_slip = problem.family == "halfspace" &&
                        !problem.is_adhesive() && problem.by_pressure &&
                        problem.edges != "free";
  const std::string study =
      draft.word("study", {{"none", 1.0},
                           {"flow", 1.0},
                           {"spots", 1.0},
                           {"conductance", 1.0},
                           {"friction", can_slip ? 4.0 : 0.0}});
  if (study == "flow")
    draft.set(study, "{ viscosity = 1e-3, pressure_drop = 1e5 }");
  if (study == "spots")
    draft.set(study, "{ smallest = 4 }");
  if (study == "conductance")
    draft.set(study, "{ thermal_conductivity = 50.0, "
                     "counter_thermal_conductivity = 16.0 }");
  if (study == "friction")
    draft.set(study, "{ coefficient = 0.5 }");
}

/// The second run with which a problem is compared. The bits of two runs with
/// adhesion decide on jumps, which other units need not have.
void draw_relation(Draft& draft, const Problem& problem) {
  const bool is_full = problem.family == "full-block";
  if (!problem.is_continuum() || draft.has_label("family", "flawed"))
    return;
  const double units = is_full || draft.base() != nullptr ? 0.0 : 1.0;
  const bool flows =
      draft.has_label("material-law", "plastic"); // no direct solver
  const std::string relation =
      draft.word("metamorphic pair",
                 {{"none", is_full && !flows ? 0.0 : 1.0},
                  {"binary-units", units},
                  {"decimal-units", problem.is_adhesive() ? 0.0 : units},
                  {"threads", is_full ? 0.0 : 1.0},
                  {"direct-solver", is_full && !flows ? 1.0 : 0.0}});
  int threads = std::stoi(draft.word("threads", equally({"1", "2", "3"})));
  if (relation == "threads" && threads == 1) {
    threads = 3;
    draft.label("threads", "3");
  }
  draft.set_threads(threads);
}

/// The surface and the loads of a case are replaced, and what needs others is
/// left out.
void replace_base(Draft& draft) {
  const cases::Case& contact_case = draft.base()->contact_case;
  if (!contact_case.expectations.empty())
    draft.remove("expect");
  if (cases::is_asked(contact_case, "friction"))
    draft.remove("friction");
}

} // namespace

Instance draw_instance(std::uint64_t seed, int index, const Base* base,
                       const UnitRatios& units) {
  require_not_negative("index", index, "1");
  Draft draft(seed, index, base, units);
  Problem problem;
  draw_family(draft, problem);
  draw_bodies(draft, problem);
  draw_points(draft, problem);
  draw_scales(draft, problem);
  draw_block(draft, problem);
  draw_material(draft, problem);
  draw_full_block(draft, problem);
  draw_contact(draft, problem);
  draw_atoms(draft, problem);
  if (problem.family == "theory" && base == nullptr)
    draft.set("theory.gamma", number(draft.log_uniform("gamma", 0.01, 1.0)));
  draw_load(draft, problem);
  draw_flow(draft, problem);
  draw_surface(draft, problem);
  draw_edges(draft, problem);
  draw_path(draft, problem);
  draw_relation(draft, problem);
  if (base != nullptr)
    replace_base(draft);
  Instance instance = draft.finished(problem.method);
  if (const std::string flaw = instance.label("flaw"); !flaw.empty())
    spoil(flaw, draft, instance);
  return instance;
}

std::vector<Base> bases_of(const cases::Case& contact_case) {
  std::vector<Base> bases;
  for (const cases::MethodSpec& method : contact_case.methods) {
    if (method.hardness())
      throw input::InputError(
          contact_case.path + ": " + method.name +
          " has a hardness, for which this version has no random problems");
    if (!std::holds_alternative<mechanics::WinklerSettings>(method.settings))
      bases.push_back({contact_case, method.name});
  }
  if (bases.empty())
    throw input::InputError(contact_case.path +
                            " has no method with random problems");
  return bases;
}

} // namespace asperity::robustness
