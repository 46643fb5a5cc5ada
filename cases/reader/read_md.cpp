#include "cases/reader/read_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::cases {
namespace {

void refuse_if_odd(TableReader& table, const char* key) {
  if (table.has(key) && table.integer(key) % 2 != 0)
    table.refuse(*table.node().find(key), "must be even");
}

std::optional<int> count(TableReader& table, const char* key) {
  refuse_if_odd(table, key);
  return table.has(key) ? std::optional(table.integer(key)) : std::nullopt;
}

void read_lattice(TableReader& table, mechanics::MdSettings& md) {
  md.engine = table.choice("engine", md.engine);
  md.lattice = table.choice("lattice", md.lattice);
  md.bulk = table.choice("bulk", md.bulk);
  md.modes = table.choice("modes", md.modes);
  md.atoms = count(table, "atoms");
  md.substrate_atoms = count(table, "substrate_atoms");
  md.depth = table.quantity("depth");
  md.levels = table.integer("levels");
  md.layers = table.integer("layers");
  if (md.engine == mechanics::AtomEngine::lammps &&
      md.lattice != mechanics::AtomLattice::central)
    table.complain(*table.node().find("engine"),
                   "= \"lammps\" needs lattice = \"central\": its bonds are "
                   "central springs");
  const int coarsest = 1 << std::clamp(md.levels - 1, 0, 30); // range: above
  if (md.modes == mechanics::AtomModes::normal &&
      (md.bulk == mechanics::AtomBulk::explicit_layers ||
       md.engine == mechanics::AtomEngine::lammps))
    table.refuse(*table.node().find("modes"),
                 "needs engine = \"asperity\" and bulk = \"green\": other "
                 "atoms move in all three directions");
  if (md.bulk == mechanics::AtomBulk::explicit_layers &&
      md.engine == mechanics::AtomEngine::lammps)
    table.refuse(*table.node().find("bulk"),
                 "needs engine = \"asperity\": \"lammps\" always uses one "
                 "spacing from the surface down to depth; remove bulk, levels "
                 "and layers");
  if (md.bulk == mechanics::AtomBulk::explicit_layers && md.atoms &&
      *md.atoms % coarsest != 0)
    table.refuse(*table.node().find("atoms"),
                 fmt::format("must be a multiple of {} for {} levels, each "
                             "twice as coarse as the one before",
                             coarsest, md.levels));
}

void read_interaction(TableReader& table, mechanics::MdSettings& md) {
  md.potential = table.choice("potential", md.potential);
  md.interaction_energy = table.number("interaction_energy");
  md.interaction_distance = table.number("interaction_distance");
  md.cutoff = table.number("cutoff");
  md.contact_distance = table.number("contact_distance");
  if (md.cutoff > 0.0 && md.cutoff <= md.contact_distance)
    table.refuse(*table.node().find("cutoff"),
                 fmt::format("must be > contact_distance = {:g} m: otherwise "
                             "atoms in contact would not interact",
                             md.contact_distance));
}

double if_given(TableReader& table, const char* key, bool is_needed) {
  if (table.has(key))
    return table.number(key);
  if (is_needed)
    table.complain_missing(key, ", which this minimizer needs");
  return 0.0;
}

void read_balance(TableReader& table, mechanics::MdSettings& md) {
  md.minimizer = table.choice("minimizer", md.minimizer);
  md.tolerance = table.number("tolerance");
  md.max_evaluations = table.integer("max_evaluations");
  const bool moves = md.minimizer == mechanics::AtomMinimizer::fire ||
                     md.minimizer == mechanics::AtomMinimizer::dynamics;
  const bool is_dynamics = md.minimizer == mechanics::AtomMinimizer::dynamics;
  md.mass = if_given(table, "mass", is_dynamics);
  md.time_step = if_given(table, "time_step", is_dynamics);
  md.damping = if_given(table, "damping", is_dynamics);
  md.duration = if_given(table, "duration", is_dynamics);
  md.temperature = table.number("temperature");
  if (table.has("seed"))
    md.seed = static_cast<std::uint64_t>(table.integer("seed"));
  else if (md.temperature > 0.0)
    table.complain_missing("seed", ", which a temperature needs");
  if (is_dynamics && md.engine == mechanics::AtomEngine::lammps)
    table.refuse(*table.node().find("minimizer"),
                 "needs engine = \"asperity\": \"lammps\" supports only static "
                 "equilibrium");
  if (is_dynamics && md.duration > 0.0 && md.duration < md.time_step)
    table.refuse(*table.node().find("duration"),
                 "must be at least md.time_step");
  if (is_dynamics && md.temperature == 0.0 && md.damping == 0.0 &&
      table.has("damping"))
    table.refuse(*table.node().find("damping"),
                 "must be > 0 [1/s] at a temperature of 0");
  if (moves && md.bulk != mechanics::AtomBulk::explicit_layers)
    table.complain(*table.node().find("minimizer"),
                   "needs bulk = \"explicit\": the atoms of a condensed block "
                   "have no mass");
}

const Node* method_node(const Node& file, const std::string& name) {
  const std::size_t dot = name.find('.');
  const Node* const base = file.find(name.substr(0, dot));
  const Node* const variant = dot == std::string::npos || !base
                                  ? nullptr
                                  : base->find(name.substr(dot + 1));
  return variant ? variant : base;
}

/// Reports what a half-space with free boundaries cannot have.
void check_free_boundaries(const Node& file, const Case& read,
                           Mistakes& mistakes) {
  for (const MethodSpec& method : read.methods) {
    const auto* const half =
        std::get_if<mechanics::HalfspaceSettings>(&method.settings);
    if (!half || !half->has_free_boundaries)
      continue;
    const auto refuse = [&](const char* what) {
      const Node& found = entry_of(file, method.name, "boundaries");
      mistakes.add(found.place,
                   fmt::format("{} has free boundaries (here or by "
                               "surface.edges = \"free\"), but {}; boundaries "
                               "= \"periodic\" allows it",
                               method.name, what));
    };
    if (read.load.control == mechanics::Control::mean_gap)
      refuse("[load] prescribes mean gaps: please prescribe nominal_pressure");
    if (!read.material.layers.empty())
      refuse("[material] has layers");
    if (read.report.stress_inside)
      refuse("report.stress_inside computes the stress of a periodic block");
    if (method.magnification)
      refuse("its magnification needs a periodic surface");
  }
}

} // namespace

const Node& entry_of(const Node& file, const std::string& name,
                     const std::string& key) {
  const Node& method = *method_node(file, name);
  const Node* const own = method.find(key);
  const Node* const inherited =
      own ? own : file.find(name.substr(0, name.find('.')))->find(key);
  return inherited ? *inherited : method;
}

mechanics::MdSettings read_md(TableReader& table) {
  mechanics::MdSettings md;
  read_lattice(table, md);
  read_interaction(table, md);
  read_balance(table, md);
  md.ranks = table.integer("ranks");
  md.dump = table.boolean("dump");
  return md;
}

void check_together(const Node& file, const Case& read, Mistakes& mistakes) {
  check_block(file, read, mistakes);
  check_free_boundaries(file, read, mistakes);
  for (const MethodSpec& method : read.methods) {
    const auto* const md = std::get_if<mechanics::MdSettings>(&method.settings);
    const double nu = read.material.poisson_ratio.value_or(0.25);
    if (md && md->lattice == mechanics::AtomLattice::central &&
        std::abs(nu - 0.25) > 1e-12) {
      const Node& found = entry_of(file, method.name, "lattice");
      mistakes.add(found.place,
                   fmt::format("{}.lattice = \"central\" has Poisson's ratio "
                               "1/4, but material.poisson_ratio = {:g}",
                               method.name, nu));
    }
    if (method.magnification &&
        *method.magnification * read.surface.wavevector_roll_off <
            read.surface.wavevector_low) {
      const Node& found = entry_of(file, method.name, "magnification");
      mistakes.add(found.place,
                   fmt::format("{}.magnification = {:g}, but must be >= {:g}: "
                               "below it the surface has no roughness",
                               method.name, *method.magnification,
                               read.surface.wavevector_low /
                                   read.surface.wavevector_roll_off));
    }
  }
}

} // namespace asperity::cases
