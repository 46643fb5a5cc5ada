#include "input/reader/locking.hpp"

#include "input/types/omissions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace asperity::cases {
namespace {

/// Returns the largest Poisson's ratio of all materials of the block; 0 if none
/// is given.
double largest_ratio(const mechanics::MaterialSpec& material,
                     const mechanics::FemSettings& fem) {
  double largest = material.poisson_ratio.value_or(0.0);
  for (const mechanics::MaterialLayer& layer : material.layers)
    largest = std::max(largest, layer.moduli.poisson_ratio);
  if (material.inclusion && fem.solver == mechanics::FemSolver::full)
    largest = std::max(largest, material.inclusion->moduli.poisson_ratio);
  if (material.counter && fem.full.bodies == 2)
    largest = std::max(largest, material.counter->poisson_ratio);
  return largest;
}

} // namespace

double locking_ratio(mechanics::Element element) {
  return element == mechanics::Element::q1 ? 0.475 : 0.48;
}

std::vector<std::string>
locking_warnings(const mechanics::MaterialSpec& material,
                 std::span<const MethodSpec> methods) {
  std::vector<std::string> warnings;
  for (const MethodSpec& method : methods) {
    const auto* const fem = method.as<mechanics::FemSettings>();
    if (fem == nullptr)
      continue;
    const double ratio = largest_ratio(material, *fem);
    if (ratio < locking_ratio(fem->block.element))
      continue;
    const bool is_q1 = fem->block.element == mechanics::Element::q1;
    warnings.push_back(fmt::format(
        "{}: {} elements lock at a Poisson's ratio of {:g}: the stiffness at a "
        "wavelength of eight nodes is more than {} % too high and contact "
        "areas are too small; {}",
        method.name, is_q1 ? "Q1" : "Q2", ratio, is_q1 ? 10 : 5,
        is_q1 && ratio < locking_ratio(mechanics::Element::q2)
            ? "use element = \"Q2\""
        : is_q1 ? "use element = \"Q2\" with more nodes per shortest "
                  "wavelength, or [halfspace]"
                : "use more nodes per shortest wavelength, or [halfspace]"));
  }
  return warnings;
}

std::vector<std::string>
interpolation_warnings(const Case& contact_case,
                       std::span<const MethodSpec> methods) {
  std::vector<std::string> warnings;
  if (contact_case.surface.kind != mechanics::SurfaceKind::punch)
    return warnings;
  for (const MethodSpec& method : methods) {
    const auto* const fem = method.as<mechanics::FemSettings>();
    if (fem == nullptr || fem->solver != mechanics::FemSolver::full)
      continue;
    if (fem->full.uses_case_mesh &&
        contact_case.mesh.kind == mechanics::MeshKind::gmsh)
      warnings.push_back(
          method.name +
          ": contact points lie between the points of the map, where the cubic "
          "interpolation of the heights overshoots the step at the edge of the "
          "punch and contact areas are too small; use another mesh.kind, whose "
          "nodes are points of the map");
  }
  return warnings;
}

std::vector<std::string> warnings_about(const Case& contact_case,
                                        std::span<const MethodSpec> methods) {
  std::vector<std::string> all =
      locking_warnings(contact_case.material, methods);
  for (std::vector<std::string>& more :
       std::array{interpolation_warnings(contact_case, methods),
                  omission_warnings(contact_case, methods)})
    std::ranges::move(more, std::back_inserter(all));
  return all;
}

} // namespace asperity::cases
