// Shows partial slip as rows of the page.
#include "reports/analysis/partial_slip.hpp"
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::reports {
namespace {

std::string four_digits(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "–";
}

/// "16.71; 23.87": along x and along y, or one number if they are equal.
std::string along_both(double unit, const SlipSpreads& spreads) {
  const std::string x = four_digits(unit * spreads.x.mean);
  const std::string y = four_digits(unit * spreads.y.mean);
  return x == y ? x : x + "; " + y;
}

} // namespace

kainjow::mustache::list slip_rows(const ReportEntry& entry) {
  kainjow::mustache::list rows;
  for (const results::MethodRecord& method : entry.result->methods)
    for (const SlipPoint& point : slip_points(
             partial_slips(*entry.result, *entry.contact_case, method))) {
      kainjow::mustache::data row;
      row.set("name", method.name);
      row.set("share", fmt::format("{:.3g}", point.share));
      row.set("stress", four_digits(1e-6 * point.tangential_stress));
      row.set("displacement", along_both(1e9, point.displacement));
      row.set("stick", four_digits(point.stick.mean));
      row.set("stiffness", along_both(1e-15, point.stiffness));
      row.set("loss", along_both(1.0, point.loss));
      rows.push_back(row);
    }
  return rows;
}

std::string slip_note(const ReportEntry& entry) {
  const cases::Case& contact_case = *entry.contact_case;
  std::string load;
  for (const results::MethodRecord& method : entry.result->methods)
    if (const auto curves = partial_slips(*entry.result, contact_case, method);
        load.empty() && !curves.empty())
      load = fmt::format(" of {:.4g} MPa A_0",
                         1e-6 * curves.front().front().pressure);
  const double beta = mechanics::coupling(contact_case.material);
  return fmt::format(
      "A tangential load Q acts under a constant normal load P{}, with the "
      "friction coefficient {:g}: Q = {:g} (P − P'), where the nodes "
      "in contact at the lighter load P' stick and the others slip. The loss "
      "is that of a cycle between Q and −Q, per nominal area. Two numbers "
      "are those of Q along x and along y. Tangential compliance over normal "
      "compliance, mean over the directions: {:.4g}. {}",
      load, contact_case.friction_study->coefficient,
      contact_case.friction_study->coefficient,
      mechanics::tangential_ratio(contact_case.material),
      std::abs(beta) < 1e-12
          ? "Normal and tangential tractions of this pair do not couple."
          : fmt::format("The coupling of normal and tangential tractions of "
                        "this pair, Dundurs' β = {:.3g}, is neglected.",
                        beta));
}

} // namespace asperity::reports
