#include "reports/plot_parts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::reports {

std::string of_series(std::size_t index, const std::string& columns) {
  const std::size_t x_end = columns.find(':');
  return fmt::format("using ($2=={} ? {} : NaN):{}", index,
                     columns.substr(0, x_end), columns.substr(x_end + 1));
}

std::string plot_of(const std::vector<std::string>& parts) {
  std::string text = "plot ";
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : ", \\\n  ") + parts[i];
  return text + "\n";
}

double round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= step)
      return digit * power;
  return 10.0 * power;
}

std::string joined_words(std::span<const Series> series) {
  std::string names;
  for (const Series& one : series)
    if (!one.is_drawn)
      names += (names.empty() ? "" : ", ") + one.label;
  return names.empty() ? ""
                       : fmt::format(" Not drawn because they would lie on the "
                                     "signs of their method: {}.",
                                     names);
}

const Estimate& quantity(const Series& series, const std::string& name) {
  static const Estimate none;
  const auto found = series.method->quantities.find(name);
  return found == series.method->quantities.end() ? none : found->second;
}

const Series* first_numerical(std::span<const Series> series) {
  for (const Series& one : series)
    if (!one.is_theory() && !one.rows.empty())
      return &one;
  return nullptr;
}

const Series* theory_of(std::span<const Series> series, const Series& method) {
  for (const Series& one : series)
    if (one.is_theory() && one.entry == method.entry && !one.rows.empty())
      return &one;
  return nullptr;
}

std::vector<std::size_t> three_of(std::size_t count) {
  std::vector<std::size_t> chosen;
  for (const std::size_t i : {std::size_t{0}, count / 2, count - 1})
    if (count > 0 && (chosen.empty() || chosen.back() < i))
      chosen.push_back(i);
  return chosen;
}

} // namespace asperity::reports
