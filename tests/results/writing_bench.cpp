// The cost of writing a step of a result: bytes that reach the file system, and
// CPU time, for any content of the file.
#include "base/cpu_clock.hpp"
#include "results/result_writer.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace {

using namespace asperity;

/// Bytes that this process has passed to write().
double bytes_written() {
  std::ifstream counters("/proc/self/io");
  for (std::string word; counters >> word;)
    if (double bytes = 0.0; word == "wchar:" && counters >> bytes)
      return bytes;
  return 0.0;
}

results::SurfaceRecord surface_on(int points) {
  results::SurfaceRecord surface;
  surface.grid = {points, points, 1e-6, 1e-6};
  for (std::size_t i = 0; i < surface.grid.size(); ++i)
    surface.heights.push_back(1e-9 * std::sin(0.37 * static_cast<double>(i)));
  return surface;
}

/// A run of ten realisations with 16 loads, one of them with maps, on this
/// number of points per side.
void write_run(benchmark::State& state) {
  constexpr int realizations = 10;
  constexpr int loads = 16;
  const results::SurfaceRecord surface =
      surface_on(static_cast<int>(state.range(0)));
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("asperity-writing-" + std::to_string(::getpid()));
  double cpu_time = 0.0;
  double bytes = 0.0;
  for (auto _ : state) {
    const double before = bytes_written();
    results::ResultWriter writer(folder, {"bench", "bench", "", "", 1.0});
    for (int r = 0; r < realizations; ++r)
      writer.record_surface(r, surface);
    writer.begin_method("halfspace", "halfspace", "");
    for (int r = 0; r < realizations; ++r)
      for (int step = 0; step < loads; ++step) {
        results::CurvePoint point;
        point.step = step;
        if (r == 0 && step == loads - 1)
          writer.append_step_with_fields(
              "halfspace", r, point, surface.grid,
              {step, 1.0, surface.heights, surface.heights, {}});
        else
          writer.append_step("halfspace", r, point);
      }
    cpu_time = writer.cpu_time();
    const CpuClock clock;
    writer.finish("complete");
    cpu_time += clock.seconds();
    bytes = bytes_written() - before;
    std::filesystem::remove_all(folder);
  }
  state.counters["CPU s a run"] = cpu_time;
  state.counters["MB a run"] = bytes * 1e-6;
}

/// Rows in a file that also holds the heights of this number of points per
/// side.
void write_rows(benchmark::State& state) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("asperity-rows-" + std::to_string(::getpid()));
  results::ResultWriter writer(folder, {"bench", "bench", "", "", 1.0});
  writer.record_surface(0, surface_on(static_cast<int>(state.range(0))));
  writer.begin_method("fem", "fem", "");
  results::CurvePoint point;
  const double before = bytes_written();
  for (auto _ : state) {
    writer.append_step("fem", 0, point);
    ++point.step;
  }
  state.counters["bytes a row"] = (bytes_written() - before) / point.step;
  std::filesystem::remove_all(folder);
}

BENCHMARK(write_rows)->Arg(64)->Arg(512)->Arg(2048);
BENCHMARK(write_run)->Arg(256)->Arg(2048)->Iterations(1);

} // namespace
