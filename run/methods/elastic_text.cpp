#include "base/shown_number.hpp"
#include "input/types/units.hpp"
#include "run/methods/elastic_method.hpp"

#include <fmt/format.h>

namespace asperity::methods {
namespace {

using mechanics::ContactSettings;
using mechanics::FemSettings;
using mechanics::HalfspaceSettings;

std::string in_words(const ContactSettings& settings) {
  const mechanics::ContactLawTraits& law = mechanics::traits_of(settings.law);
  if (mechanics::is_adhesive(settings.law)) {
    using mechanics::ReferenceUnit;
    const std::string range =
        !settings.range
            ? "the shortest that the grid resolves"
            : fmt::format("{:g} {}", settings.range->value,
                          settings.range->reference == ReferenceUnit::si ? "m"
                          : settings.range->reference == ReferenceUnit::spacing
                              ? "h"
                              : "L");
    return fmt::format("{}, w = {:g} J/m^2, range {}", law.words,
                       settings.work_of_adhesion, range);
  }
  if (settings.hardness)
    return fmt::format("{}, hardness {}", law.words,
                       settings.hardness->reference ==
                               mechanics::ReferenceUnit::si
                           ? quantity_text(settings.hardness->value, "Pa")
                           : cases::write_quantity(*settings.hardness,
                                                   cases::Dimension::pressure));
  if (!law.needs_penalty)
    return law.words;
  const char* unit =
      settings.penalty.reference ==
              mechanics::ReferenceUnit::contact_modulus_per_spacing
          ? "E*/h"
          : "Pa/m";
  return fmt::format("{} {:g} {}", law.words, settings.penalty.value, unit);
}

/// Returns the moduli of each layer as text, beginning at the contact surface.
std::string in_words(const std::vector<mechanics::MaterialLayer>& layers) {
  std::string words;
  for (const mechanics::MaterialLayer& layer : layers)
    words += fmt::format("{}E = {}, nu = {:g}", words.empty() ? "" : "; ",
                         quantity_text(layer.moduli.youngs_modulus, "Pa"),
                         layer.moduli.poisson_ratio);
  return words;
}

} // namespace

std::string material_text(const cases::MethodSpec& method,
                          const mechanics::MaterialSpec& material) {
  const auto* const fem = std::get_if<FemSettings>(&method.settings);
  const bool is_full =
      fem != nullptr && fem->solver == mechanics::FemSolver::full;
  if (!is_full && (material.inclusion || material.variation))
    return material.inclusion ? "uniform: without the inclusion"
                              : "uniform: without the variation";
  if (material.layers.empty())
    return {};
  if (!method.uses_layers())
    return "uniform: without the layers";
  return fmt::format("under {} bonded {} ({})", material.layers.size(),
                     material.layers.size() == 1 ? "layer" : "layers",
                     in_words(material.layers));
}

MethodDescription describe(const FemSettings& settings) {
  const std::string solver =
      settings.solver == mechanics::FemSolver::full
          ? "the full three-dimensional block"
      : settings.solver == mechanics::FemSolver::condensed
          ? "condensed to the contact surface"
          : "condensed to the contact surface (auto: "
            "the block is laterally uniform)";
  const std::string mesh =
      settings.full.uses_case_mesh
          ? "on the mesh of the case"
          : fmt::format("layers from {:g} h with the grading ratio {:g}",
                        settings.block.surface_cell_depth,
                        settings.block.growth);
  const std::string flow =
      !settings.full.yield_stress ? ""
      : settings.full.hardening_modulus
          ? ", J2 plasticity with linear isotropic hardening"
          : ", J2 plasticity without hardening";
  return {"fem",
          fmt::format("finite elements {}, {}{}, {}, {}",
                      settings.block.element == mechanics::Element::q1 ? "Q1"
                                                                       : "Q2",
                      solver, flow, mesh, in_words(settings.contact)),
          settings.solver == mechanics::FemSolver::full};
}

MethodDescription describe(const HalfspaceSettings& settings) {
  return {"halfspace",
          fmt::format("continuum {}, spectral, {}{}", settings.block().name(),
                      settings.block().is_free() ? "free boundaries, " : "",
                      in_words(settings.contact)),
          false};
}

} // namespace asperity::methods
