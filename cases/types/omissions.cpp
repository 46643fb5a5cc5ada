#include "cases/types/omissions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <variant>

namespace asperity::cases {
namespace {

using mechanics::FemSettings;
using mechanics::TheorySettings;

bool is_full_block(const MethodSpec& method) {
  const auto* const fem = method.as<mechanics::FemSettings>();
  return fem != nullptr && fem->solver == mechanics::FemSolver::full;
}

std::string no_flow(const Case&, const MethodSpec& method) {
  const auto* const theory = method.as<mechanics::TheorySettings>();
  return theory != nullptr &&
                 theory->loss_factor != mechanics::LossFactor::yang_persson
             ? "needs loss_factor = \"yang-persson\""
             : "";
}

std::string no_map(const Case&, const MethodSpec& method) {
  return method.has_fields() ? "" : "has no contact map";
}

std::string no_partial_slip(const Case& contact_case,
                            const MethodSpec& method) {
  return obstacle_to_partial_slip(method, contact_case.material);
}

/// Surface methods whose pressures are the answer of one operator in a convex
/// problem have the stiffness of [conductance], full blocks their own.
std::string no_normal_stiffness(const Case&, const MethodSpec& method) {
  if (const auto* const fem = method.as<mechanics::FemSettings>();
      fem != nullptr && is_full_block(method))
    return fem->full.has_stiffness ? "" : "needs stiffness = true";
  if (method.contact() == nullptr)
    return "needs a [halfspace] or [fem]";
  return method.is_adhesive() ? "needs a contact without adhesion" : "";
}

std::string no_stress(const Case&, const MethodSpec& method) {
  return method.is_continuum() ? "" : "has no elastic continuum";
}

std::string no_files(const Case&, const MethodSpec& method) {
  return is_full_block(method) ? "" : "needs [fem] with solver = \"full\"";
}

std::string no_layers(const Case&, const MethodSpec& method) {
  return method.uses_layers() ? "" : "has a uniform material";
}

std::string no_cells(const Case&, const MethodSpec& method) {
  return is_full_block(method) ? "" : "has a laterally uniform material";
}

const std::array all_questions{
    AskedTraits{Asked::flow,
                "[flow]",
                {"flow_factor_x", "flow_factor_y", "flow_conductance_x",
                 "flow_conductance_y", "critical_gap_x", "critical_gap_y",
                 "leak_rate_x", "leak_rate_y", "effective_medium"},
                [](const Case& one) { return one.flow_study.has_value(); },
                no_flow},
    AskedTraits{Asked::friction,
                "[friction]",
                {},
                [](const Case& one) { return one.friction_study.has_value(); },
                no_partial_slip},
    AskedTraits{Asked::spots,
                "[spots]",
                {"spot_count", "largest_spot", "spots_percolate_x",
                 "spots_percolate_y", "spot_radii", "gap_count", "largest_gap",
                 "gap_percolates_x", "gap_percolates_y"},
                [](const Case& one) { return one.spots_study.has_value(); },
                no_map},
    AskedTraits{
        Asked::conductance,
        "[conductance]",
        {"relative_conductance"},
        [](const Case& one) { return one.conductance_study.has_value(); },
        no_map},
    AskedTraits{
        Asked::normal_stiffness,
        "normal_stiffness of [conductance]",
        {"normal_stiffness"},
        [](const Case& one) { return one.conductance_study.has_value(); },
        no_normal_stiffness},
    AskedTraits{Asked::stress_inside,
                "stress_inside of [report]",
                {},
                [](const Case& one) { return one.report.stress_inside; },
                no_stress},
    AskedTraits{Asked::vtu,
                "vtu of [report]",
                {},
                [](const Case& one) { return one.report.vtu; },
                no_files},
    AskedTraits{Asked::layers,
                "[[material.layers]]",
                {},
                [](const Case& one) { return !one.material.layers.empty(); },
                no_layers},
    AskedTraits{
        Asked::inclusion,
        "[material.inclusion]",
        {},
        [](const Case& one) { return one.material.inclusion.has_value(); },
        no_cells},
    AskedTraits{
        Asked::variation,
        "[material.variation]",
        {},
        [](const Case& one) { return one.material.variation.has_value(); },
        no_cells},
};

} // namespace

std::span<const AskedTraits> all_asked() {
  return all_questions;
}

std::string Omission::sentence() const {
  return fmt::format("{} is not computed: {}", what, why);
}

std::vector<Omission> omissions(const Case& contact_case,
                                const MethodSpec& method) {
  std::vector<Omission> list;
  for (const AskedTraits& one : all_questions) {
    if (!one.is_in(contact_case))
      continue;
    std::string why = one.obstacle(contact_case, method);
    if (!why.empty())
      list.push_back({one.name, std::move(why)});
  }
  return list;
}

std::vector<std::string>
omission_warnings(const Case& contact_case,
                  std::span<const MethodSpec> methods) {
  std::vector<std::string> warnings;
  const auto by_none = [&](const std::string& what, const std::string& why) {
    warnings.push_back(
        fmt::format("{} is computed by none of the methods of this run{}{}",
                    what, why.empty() ? "" : ": ", why));
  };
  if (study_theory(contact_case.surface, {methods.begin(), methods.end()}) ==
      nullptr) {
    if (contact_case.magnification_study)
      by_none("[magnification]", "");
    if (contact_case.adhesion_study)
      by_none("[adhesion]", "");
  }
  for (const AskedTraits& one : all_questions) {
    if (!one.is_in(contact_case))
      continue;
    const auto has_answer = [&](const MethodSpec& method) {
      return one.obstacle(contact_case, method).empty();
    };
    std::vector<std::string> reasons; // of methods with fields
    for (const MethodSpec& method : methods)
      if (method.has_fields() && !has_answer(method))
        reasons.push_back(method.name + " " +
                          one.obstacle(contact_case, method));
    const std::string why = fmt::format("{}", fmt::join(reasons, ", "));
    const auto fields = std::ranges::count_if(methods, &MethodSpec::has_fields);
    if (std::ranges::none_of(methods, has_answer))
      by_none(one.name, why);
    else if (fields > 0 && fields == std::ssize(reasons))
      warnings.push_back(
          fmt::format("{} is computed by the theory alone: {}", one.name, why));
  }
  return warnings;
}

} // namespace asperity::cases
