#include "suite/bench/settings/block_settings.hpp"

#include "suite/bench/settings/case_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::bench {
namespace {

using mechanics::MeshGeometry;
using mechanics::MeshKind;

bool has_method(const cases::Case& contact_case, const std::string& name) {
  return std::ranges::any_of(
      contact_case.methods,
      [&](const cases::MethodSpec& method) { return method.name == name; });
}

/// Whether the condensed solver has the same problem as the full block.
bool is_condensable(const cases::Case& contact_case,
                    const mechanics::FemSettings& fem) {
  return fem.full.sides == mechanics::BlockSides::periodic &&
         fem.full.bodies == 1 && !contact_case.material.inclusion &&
         !contact_case.material.variation;
}

std::optional<int> halvings_for(const cases::Case& contact_case, int points) {
  const double levels =
      std::log2(static_cast<double>(points) / *contact_case.surface.points);
  const double halvings = contact_case.mesh.halvings + std::round(levels);
  if (std::abs(levels - std::round(levels)) > 1e-9 || halvings < 1.0)
    return std::nullopt;
  return static_cast<int>(halvings);
}

} // namespace

bool is_block_on_mesh(const cases::Case& contact_case,
                      const cases::MethodSpec& method) {
  const auto* fem = std::get_if<mechanics::FemSettings>(&method.settings);
  return fem != nullptr && fem->solver == mechanics::FemSolver::full &&
         fem->full.uses_case_mesh && contact_case.mesh.kind != MeshKind::layers;
}

std::vector<AddedMethod> same_block_methods(const cases::Case& contact_case,
                                            const cases::MethodSpec& method) {
  std::vector<AddedMethod> added;
  if (!is_block_on_mesh(contact_case, method) ||
      method.name != cases::kind_of_method(method.name) ||
      !is_condensable(contact_case,
                      std::get<mechanics::FemSettings>(method.settings)))
    return added;
  for (const auto& [name, setting] :
       {std::pair{"uniform", "mesh=layers"},
        std::pair{"condensed", "solver=condensed"}}) {
    const std::string variant = fmt::format("{}.{}", method.name, name);
    if (!has_method(contact_case, variant))
      added.push_back({variant, {fmt::format("{}.{}", variant, setting)}});
  }
  return added;
}

std::optional<std::vector<std::string>>
mesh_overrides(const cases::Case& contact_case, int points) {
  const int own_points = contact_case.surface.points.value_or(0);
  if (own_points == 0 || points == own_points)
    return std::vector<std::string>{};
  const mechanics::MeshSpec& mesh = contact_case.mesh;
  if (mesh.kind == MeshKind::adaptive) {
    const auto halvings = halvings_for(contact_case, points);
    if (!halvings)
      return std::nullopt;
    return std::vector{fmt::format("mesh.halvings={}", *halvings)};
  }
  if (mesh.kind != MeshKind::gmsh || mesh.geometry == MeshGeometry::file)
    return std::vector<std::string>{};
  const CaseValues values(contact_case);
  const double factor = static_cast<double>(own_points) / points;
  std::vector<std::string> overrides;
  for (const char* key : {"size_at_contact", "size_far"}) {
    const auto size = values.value("mesh", key);
    const bool follows = size && size->text.ends_with(" h");
    if (size && !follows)
      overrides.push_back(
          fmt::format("mesh.{}={}", key, scaled_value(*size, factor)));
  }
  return overrides;
}

bool permits_points(const cases::Case& contact_case,
                    const cases::MethodSpec& method, int points) {
  if (!is_block_on_mesh(contact_case, method) ||
      contact_case.mesh.kind != MeshKind::adaptive)
    return points % 2 == 0;
  const auto& fem = std::get<mechanics::FemSettings>(method.settings);
  const int step = degree_of(fem.block.element) << contact_case.mesh.halvings;
  return points % step == 0 && points / step >= 2;
}

} // namespace asperity::bench
