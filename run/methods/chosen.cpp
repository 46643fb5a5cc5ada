#include "run/methods/chosen.hpp"

#include "input/input_error.hpp"
#include "input/nearest.hpp"
#include "input/reader/study_keys.hpp"

#include <algorithm>

namespace asperity::methods {

using cases::MethodSpec;

std::vector<MethodSpec> chosen_methods(const cases::Case& contact_case,
                                       const AskedMethods& asked) {
  std::set<std::string> known;
  for (const MethodSpec& method : contact_case.methods) {
    known.insert(method.name);
    known.insert(cases::kind_of_method(method.name));
  }
  for (const std::string& name : asked.names)
    if (!known.contains(name))
      throw input::InputError(
          "--methods " + name + ": " + contact_case.path +
          " has no such method; nearest: " +
          input::nearest(name, {known.begin(), known.end()}));
  const auto has = [&](const std::string& name) {
    return std::ranges::find(asked.names, name) != asked.names.end();
  };
  std::vector<MethodSpec> chosen;
  for (const MethodSpec& method : contact_case.methods)
    if (asked.names.empty() || has(method.name) ||
        (!asked.is_exact && has(cases::kind_of_method(method.name))))
      chosen.push_back(method);
  return chosen;
}

int n_realizations(const cases::Case& contact_case, const MethodSpec& method) {
  const int all = contact_case.surface.realizations;
  if (!method.needs_surface())
    return 1;
  return std::min(method.realizations.value_or(all), all);
}

std::vector<int> realizations_of(const cases::Case& contact_case,
                                 const MethodSpec& method,
                                 const std::set<int>& only) {
  std::vector<int> realizations;
  for (int r = 0; r < n_realizations(contact_case, method); ++r)
    if (only.empty() || only.contains(r))
      realizations.push_back(r);
  return realizations;
}

std::set<std::size_t> steps_with_fields(const cases::Case& contact_case) {
  const std::size_t n_steps = contact_case.load.targets.size();
  const std::size_t wanted = std::min(
      n_steps,
      static_cast<std::size_t>(std::max(contact_case.report.fields, 0)));
  std::set<std::size_t> steps;
  for (std::size_t k = 0; k < wanted; ++k)
    steps.insert((2 * k + 1) * n_steps / (2 * wanted));
  for (const cases::StudyKeys* const study : cases::known_studies())
    if (wanted > 0 && study->saved_steps != nullptr &&
        study->is_asked(contact_case)) {
      const std::vector<std::size_t> saved = study->saved_steps(contact_case);
      steps.insert(saved.begin(), saved.end());
    }
  return steps;
}

bool is_full_block(const MethodSpec& method) {
  const auto* fem = std::get_if<mechanics::FemSettings>(&method.settings);
  return fem != nullptr && fem->solver == mechanics::FemSolver::full;
}

bool conducts_in_block(const MethodSpec& method) {
  const auto* fem = std::get_if<mechanics::FemSettings>(&method.settings);
  return is_full_block(method) && fem->full.bodies == 1;
}

const mechanics::ContactSettings* convex_contact(const MethodSpec& method) {
  return method.is_adhesive() || is_full_block(method) ? nullptr
                                                       : method.contact();
}

std::optional<std::size_t> step_with_section(const cases::Case& contact_case,
                                             const MethodSpec& method,
                                             const mechanics::Scales& scales) {
  const std::set<std::size_t> steps = steps_with_fields(contact_case);
  if (!contact_case.report.stress_inside || !is_full_block(method) ||
      steps.empty())
    return std::nullopt;
  const mechanics::LoadingPath& load = contact_case.load;
  const double sign =
      load.control == mechanics::Control::nominal_pressure ? 1.0 : -1.0;
  const auto weight = [&](std::size_t step) {
    return sign * load.targets[step].in_si(scales);
  };
  return *std::max_element(
      steps.begin(), steps.end(),
      [&](std::size_t a, std::size_t b) { return weight(a) < weight(b); });
}

bool asks_conduction(const cases::Case& contact_case,
                     const cases::MethodSpec& method) {
  return conducts_in_block(method) &&
         std::ranges::any_of(cases::known_studies(), [&](const auto* study) {
           return study->conducts && study->is_asked(contact_case);
         });
}

} // namespace asperity::methods
