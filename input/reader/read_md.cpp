#include "input/reader/read_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::cases {
namespace {

void check_lattice(TableReader& table, const mechanics::MdSettings& md) {
  for (const auto& [key, number] :
       {std::pair("atoms", md.atoms),
        std::pair("substrate_atoms", md.substrate_atoms)})
    if (number.value_or(0) % 2 != 0)
      table.refuse(table.said_by(key), "must be even");
  if (md.engine == mechanics::AtomEngine::lammps &&
      md.lattice != mechanics::AtomLattice::central)
    table.complain(table.said_by("engine"),
                   "= \"lammps\" needs lattice = \"central\": its bonds are "
                   "central springs");
  const int coarsest = 1 << std::clamp(md.levels - 1, 0, 30); // range: above
  if (md.modes == mechanics::AtomModes::normal &&
      (md.bulk == mechanics::AtomBulk::explicit_layers ||
       md.engine == mechanics::AtomEngine::lammps))
    table.refuse(table.said_by("modes"),
                 "needs engine = \"asperity\" and bulk = \"green\": other "
                 "atoms move in all three directions");
  if (md.bulk == mechanics::AtomBulk::explicit_layers &&
      md.engine == mechanics::AtomEngine::lammps)
    table.refuse(table.said_by("bulk"),
                 "needs engine = \"asperity\": \"lammps\" always uses one "
                 "spacing from the surface down to depth; remove bulk, levels "
                 "and layers");
  if (md.bulk == mechanics::AtomBulk::explicit_layers && md.atoms &&
      *md.atoms % coarsest != 0)
    table.refuse(table.said_by("atoms"),
                 fmt::format("must be a multiple of {} for {} levels, each "
                             "twice as coarse as the one before",
                             coarsest, md.levels));
}

void check_balance(TableReader& table, const mechanics::MdSettings& md) {
  const bool is_dynamics = md.minimizer == mechanics::AtomMinimizer::dynamics;
  if (is_dynamics)
    for (const char* const key : {"mass", "time_step", "damping", "duration"})
      table.require(key, ", which this minimizer needs");
  if (md.temperature > 0.0)
    table.require("seed", ", which a temperature needs");
  if (is_dynamics && md.engine == mechanics::AtomEngine::lammps)
    table.refuse(table.said_by("minimizer"),
                 "needs engine = \"asperity\": \"lammps\" supports only static "
                 "equilibrium");
  if (is_dynamics && md.duration > 0.0 && md.duration < md.time_step)
    table.refuse(table.said_by("duration"), "must be at least md.time_step");
  if (is_dynamics && md.temperature == 0.0 && md.damping == 0.0 &&
      table.has("damping"))
    table.refuse(table.said_by("damping"),
                 "must be > 0 [1/s] at a temperature of 0");
  if (is_dynamics && md.bulk != mechanics::AtomBulk::explicit_layers)
    table.complain(table.said_by("minimizer"),
                   "needs bulk = \"explicit\": the atoms of a condensed block "
                   "have no mass");
}

} // namespace

void check_md(TableReader& table, const mechanics::MdSettings& md) {
  check_lattice(table, md);
  if (md.cutoff > 0.0 && md.cutoff <= md.contact_distance)
    table.refuse(table.said_by("cutoff"),
                 fmt::format("must be > contact_distance = {:g} m: otherwise "
                             "atoms in contact would not interact",
                             md.contact_distance));
  check_balance(table, md);
}

namespace {

/// Reports what a half-space with free boundaries cannot have.
void check_free_boundaries(const Node& file, const Case& read,
                           Mistakes& mistakes) {
  for (const MethodSpec& method : read.methods) {
    const auto* const half = method.as<mechanics::HalfspaceSettings>();
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
  const Node& base = *file.find(kind_of_method(name));
  const Node* const variant = file.at(name);
  const Node& method = variant ? *variant : base;
  const Node* const own = method.find(key);
  const Node* const found = own ? own : base.find(key);
  return found ? *found : method;
}

void check_together(const Node& file, const Case& read, Mistakes& mistakes) {
  check_block(file, read, mistakes);
  check_free_boundaries(file, read, mistakes);
  for (const MethodSpec& method : read.methods) {
    const auto* const md = method.as<mechanics::MdSettings>();
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
