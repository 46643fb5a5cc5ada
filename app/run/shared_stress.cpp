#include "app/run/shared_stress.hpp"

#include "app/methods/shared_load_steps.hpp"
#include "fem/plugin.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <functional>
#include <stdexcept>
#include <utility>

#include "ranks/rank_sums.hpp"
#include "ranks/rows_from_rank_0.hpp"
#include "ranks/workers.hpp"

namespace asperity::app {
namespace {

using contact::StressInside;
using Json = nlohmann::json;

constexpr const char* stress_key = "shared stress";

/// Fills a span with the next values of a map. It is empty on other ranks than
/// rank 0.
using NextValues = std::function<void(std::span<double>)>;

NextValues next_of(const results::Fields& map) {
  return [&map, at = std::size_t{0}](std::span<double> values) mutable {
    std::vector<double> read;
    std::ranges::copy(map.pressure_map().values(at, values.size(), read),
                      values.begin());
    at += values.size();
  };
}

/// The own rows of a map. If rank 0 cannot read it, the ranks exchange zeros in
/// place of what is missing and then all throw, so that none waits for another
/// and the module reports the failure of rank 0.
std::vector<double> own_rows(const SharedRows& rows, const NextValues& next) {
  std::exception_ptr failure;
  std::vector<double> own =
      rows_from_rank_0(rows, [&](std::span<double> values) {
        if (failure)
          return;
        try {
          next(values);
        } catch (...) {
          failure = std::current_exception();
        }
      });
  if (rank_max(rows.ranks(), failure ? 1.0 : 0.0) == 0.0)
    return own;
  if (failure)
    std::rethrow_exception(failure);
  throw std::runtime_error("rank 0 could not read the map");
}

/// Receives the own rows of a map and finds the spectrum of all.
StressInside stress_in(const Json& command, const NextValues& next) {
  const Json& points = command.at("grid");
  const Grid grid{points.at(0), points.at(1), points.at(2), points.at(3)};
  RankGroup& ranks = fem::load_fem_module().rank_group();
  SharedRows rows(grid, ranks, row_bounds(grid, ranks.size()));
  const std::vector<double> pressure = own_rows(rows, next);
  return {std::move(rows), block_in(command.at("block")), pressure,
          command.at("threads").get<int>()};
}

StressPoint strongest_part(const Json& command, const NextValues& next) {
  return point_of(stress_in(command, next));
}

std::vector<std::vector<double>> rows_part(const Json& command,
                                           const NextValues& next) {
  const StressInside inside = stress_in(command, next);
  std::vector<std::vector<double>> rows;
  for (const double depth : command.at("depths"))
    rows.push_back(inside.von_mises_row(depth, command.at("row")));
  return rows;
}

Json command_for(const char* what, const StressUnderMaps& stress,
                 const Grid& grid) {
  return {
      {stress_key, what},
      {"block", json_of_block(stress.block())},
      {"grid", {grid.points_x, grid.points_y, grid.length_x, grid.length_y}},
      {"threads", stress.threads()}};
}

} // namespace

StressPoint SharedStress::strongest(const results::Fields& map) const {
  const Json command = command_for("strongest", *this, map.grid);
  StressPoint found;
  fem::load_fem_module().on_all_ranks(
      command.dump(), [&](const std::string&, int) {
        found = strongest_part(command, next_of(map));
      });
  return found;
}

std::vector<std::vector<double>>
SharedStress::von_mises_rows(const results::Fields& map,
                             std::span<const double> depths, int row) const {
  Json command = command_for("rows", *this, map.grid);
  command["depths"] = std::vector<double>(depths.begin(), depths.end());
  command["row"] = row;
  std::vector<std::vector<double>> found;
  fem::load_fem_module().on_all_ranks(
      command.dump(), [&](const std::string&, int) {
        found = rows_part(command, next_of(map));
      });
  return found;
}

bool is_for_shared_stress(const std::string& text) {
  return Json::parse(text).contains(stress_key);
}

void follow_shared_stress(const std::string& text) {
  const Json command = Json::parse(text);
  if (command.at(stress_key) == "strongest")
    static_cast<void>(strongest_part(command, {}));
  else
    static_cast<void>(rows_part(command, {}));
}

} // namespace asperity::app
