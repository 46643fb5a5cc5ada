#include "reports/analysis/summary.hpp"

#include "input/types/omissions.hpp"
#include "reports/analysis/at_load.hpp"
#include "reports/analysis/claims.hpp"
#include "reports/analysis/exact.hpp"
#include "reports/analysis/rough.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/study_pages.hpp"
#include "theory/persson/persson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

namespace asperity::reports {
namespace {

using results::MethodRecord;
using results::Result;

Cost cost_of(const MethodRecord& method) {
  Cost cost;
  std::vector<double> step_times;
  for (const results::Curve& curve : method.realizations) {
    cost.setup_cpu_time += curve.setup_cpu_time;
    for (const results::CurvePoint& point : curve.points) {
      ++cost.steps;
      cost.failed_steps +=
          point.status == results::StepStatus::not_converged ? 1 : 0;
      cost.largest_iterations =
          std::max(cost.largest_iterations, point.iterations);
      cost.cpu_time += point.cpu_time;
      step_times.push_back(point.cpu_time);
    }
  }
  cost.cpu_time += cost.setup_cpu_time;
  cost.step_cpu_time =
      step_times.empty() ? not_a_number : median(std::move(step_times));
  return cost;
}

// Returns the largest penetration in the saved gap maps, in units of h_rms of
// the respective realisation.
Estimate penetration_of(const Result& result, const MethodRecord& method) {
  Estimate estimate;
  for (std::size_t r = 0; r < method.realizations.size(); ++r) {
    const results::SurfaceRecord* surface = surface_of(result, method, r);
    if (surface == nullptr)
      break;
    const double rms_height = surface->rms_height;
    bool has_map = false;
    for (const results::Fields& fields : method.realizations[r].fields) {
      if (fields.gap_map().empty())
        continue;
      const double lowest = results::extremes_of(fields.gap_map()).least;
      estimate.value =
          std::fmax(estimate.value, std::fmax(0.0, -lowest) / rms_height);
      has_map = true;
    }
    estimate.realizations += has_map ? 1 : 0;
  }
  estimate.remark = estimate.has_value() ? "largest of the saved maps"
                                         : "no gap map is in the result";
  return estimate;
}

// Runs `work` and records its failure. Other quantities and the report do not
// depend on the problems that one quantity encounters in a curve or a map.
template <class Work>
void attempt(MethodSummary& summary, const char* what, const Work& work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    throw; // a system error, not a property of the data
  } catch (const std::exception& error) {
    summary.problems.push_back(fmt::format("{}: {}", what, error.what()));
  }
}

MethodSummary summarize_method(const Result& result,
                               const cases::Case& contact_case,
                               const MethodRecord& method,
                               const MethodRecord* reference,
                               SurfaceTheories& theories) {
  MethodSummary summary;
  summary.name = method.name;
  summary.kind = method.kind;
  summary.description = method.description;
  if (const cases::MethodSpec* const spec = spec_of(contact_case, method))
    for (const cases::Omission& one : cases::omissions(contact_case, *spec))
      summary.omissions.push_back(one.sentence());
  summary.cost = cost_of(method);
  summary.certified = certified_of(result, method);
  if (is_adhesive(contact_case, method))
    attempt(summary, "adhesion", [&] {
      add_adhesion_quantities(result, contact_case, method, summary);
    });
  else if (is_exact_shape(contact_case))
    attempt(summary, "exact solution", [&] {
      add_exact_quantities(result, contact_case, method, summary);
    });
  else {
    attempt(summary, "fits", [&] {
      add_rough_quantities(result, contact_case, method, reference, theories,
                           summary);
    });
    summary.fits.resize(method.realizations.size());
    attempt(summary, "claims", [&] {
      add_claim_quantities(result, contact_case, method, reference, summary);
    });
  }
  if (contact_case.material.is_uniform())
    attempt(summary, "stiffness", [&] {
      add_stiffness_quantities(result, contact_case, method, summary);
    });
  if (method.kind != "theory") {
    Estimate iterations;
    iterations.value = summary.cost.largest_iterations;
    iterations.realizations = static_cast<int>(method.realizations.size());
    iterations.remark = "largest of all steps";
    summary.quantities["iterations_max"] = iterations;
    summary.quantities["penetration"] = penetration_of(result, method);
  }
  return summary;
}

/// Adds epsilon of Eq. (16) of Yang and Persson (2008) to a theory.
void add_epsilon(const cases::Case& contact_case, const MethodRecord& method,
                 MethodSummary& summary) {
  const auto* const theory =
      settings_of<mechanics::TheorySettings>(contact_case, method);
  if (theory == nullptr ||
      theory->loss_factor != mechanics::LossFactor::yang_persson)
    return;
  summary.quantities["epsilon"] = single_number(
      theory::persson_epsilon(theory->gamma), "from the formula", "");
}

} // namespace

const MethodSummary* method_called(std::span<const MethodSummary> methods,
                                   const std::string& name) {
  const auto found = std::ranges::find(methods, name, &MethodSummary::name);
  return found == methods.end() ? nullptr : &*found;
}

Summary summarize(const Result& result, const cases::Case& contact_case) {
  Summary summary;
  summary.case_name = result.case_name;
  summary.case_title = result.case_title;
  summary.case_hash = result.case_hash;
  summary.status = result.status;
  summary.provenance = result.provenance;
  const MethodRecord* whole = reference_theory(result, contact_case, {});
  if (whole != nullptr)
    summary.reference_method = whole->name;
  std::vector<cases::ReferenceValue> references;
  if (!result.reference.empty())
    references = cases::read_reference_text(result.reference,
                                            result.path + ": reference");
  const std::vector<std::string> at_load =
      names_at_load(contact_case.expectations, references);
  SurfaceTheories theories(result);
  for (const MethodRecord& method : result.methods) {
    const MethodRecord* reference =
        reference_theory(result, contact_case, method);
    summary.methods.push_back(
        summarize_method(result, contact_case, method, reference, theories));
    MethodSummary& mine = summary.methods.back();
    attempt(mine, "quantities at a load", [&] {
      add_quantities_at_load(result, contact_case, method, reference, at_load,
                             mine);
    });
    add_epsilon(contact_case, method, mine);
    for (const StudyPages* const study : study_pages())
      if (study->add_quantities != nullptr)
        attempt(mine, study->name.c_str(), [&] {
          study->add_quantities(result, contact_case, method, at_load, mine);
        });
  }
  summary.verdicts = judge(contact_case.expectations, summary.methods,
                           result.status == "complete");
  summary.published = beside_ours(references, summary.methods);
  return summary;
}

} // namespace asperity::reports
