#include "run/distributed/share.hpp"

#include "base/require.hpp"
#include "input/input_error.hpp"
#include "methods/chosen.hpp"
#include "methods/surfaces_of_case.hpp"
#include "run/plan/needs.hpp"
#include "run/plan/skipped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

namespace asperity::run {
namespace {

std::optional<int> positive_integer(std::string_view text) {
  int number = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number < 1)
    return std::nullopt;
  return number;
}

std::vector<double> costs_with(const cases::Case& contact_case,
                               const std::vector<cases::MethodSpec>& methods) {
  const Grid grid = grid_of_case(contact_case, methods);
  const int members =
      methods::needs_surfaces(methods) ? contact_case.surface.realizations : 1;
  std::vector<double> costs(static_cast<std::size_t>(members), 0.0);
  for (const cases::MethodSpec& method : methods) {
    const double cost = needs_of(contact_case, method, grid).unknowns *
                        static_cast<double>(contact_case.load.targets.size());
    for (int r = 0; r < methods::n_realizations(contact_case, method); ++r)
      costs[static_cast<std::size_t>(r)] += cost;
  }
  return costs;
}

} // namespace

Part read_part(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const std::string_view whole = text;
    const auto number = positive_integer(whole.substr(0, slash));
    const auto count = positive_integer(whole.substr(slash + 1));
    if (number && count && *number <= *count)
      return {*number, *count};
  }
  throw input::InputError(fmt::format(
      "--part {}: must be I/N with integers 1 <= I <= N, for example 3/8",
      text));
}

std::string part_text(const Part& part) {
  return fmt::format("{}/{}", part.number, part.count);
}

std::vector<std::vector<std::size_t>> shares(const std::vector<double>& costs,
                                             int n_parts) {
  if (n_parts < 1)
    refuse_argument("n_parts", n_parts, "at least 1");
  for (const double cost : costs)
    require_not_negative("costs", cost, "1");
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(
      order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });

  using Load = std::pair<double, std::size_t>; // cost and number of members
  std::vector<Load> loads(static_cast<std::size_t>(n_parts));
  std::vector<std::vector<std::size_t>> parts(loads.size());
  for (const std::size_t member : order) {
    const auto least = std::ranges::min_element(loads);
    *least = {least->first + costs[member], least->second + 1};
    parts[static_cast<std::size_t>(least - loads.begin())].push_back(member);
  }
  for (std::vector<std::size_t>& part : parts)
    std::ranges::sort(part);
  return parts;
}

std::vector<double>
realization_costs(const cases::Case& contact_case,
                  const std::vector<cases::MethodSpec>& methods) {
  return costs_with(contact_case, methods);
}

std::vector<double> point_costs(const cases::CaseSweep& sweep,
                                const std::vector<std::string>& methods,
                                bool is_exact) {
  std::vector<double> costs;
  for (const cases::SweptPoint& point : sweep.points) {
    const std::vector<double> of_point = costs_with(
        point.contact_case,
        methods::chosen_methods(point.contact_case, methods, is_exact));
    costs.push_back(std::accumulate(of_point.begin(), of_point.end(), 0.0));
  }
  return costs;
}

} // namespace asperity::run
