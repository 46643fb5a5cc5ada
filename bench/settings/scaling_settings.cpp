#include "bench/settings/scaling_settings.hpp"

#include "bench/settings/block_settings.hpp"
#include "bench/settings/case_values.hpp"
#include "input/input_error.hpp"
#include "methods/chosen.hpp"
#include "methods/sharing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::bench {
namespace {

using cases::MethodSpec;

class ScalingPlanner {
public:
  ScalingPlanner(const cases::Case& contact_case, const ScalingOptions& options)
      : case_(contact_case), values_(contact_case), options_(options) {}

  BenchPlan plan() &&;

private:
  void add(const MethodSpec& method, bool has_ranks, bool is_weak);
  BenchPoint run_of(const MethodSpec& method, int points,
                    int realizations) const;
  bool shares_rows(const MethodSpec& method, int points, int ranks) const;
  int points_for(const MethodSpec& method, double growth, int ranks) const;
  std::size_t point(BenchPoint wanted);

  const cases::Case& case_;
  CaseValues values_;
  const ScalingOptions& options_;
  BenchPlan plan_;
};

/// Returns whether so many ranks share the rows of a single realisation.
bool ScalingPlanner::shares_rows(const MethodSpec& method, int points,
                                 int ranks) const {
  const double length = case_.surface.length.value_or(0.0);
  return methods::n_realizations(case_, method) == 1 &&
         methods::is_shared_by_ranks(method, {points, points, length, length},
                                     ranks);
}

/// Returns the next number of points per side that the method accepts and, if
/// the ranks share the rows of the case, that they can share.
int ScalingPlanner::points_for(const MethodSpec& method, double growth,
                               int ranks) const {
  const int own = case_.surface.points.value_or(0);
  if (growth == 1.0)
    return own;
  const bool needs_rows = ranks > 1 && shares_rows(method, own, ranks);
  int points = transformable_points(
      static_cast<int>(std::ceil(own * std::sqrt(growth))));
  while (!permits_points(case_, method, points) ||
         (needs_rows && !shares_rows(method, points, ranks)))
    points = transformable_points(points + 2);
  return points;
}

BenchPoint ScalingPlanner::run_of(const MethodSpec& method, int points,
                                  int realizations) const {
  BenchPoint run;
  run.method = method.name;
  run.kind = kind_of_method(method.name);
  run.points = points;
  run.nodes = realizations * std::max(1.0, double(points) * points);
  if (points != case_.surface.points.value_or(0))
    run.overrides.push_back(fmt::format("surface.points={}", points));
  if (realizations != case_.surface.realizations)
    run.overrides.push_back(
        fmt::format("surface.realizations={}", realizations));
  if (values_.is_set(method.name, "realizations"))
    run.overrides.push_back(
        fmt::format("{}.realizations={}", method.name, realizations));
  return run;
}

/// Adds a run, unless the plan has it: the first one of strong and of weak
/// scaling are often the same.
std::size_t ScalingPlanner::point(BenchPoint wanted) {
  for (std::size_t i = 0; i < plan_.points.size(); ++i) {
    const BenchPoint& known = plan_.points[i];
    if (known.method == wanted.method && known.overrides == wanted.overrides &&
        known.threads == wanted.threads && known.ranks == wanted.ranks)
      return i;
  }
  plan_.points.push_back(std::move(wanted));
  return plan_.points.size() - 1;
}

void ScalingPlanner::add(const MethodSpec& method, bool has_ranks,
                         bool is_weak) {
  ScalingSeries series{method.name, has_ranks, is_weak};
  const std::vector<int>& all = has_ranks ? options_.ranks : options_.threads;
  const int own = case_.surface.points.value_or(0);
  const bool grows_in_points = !has_ranks || methods::is_full_block(method) ||
                               shares_rows(method, own, all.back());
  for (const int workers : all) {
    const int growth = is_weak ? workers : 1;
    const int points =
        grows_in_points
            ? points_for(method, double(growth) / (is_weak ? all.front() : 1),
                         has_ranks ? workers : 1)
            : own;
    const int realizations = grows_in_points ? 1
                             : is_weak       ? workers
                                       : methods::n_realizations(case_, method);
    BenchPoint run = run_of(method, points, realizations);
    (has_ranks ? run.ranks : run.threads) = workers;
    run.label = fmt::format(
        "{}{}, {} {}",
        points > 0 ? fmt::format("{} points", points) : std::string("the map"),
        realizations > 1 ? fmt::format(", {} realisations", realizations) : "",
        workers,
        std::string(has_ranks ? "rank" : "thread") + (workers == 1 ? "" : "s"));
    series.points.push_back(point(std::move(run)));
  }
  plan_.scaling.push_back(std::move(series));
}

BenchPlan ScalingPlanner::plan() && {
  plan_.common = common_overrides(case_, case_.surface.realizations);
  const bool has_points = case_.surface.points.has_value();
  for (const MethodSpec& method :
       methods::chosen_methods(case_, options_.methods)) {
    if (kind_of_method(method.name) == "theory")
      continue;
    if (!options_.threads.empty()) {
      add(method, false, false);
      if (has_points)
        add(method, false, true);
    }
    if (options_.ranks.empty())
      continue;
    const int most = options_.ranks.back();
    const bool shares_block =
        methods::is_full_block(method) ||
        shares_rows(method, case_.surface.points.value_or(0), most);
    if (!shares_block && methods::n_realizations(case_, method) < most)
      throw input::InputError(fmt::format(
          "--ranks {}: ranks share the realisations of {}, which are {}; more "
          "of them: --set surface.realizations={}",
          most, method.name, methods::n_realizations(case_, method), most));
    add(method, true, false);
    if (has_points || !shares_block)
      add(method, true, true);
  }
  if (plan_.points.empty())
    throw input::InputError(case_.path + ": the theory takes no time that "
                                         "threads or ranks could share");
  if (!has_points)
    plan_.remarks.emplace_back("The points of a measured map are given, so "
                               "that no work grows with them.");
  return std::move(plan_);
}

} // namespace

BenchPlan scaling_of(const cases::Case& contact_case,
                     const ScalingOptions& options) {
  return ScalingPlanner(contact_case, options).plan();
}

} // namespace asperity::bench
