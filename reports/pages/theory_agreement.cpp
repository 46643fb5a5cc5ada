#include "reports/pages/theory_agreement.hpp"

#include "reports/analysis/comparison.hpp"
#include "reports/analysis/rough.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

using results::CurvePoint;
using results::MethodRecord;

double value_of(const MethodSummary& method, const std::string& quantity) {
  const auto found = method.quantities.find(quantity);
  return found == method.quantities.end() ? not_a_number : found->second.value;
}

/// Returns the load of realisation 0 at which the areas differ most.
const Deviation* furthest_apart(const std::vector<Deviation>& rows) {
  const Deviation* furthest = nullptr;
  double largest = 0.0;
  for (const Deviation& row : rows)
    if (const double apart =
            std::abs(row.area_fraction - row.reference_area_fraction);
        apart > largest) { // false for NaN
      furthest = &row;
      largest = apart;
    }
  return furthest;
}

std::string area_words(const ReportEntry& entry, const MethodRecord& method,
                       const MethodRecord& theory, AreaColumn area,
                       double scale) {
  std::string words = fmt::format(
      "The theory does not describe the contact area on this surface: that of "
      "{} is {:.3g} times the theory's over all loads, outside {:.2f} to "
      "{:.2f}, where published simulations of Gaussian surfaces lie.",
      method.name, scale, 1.0 / largest_area_scale, largest_area_scale);
  const std::vector<Deviation> rows =
      deviations(method.realizations.front().points,
                 CurveFunction(curve_of(theory, 0).points), area);
  if (const Deviation* row = furthest_apart(rows))
    words += fmt::format(" At p/E* = {:.3g} the theory has {:.3g} % of contact "
                         "and {} {:.3g} %.",
                         row->nominal_pressure / entry.result->contact_modulus,
                         100.0 * row->reference_area_fraction, method.name,
                         100.0 * row->area_fraction);
  return words;
}

} // namespace

std::vector<std::string> theory_disagreements(const ReportEntry& entry) {
  std::vector<std::string> sentences;
  for (std::size_t m = 0; m < entry.summary.methods.size(); ++m) {
    const MethodSummary& summary = entry.summary.methods[m];
    const MethodRecord& method = entry.result->methods[m];
    const MethodRecord* theory =
        reference_theory(*entry.result, *entry.contact_case, method);
    if (theory == nullptr || method.kind == "theory" ||
        method.realizations.empty())
      continue;
    const bool has_corrected =
        std::isfinite(value_of(summary, "area_scale_corrected"));
    const double scale = value_of(
        summary, has_corrected ? "area_scale_corrected" : "area_scale");
    if (scale > largest_area_scale || scale < 1.0 / largest_area_scale)
      sentences.push_back(area_words(entry, method, *theory,
                                     has_corrected
                                         ? &CurvePoint::area_fraction_corrected
                                         : &CurvePoint::area_fraction,
                                     scale));
    const double apart = value_of(summary, "gap_deviation");
    if (apart > largest_gap_difference)
      sentences.push_back(
          fmt::format("The theory does not describe the separation on this "
                      "surface: that of {} is up to {:.2g} h_rms from the "
                      "theory's at the same load (where 0.3 < u/h_rms < 1.5; "
                      "differences above {:g} are reported here).",
                      method.name, apart, largest_gap_difference));
  }
  return sentences;
}

} // namespace asperity::reports
