#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"

#include <algorithm>
#include <stdexcept>

namespace asperity::cases {
namespace {

enum class Boundaries { periodic, free };

bool has_free_edges(const Node& file) {
  const Node* const surface = file.find("surface");
  const Node* const edges = surface ? surface->find("edges") : nullptr;
  return edges && edges->text == "free";
}

mechanics::ContactSettings read_contact(TableReader& table) {
  mechanics::ContactSettings contact;
  contact.law = table.choice("contact", contact.law);
  if (table.has("penalty"))
    contact.penalty = table.quantity("penalty");
  else if (contact.law != mechanics::ContactLaw::hard)
    table.complain_missing("penalty", ", which this contact needs");
  contact.tolerance = table.number("tolerance");
  contact.max_iterations = table.integer("max_iterations");
  return contact;
}

/// The properties of the case that determine which keys of a method are valid.
struct MethodSurroundings {
  mechanics::SurfaceKind surface;
  bool has_mesh;       ///< whether the case has a [mesh]
  bool has_free_edges; ///< surface.edges = "free"
};

void read_settings(TableReader& table, const MethodSurroundings& surroundings,
                   mechanics::TheorySettings& theory) {
  const mechanics::SurfaceKind kind = surroundings.surface;
  const bool has_formula = kind == mechanics::SurfaceKind::self_affine ||
                           kind == mechanics::SurfaceKind::spectrum;
  theory.gamma = table.number("gamma");
  theory.spectrum = has_formula ? mechanics::TheorySpectrum::formula
                                : mechanics::TheorySpectrum::surface;
  if (table.has("spectrum"))
    theory.spectrum = table.choice("spectrum", theory.spectrum);
  if (theory.spectrum == mechanics::TheorySpectrum::formula && !has_formula)
    table.refuse(*table.node().find("spectrum"),
                 "must be \"surface\": only the kinds self-affine and spectrum "
                 "have a formula");
}

void read_settings(TableReader& table, const MethodSurroundings& surroundings,
                   mechanics::HalfspaceSettings& halfspace) {
  halfspace.contact = read_contact(table);
  if (table.has("thickness"))
    halfspace.thickness = table.quantity("thickness");
  halfspace.far_boundary = table.choice("top", halfspace.far_boundary);
  halfspace.has_free_boundaries = surroundings.has_free_edges;
  if (table.has("boundaries"))
    halfspace.has_free_boundaries =
        table.choice("boundaries", Boundaries::periodic) == Boundaries::free;
  if (halfspace.has_free_boundaries && halfspace.thickness)
    table.refuse(*table.node().find("thickness"),
                 "free boundaries need a half-space of infinite thickness; "
                 "boundaries = \"periodic\" allows a slab");
}

void read_settings(TableReader& table, const MethodSurroundings& surroundings,
                   mechanics::FemSettings& fem) {
  fem.contact = read_contact(table);
  fem.block.element = table.choice("element", fem.block.element);
  fem.block.surface_cell_depth = table.number("surface_cell_depth");
  fem.block.growth = table.number("growth");
  fem.block.depth = table.quantity("depth");
  fem.block.far_boundary = table.choice("top", fem.block.far_boundary);
  fem.solver = table.choice("solver", fem.solver);
  read_full_block(table, surroundings.has_mesh, fem);
}

void read_settings(TableReader& table, const MethodSurroundings&,
                   mechanics::MdSettings& md) {
  md = read_md(table);
}

void read_settings(TableReader& table, const MethodSurroundings&,
                   mechanics::WinklerSettings& winkler) {
  winkler.stiffness = table.quantity("stiffness");
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

std::optional<double> read_magnification(TableReader& table,
                                         mechanics::SurfaceKind surface) {
  if (!table.has("magnification"))
    return std::nullopt;
  const double magnification = table.number("magnification");
  if (surface != mechanics::SurfaceKind::self_affine)
    table.refuse(*table.node().find("magnification"),
                 "this key applies only to self-affine surfaces, because it is "
                 "relative to their roll-off wavevector");
  return magnification;
}

MethodSpec read_method(const Node& node, const std::string& kind,
                       const MethodSurroundings& surroundings,
                       Mistakes& mistakes) {
  TableReader table(node, vocabulary_table(kind), mistakes);
  table.refuse_unknown();
  MethodSpec method{
      node.path, {}, read_magnification(table, surroundings.surface)};
  if (table.has("realizations"))
    method.realizations = table.integer("realizations");
  method.settings = default_settings(kind);
  std::visit([&](auto& own) { read_settings(table, surroundings, own); },
             method.settings);
  return method;
}

// Returns true for a variant, which is a sub-table whose name is not a key:
// [fem.hard].
bool is_variant(const NodeEntry& entry, const Table& table) {
  return entry.node.is_table() &&
         std::none_of(table.keys.begin(), table.keys.end(),
                      [&](const Key& key) { return key.name == entry.key; });
}

void check_variant_name(const NodeEntry& entry, Mistakes& mistakes) {
  if (entry.key.empty() ||
      entry.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") !=
          std::string::npos)
    mistakes.add(entry.node.place,
                 entry.node.path + " names a variant, but must consist of the "
                                   "letters a-z, digits and hyphens");
}

/// Merges the keys of a variant into those of its base method. Inherited keys
/// keep their place and path, so that a mistake in one of them is reported
/// once, where it is written.
Node inherited(const Node& base, const Node& variant) {
  Node merged = variant;
  for (const NodeEntry& entry : base.entries)
    if (!merged.find(entry.key))
      merged.entries.push_back(entry);
  return merged;
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
                 Mistakes& mistakes) {
  const Table& table = vocabulary_table(kind);
  Node base = node;
  std::erase_if(base.entries, [&](const NodeEntry& entry) {
    return is_variant(entry, table);
  });
  ranks[0].push_back(read_method(base, kind, surroundings, mistakes));
  for (const NodeEntry& entry : node.entries) {
    if (!is_variant(entry, table))
      continue;
    check_variant_name(entry, mistakes);
    ranks[1].push_back(
        read_method(inherited(base, entry.node), kind, surroundings, mistakes));
  }
}

} // namespace

std::vector<MethodSpec> read_methods(const Node& file,
                                     mechanics::SurfaceKind kind,
                                     Mistakes& mistakes) {
  std::vector<std::vector<MethodSpec>> ranks(2); // methods, then their variants
  const MethodSurroundings surroundings{kind, file.find("mesh") != nullptr,
                                        has_free_edges(file)};
  bool has_any = false;
  for (const Table& table : vocabulary()) {
    const Node* const node = table.is_method ? file.find(table.name) : nullptr;
    if (!node)
      continue;
    has_any = true;
    if (node->is_table())
      read_family(*node, table.name, surroundings, ranks, mistakes);
    else
      mistakes.add(node->place, table.name + " = " + written(*node) +
                                    ", but must be a table: [" + table.name +
                                    "]");
  }
  if (!has_any)
    mistakes.add(file.place,
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
