#include "base/plain_text.hpp"
#include "input/reader/read_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::cases {
namespace {

bool has_free_edges(const Node& file) {
  const Node* const edges = file.at("surface.edges");
  return edges && edges->text == "free";
}

/// "a", "b" or "c": the contacts with adhesion.
std::string adhesive_names() {
  std::vector<std::string> names;
  for (const mechanics::ContactLawTraits& law : mechanics::contact_laws())
    if (mechanics::is_adhesive(law.law))
      names.push_back('"' + std::string(law.name) + '"');
  return fmt::format("{} or {}",
                     fmt::join(names.begin(), std::prev(names.end()), ", "),
                     names.back());
}

mechanics::ContactSettings read_contact(TableReader& table) {
  mechanics::ContactSettings contact;
  table.read(contact);
  if (table.has("contact") &&
      table.said_by("contact").text != mechanics::traits_of(contact.law).name) {
    // An unknown law, which is reported: what is given beside it tells which
    // kind is meant.
    if (table.has("work_of_adhesion") || table.has("range"))
      contact.law = mechanics::ContactLaw::exponential;
    return contact;
  }
  if (mechanics::needs_penalty(contact.law))
    table.require("penalty", ", which this contact needs");
  if (mechanics::is_adhesive(contact.law))
    table.require("work_of_adhesion", ", which this contact needs");
  for (const char* const key : {"work_of_adhesion", "range"})
    if (!mechanics::is_adhesive(contact.law) && table.has(key))
      table.refuse(table.said_by(key),
                   "needs a contact with adhesion: contact = " +
                       adhesive_names());
  return contact;
}

/// Refuses the stiffness of the contact for blocks that do not find it.
void refuse_stiffness(TableReader& table, const mechanics::FemSettings& fem) {
  const auto refuse_if = [&](bool is_refused, const std::string& key,
                             const std::string& needed) {
    if (fem.full.has_stiffness && is_refused)
      table.refuse(table.said_by("stiffness"),
                   "cannot be combined with " + key + "; it needs " + needed);
  };
  refuse_if(fem.full.bodies == 2, "bodies = 2", "bodies = 1");
  refuse_if(fem.block.far_boundary != mechanics::FarBoundary::clamped,
            "this far boundary (top)", "top = \"clamped\"");
}

/// Refuses plastic flow for blocks that do not compute it.
void refuse_flow(TableReader& table, const mechanics::FemSettings& fem) {
  if (fem.full.hardening_modulus && !fem.full.yield_stress)
    table.refuse(table.said_by("hardening_modulus"), "needs yield_stress");
  const auto refuse_if = [&](bool is_refused, const std::string& why) {
    if (fem.full.yield_stress && is_refused)
      table.refuse(table.said_by("yield_stress"), why);
  };
  refuse_if(fem.full.bodies == 2, "cannot be combined with bodies = 2");
  refuse_if(fem.full.has_stiffness, "cannot be combined with stiffness = true");
  refuse_if(fem.full.linear_solver == mechanics::LinearSolver::direct,
            "needs linear_solver = \"auto\" or \"multigrid\"");
}

/// Reports what the full block cannot combine, and what only it has.
void check_full_block(TableReader& table, bool has_mesh,
                      const mechanics::FemSettings& fem) {
  const mechanics::FullBlockSettings& full = fem.full;
  const mechanics::FullBlockSettings defaults;
  const auto only_full = [&](bool is_asked, const std::string& key) {
    if (is_asked && fem.solver != mechanics::FemSolver::full)
      table.refuse(table.said_by(key), "needs solver = \"full\"");
  };
  only_full(full.uses_case_mesh, "mesh");
  only_full(full.sides != defaults.sides, "sides");
  only_full(full.linear_solver != defaults.linear_solver, "linear_solver");
  only_full(full.bodies == 2, "bodies");
  only_full(full.has_stiffness, "stiffness");
  only_full(full.yield_stress.has_value(), "yield_stress");
  refuse_stiffness(table, fem);
  refuse_flow(table, fem);
  if (full.uses_case_mesh && !has_mesh)
    table.refuse(table.said_by("mesh"), "the table [mesh] is missing");
}

/// The properties of the case that determine which keys of a method are valid.
struct MethodSurroundings {
  mechanics::SurfaceKind surface;
  bool has_mesh;       ///< whether the case has a [mesh]
  bool has_free_edges; ///< surface.edges = "free"
};

/// Reads the settings of a method whose keys need no check between them.
template <class Settings>
void read_settings(TableReader& table, const MethodSurroundings&,
                   Settings& settings) {
  table.read(settings);
}

void read_settings(TableReader& table, const MethodSurroundings& surroundings,
                   mechanics::TheorySettings& theory) {
  const mechanics::SurfaceKind kind = surroundings.surface;
  const bool has_formula = kind == mechanics::SurfaceKind::self_affine ||
                           kind == mechanics::SurfaceKind::spectrum;
  theory.spectrum = has_formula ? mechanics::TheorySpectrum::formula
                                : mechanics::TheorySpectrum::surface;
  table.read(theory);
  if (theory.spectrum == mechanics::TheorySpectrum::formula && !has_formula)
    table.refuse(table.said_by("spectrum"),
                 "must be \"surface\": only the kinds self-affine and spectrum "
                 "have a formula");
  const double least = 0.011; // as theory::LossLaw
  if (theory.loss_factor == mechanics::LossFactor::wang_mueser &&
      !(theory.gamma > least))
    table.refuse(table.said_by("gamma"),
                 "must be above 0.011 with loss_factor = \"wang-mueser\", "
                 "whose factor is negative at some areas below it");
}

void read_settings(TableReader& table, const MethodSurroundings& surroundings,
                   mechanics::HalfspaceSettings& halfspace) {
  halfspace.contact = read_contact(table);
  halfspace.has_free_boundaries = surroundings.has_free_edges;
  table.read(halfspace);
  if (halfspace.contact.hardness &&
      halfspace.contact.law != mechanics::ContactLaw::hard)
    table.refuse(table.said_by("hardness"), "needs contact = \"hard\"");
  if (halfspace.has_free_boundaries && halfspace.thickness)
    table.refuse(table.said_by("thickness"),
                 "free boundaries need a half-space of infinite thickness; "
                 "boundaries = \"periodic\" allows a slab");
}

void read_settings(TableReader& table, const MethodSurroundings& surroundings,
                   mechanics::FemSettings& fem) {
  fem.contact = read_contact(table);
  table.read(fem.block);
  table.read(fem);
  if (mechanics::is_adhesive(fem.contact.law) &&
      (fem.solver == mechanics::FemSolver::full ||
       fem.block.element != mechanics::Element::q1))
    table.refuse(table.said_by("contact"),
                 "only blocks with element = \"Q1\" and solver = \"condensed\" "
                 "have adhesion in this version");
  fem.full.uses_case_mesh =
      fem.solver == mechanics::FemSolver::full && surroundings.has_mesh;
  table.read(fem.full);
  check_full_block(table, surroundings.has_mesh, fem);
}

void read_settings(TableReader& table, const MethodSurroundings&,
                   mechanics::MdSettings& md) {
  table.read(md);
  check_md(table, md);
}

/// Returns the default settings of the kind: the alternative of MethodSettings
/// with this name.
template <std::size_t i = 0>
MethodSettings default_settings(const std::string& kind) {
  if constexpr (i < std::variant_size_v<MethodSettings>) {
    using Settings = std::variant_alternative_t<i, MethodSettings>;
    return kind == Settings::kind ? Settings{} : default_settings<i + 1>(kind);
  } else {
    throw std::logic_error("[" + kind + "] has a vocabulary, but no settings");
  }
}

MethodSpec read_method(const Node& node, const std::string& kind,
                       const MethodSurroundings& surroundings,
                       const TableReader& file) {
  TableReader table = file.part(node, kind);
  MethodSpec method{node.path, default_settings(kind)};
  table.read(method);
  if (method.magnification &&
      surroundings.surface != mechanics::SurfaceKind::self_affine)
    table.refuse(table.said_by("magnification"),
                 "this key applies only to self-affine surfaces, because it is "
                 "relative to their roll-off wavevector");
  std::visit([&](auto& own) { read_settings(table, surroundings, own); },
             method.settings);
  return method;
}

/// Tables of a result are named after a method, with a word before it that is
/// no longer than this: "stress-sections-".
constexpr std::size_t longest_word = 20;

void check_variant_name(const NodeEntry& entry, TableReader& file) {
  if (entry.node.path.size() + longest_word > longest_name)
    file.complain(
        entry.node,
        fmt::format("is a name of {} characters, but that of a method "
                    "must have at most {}",
                    entry.node.path.size(), longest_name - longest_word));
  if (entry.key.empty() ||
      entry.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") !=
          std::string::npos)
    file.complain(entry.node, "names a variant, but must consist of the "
                              "letters a-z, digits and hyphens");
}

/// Returns "[theory], [halfspace], ...".
std::string names_of_methods() {
  std::string names;
  for (const Table& table : vocabulary())
    if (table.is_method)
      names += (names.empty() ? "[" : ", [") + table.name + "]";
  return names;
}

void read_family(const Node& node, const std::string& kind,
                 const MethodSurroundings& surroundings,
                 std::vector<std::vector<MethodSpec>>& ranks,
                 TableReader& file) {
  ranks[0].push_back(
      read_method(method_table(node, kind), kind, surroundings, file));
  for (const NodeEntry& entry : node.entries) {
    if (!is_variant(entry, kind))
      continue;
    check_variant_name(entry, file);
    ranks[1].push_back(read_method(method_table(node, kind, &entry.node), kind,
                                   surroundings, file));
  }
}

} // namespace

std::vector<MethodSpec> read_methods(TableReader& file,
                                     mechanics::SurfaceKind kind,
                                     Mistakes& mistakes) {
  std::vector<std::vector<MethodSpec>> ranks(2); // methods, then their variants
  const MethodSurroundings surroundings{kind, file.has("mesh"),
                                        has_free_edges(file.node())};
  bool has_any = false;
  for (const Table& table : vocabulary()) {
    if (!table.is_method || !file.has(table.name))
      continue;
    has_any = true;
    if (const Node* const node = file.sub_table(table.name))
      read_family(*node, table.name, surroundings, ranks, file);
  }
  if (!has_any)
    mistakes.add(file.node().place,
                 "no method is given; allowed: " + names_of_methods());
  std::vector<MethodSpec> methods = ranks[0];
  methods.insert(methods.end(), ranks[1].begin(), ranks[1].end());
  return methods;
}

Demands demands_of(const std::vector<MethodSpec>& methods) {
  return {methods.empty() ||
              std::ranges::any_of(methods, &MethodSpec::needs_surface),
          std::ranges::any_of(methods, &MethodSpec::needs_poisson_ratio)};
}

} // namespace asperity::cases
