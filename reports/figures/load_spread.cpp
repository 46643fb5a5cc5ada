#include "reports/figures/load_spread.hpp"

#include <vector>

namespace asperity::reports {
namespace {

std::vector<std::string> header_of(const std::string& quantity,
                                   const std::string& zeros) {
  std::vector<std::string> header{"curve",
                                  "index",
                                  "p [MPa]",
                                  quantity,
                                  "least " + quantity,
                                  "largest " + quantity};
  if (!zeros.empty())
    header.push_back(zeros);
  return header;
}

} // namespace

SpreadPanel::SpreadPanel(const std::string& quantity, double unit,
                         const std::string& zeros)
    : unit_(unit),
      has_zeros_(!zeros.empty()),
      table_(header_of(quantity, zeros)) {}

void SpreadPanel::add(const std::string& label, CurveStyle style,
                      const SpreadCurve& curve) {
  const bool has_spread = style.has_markers;
  std::size_t rows = 0;
  for (const auto& [step, at] : curve) {
    if (at.count == 0)
      continue;
    std::vector<double> row{static_cast<double>(next_), at.pressure * 1e-6,
                            at.mean() / unit_, at.low / unit_, at.high / unit_};
    if (has_zeros_)
      row.push_back(static_cast<double>(at.zeros));
    table_.add(label, row);
    ++rows;
  }
  if (rows == 0)
    return;
  ChartCurve& drawn = panel_.add(label, std::move(style), next_++, 3, 4);
  if (has_spread) {
    drawn.low = 5;
    drawn.high = 6;
  }
}

void SpreadPanel::move_to(Figure& figure, const std::string& label) {
  panel_.x = {.label = "nominal pressure  [MPa]", .is_log = true};
  panel_.y = {.label = label, .is_log = true, .has_powers = true};
  figure.panels = {std::move(panel_)};
  figure.data = table_.text();
}

} // namespace asperity::reports
