#include "input/types/omissions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace asperity::cases {
namespace {

using mechanics::FemSettings;
using mechanics::TheorySettings;

bool is_full_block(const MethodSpec& method) {
  const auto* const fem = method.as<mechanics::FemSettings>();
  return fem != nullptr && fem->solver == mechanics::FemSolver::full;
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

std::vector<AskedTraits>& questions() {
  static std::vector<AskedTraits> all{
      AskedTraits{"stress_inside of [report]",
                  {},
                  [](const Case& one) { return one.report.stress_inside; },
                  no_stress},
      AskedTraits{"vtu of [report]",
                  {},
                  [](const Case& one) { return one.report.vtu; },
                  no_files},
      AskedTraits{"[[material.layers]]",
                  {},
                  [](const Case& one) { return !one.material.layers.empty(); },
                  no_layers},
      AskedTraits{
          "[material.inclusion]",
          {},
          [](const Case& one) { return one.material.inclusion.has_value(); },
          no_cells},
      AskedTraits{
          "[material.variation]",
          {},
          [](const Case& one) { return one.material.variation.has_value(); },
          no_cells},
  };
  return all;
}

} // namespace

std::string no_map(const Case&, const MethodSpec& method) {
  return method.has_fields() ? "" : "has no contact map";
}

void add_question(const AskedTraits& question) {
  const auto other = std::ranges::find_if(questions(), [](const auto& one) {
    return one.name == std::string("stress_inside of [report]");
  });
  questions().insert(other, question);
}

std::span<const AskedTraits> all_asked() {
  return questions();
}

std::string Omission::sentence() const {
  return fmt::format("{} is not computed: {}", what, why);
}

std::vector<Omission> omissions(const Case& contact_case,
                                const MethodSpec& method) {
  std::vector<Omission> list;
  for (const AskedTraits& one : questions()) {
    if (one.obstacle == nullptr || !one.is_in(contact_case))
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
  for (const AskedTraits& one : questions()) {
    if (!one.is_in(contact_case))
      continue;
    if (one.obstacle == nullptr) {
      if (study_theory(contact_case.surface,
                       {methods.begin(), methods.end()}) == nullptr)
        by_none(one.name, "");
      continue;
    }
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
