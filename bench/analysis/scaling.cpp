#include "bench/analysis/scaling.hpp"

#include "bench/analysis/bench_answer.hpp"

namespace asperity::bench {

std::vector<ScalingRow> scaling_rows(const Bench& bench,
                                     const ScalingSeries& series) {
  std::vector<ScalingRow> rows;
  const auto workers = [&](const BenchPoint& point) {
    return series.has_ranks ? point.ranks : point.threads;
  };
  const BenchPoint& first = bench.points[series.points.front()];
  if (!first.problem.empty())
    return rows;
  for (const std::size_t i : series.points) {
    const BenchPoint& point = bench.points[i];
    if (!point.problem.empty())
      continue;
    ScalingRow row{.point = i, .workers = workers(point)};
    const double work = point.nodes / first.nodes;
    row.speed_up = work * first.wall.median / point.wall.median;
    row.efficiency = row.speed_up * workers(first) / row.workers;
    row.cpu_ratio = point.cpu.median / first.cpu.median / work;
    row.has_same_bits =
        series.is_weak || have_same_bits(first.answer, point.answer);
    rows.push_back(row);
  }
  return rows;
}

} // namespace asperity::bench
