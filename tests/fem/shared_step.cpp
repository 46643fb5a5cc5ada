// Solves one load step of a rough surface on a half-space or a condensed
// block on the ranks of mpirun and prints on rank 0 a hash of the fields, the
// cost and the memory of each rank. The measurements of
// docs/numerics/shared-rows-measurements.md are made with it.
//
// Arguments: points per side, or as 600x500, threads per rank, "ranks" or
// "alone" (one process without MPI); then "q1" or "q2" for a block, "free" for
// a half-space with free boundaries, or "fail" to let the last rank fail in its
// third transform.
#include "base/content_hash.hpp"
#include "base/cpu_clock.hpp"
#include "base/peak_memory.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "fem/parallel/mpi_group.hpp"
#include "fem/parallel/ranks.hpp"
#include "fem/waves/condensed_q1.hpp"
#include "fem/waves/q2_operator.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

namespace asperity {
namespace {

/// A wave of the surface: wavenumbers, amplitude, phase.
struct Wave {
  double i, j, amplitude, phase;
};

/// 100 waves of wavelengths from L/4 to L/128, self-affine with H = 0.8.
std::vector<Wave> random_waves() {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Wave> waves;
  for (int k = 0; k < 100; ++k) {
    const double size = 4.0 * std::pow(32.0, unit(random));
    const double angle = 2.0 * std::numbers::pi * unit(random);
    waves.push_back(
        {std::round(size * std::cos(angle)), std::round(size * std::sin(angle)),
         1e-2 * std::pow(size, -0.8), 2.0 * std::numbers::pi * unit(random)});
  }
  return waves;
}

/// Heights of the rows of this process, the same on any number of ranks.
std::vector<double> heights_of(const SharedRows& rows) {
  const Grid& grid = rows.grid();
  std::vector<double> heights(rows.size());
  std::vector<double> cosine(rows.width()), sine(rows.width());
  for (const Wave& wave : random_waves()) {
    for (std::size_t ix = 0; ix < rows.width(); ++ix) {
      const double angle = 2.0 * std::numbers::pi * wave.i *
                           static_cast<double>(ix) / grid.points_x;
      cosine[ix] = wave.amplitude * std::cos(angle);
      sine[ix] = wave.amplitude * std::sin(angle);
    }
    for (int iy = 0; iy < rows.count(); ++iy) {
      const double angle = wave.phase + 2.0 * std::numbers::pi * wave.j *
                                            (rows.first() + iy) / grid.points_y;
      const double c = std::cos(angle), s = std::sin(angle);
      double* const row = &heights[grid.index(0, iy)];
      for (std::size_t ix = 0; ix < rows.width(); ++ix)
        row[ix] += c * cosine[ix] - s * sine[ix];
    }
  }
  return heights;
}

/// Forwards to a shared operator until the third change of pressure.
class FailingOperator final : public contact::SurfaceOperator {
public:
  explicit FailingOperator(std::unique_ptr<contact::SurfaceOperator> sound)
      : sound_(std::move(sound)) {}

  std::unique_ptr<contact::SurfaceOperator> clone() const override {
    return std::make_unique<FailingOperator>(sound_->clone());
  }

  const Grid& grid() const override { return sound_->grid(); }

  const SharedRows* shared_rows() const override {
    return sound_->shared_rows();
  }

  std::span<const double> nodal_weights() const override { return {}; }

  void displacement(std::span<const double> pressure,
                    std::span<double> displacement) override {
    sound_->displacement(pressure, displacement);
  }

  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change) override {
    if (++calls_ == 3)
      throw std::runtime_error("the third transform failed on purpose");
    sound_->displacement_change(pressure_change, displacement_change);
  }

  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure) override {
    sound_->pressure_estimate(gap, local_compliance, pressure);
  }

  double short_wave_compliance() const override {
    return sound_->short_wave_compliance();
  }

  std::unique_ptr<contact::SurfaceOperator> coarsened() const override {
    return sound_->coarsened();
  }

private:
  std::unique_ptr<contact::SurfaceOperator> sound_;
  int calls_ = 0;
};

/// The bytes of all ranks in their order, where each rank has `own`.
std::string gathered_text(const SharedRows& rows, const std::string& own) {
  if (rows.ranks() == nullptr)
    return own;
  RankGroup& ranks = *rows.ranks();
  std::vector<std::size_t> sizes(static_cast<std::size_t>(ranks.size()));
  const std::size_t size = own.size();
  ranks.gather_to_all(std::as_bytes(std::span(&size, 1)),
                      std::vector(sizes.size(), sizeof size),
                      std::as_writable_bytes(std::span(sizes)));
  std::string all(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}),
                  ' ');
  ranks.gather_to_all(std::as_bytes(std::span(own)), sizes,
                      std::as_writable_bytes(std::span(all)));
  return all;
}

/// A hash of the hashes of all rows, which are equal on any number of ranks.
std::string hash_of(const SharedRows& rows, std::span<const double> field) {
  std::string hashes;
  for (std::size_t at = 0; at < field.size(); at += rows.width())
    hashes += content_hash({reinterpret_cast<const char*>(&field[at]),
                            rows.width() * sizeof(double)});
  return content_hash(gathered_text(rows, hashes));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

/// Counts what a rank sends to the others.
class CountingGroup final : public RankGroup {
public:
  explicit CountingGroup(RankGroup& ranks) : ranks_(ranks) {}

  int rank() const override { return ranks_.rank(); }

  int size() const override { return ranks_.size(); }

  void gather_to_all(std::span<const std::byte> own,
                     std::span<const std::size_t> counts,
                     std::span<std::byte> all) override {
    sent_ += static_cast<double>(own.size()) * (size() - 1);
    ++calls_;
    ranks_.gather_to_all(own, counts, all);
  }

  void exchange(std::span<const std::byte> sent,
                std::span<const std::size_t> sent_counts,
                std::span<std::byte> received,
                std::span<const std::size_t> received_counts) override {
    const auto own = static_cast<std::size_t>(rank());
    for (std::size_t r = 0; r < sent_counts.size(); ++r)
      sent_ += r == own ? 0.0 : static_cast<double>(sent_counts[r]);
    ++calls_;
    ranks_.exchange(sent, sent_counts, received, received_counts);
  }

  void pass(Direction direction, std::span<const std::byte> sent,
            std::span<std::byte> received) override {
    sent_ += size() > 1 ? static_cast<double>(sent.size()) : 0.0;
    ++calls_;
    ranks_.pass(direction, sent, received);
  }

  double sent() const { return sent_; } ///< [B]

  double calls() const { return calls_; }

private:
  RankGroup& ranks_;
  double sent_ = 0.0, calls_ = 0.0;
};

CountingGroup& counting_group() {
  static CountingGroup group(fem::mpi_group());
  return group;
}

/// A number of each rank.
std::vector<double> of_ranks(const SharedRows& rows, double own) {
  if (rows.ranks() == nullptr)
    return {own};
  std::vector<double> all(static_cast<std::size_t>(rows.ranks()->size()));
  const std::vector<std::size_t> counts(all.size(), sizeof(double));
  rows.ranks()->gather_to_all(std::as_bytes(std::span(&own, 1)), counts,
                              std::as_writable_bytes(std::span(all)));
  return all;
}

/// A clamped block as deep as wide, in layers that grow by a factor 1.2.
fem::LayeredBlock layered_block(const Grid& grid) {
  std::vector<double> layers;
  double depth = 0.0;
  for (double layer = grid.spacing_x(); depth < grid.length_x; layer *= 1.2) {
    layers.push_back(layer);
    depth += layer;
  }
  return fem::homogeneous_block(layers, 1.0, 0.3,
                                mechanics::FarBoundary::clamped);
}

struct NamedCases {
  Grid grid;
  int threads = 1;
  bool is_alone = false, fails = false, is_q1 = false, is_q2 = false,
       is_free = false;
};

std::unique_ptr<contact::SurfaceOperator>
elasticity_of(const NamedCases& asked) {
  const mechanics::ElasticBlock half_space{
      1.0, 0.3, std::numeric_limits<double>::infinity(),
      mechanics::FarBoundary::clamped};
  const Grid& grid = asked.grid;
  if (asked.is_free && asked.is_alone)
    return std::make_unique<contact::FreeHalfspace>(grid, 1.0, asked.threads);
  if (asked.is_free)
    return std::make_unique<contact::FreeHalfspace>(grid, counting_group(), 1.0,
                                                    asked.threads);
  if (asked.is_q2 && asked.is_alone)
    return std::make_unique<fem::Q2Operator>(
        fem::condensed_compliance_q2(grid, layered_block(grid), asked.threads),
        asked.threads);
  if (asked.is_q2)
    return std::make_unique<fem::Q2Operator>(
        grid, counting_group(),
        fem::condensed_column_q2(grid, layered_block(grid)), asked.threads);
  if (!asked.is_alone)
    return std::make_unique<contact::FourierOperator>(
        grid, counting_group(),
        asked.is_q1 ? fem::condensed_column_q1(grid, layered_block(grid))
                    : contact::compliance_column(grid, half_space),
        asked.threads);
  if (asked.is_q1)
    return std::make_unique<contact::FourierOperator>(
        grid,
        fem::condensed_compliance_q1(grid, layered_block(grid), asked.threads),
        asked.threads);
  return std::make_unique<contact::FourierOperator>(
      contact::halfspace_operator(grid, half_space, asked.threads));
}

void print(const char* what, const std::vector<double>& numbers,
           const char* unit) {
  fmt::print("{} of each rank [{}]", what, unit);
  for (const double number : numbers)
    fmt::print(" {:.3f}", number);
  fmt::print("\n");
}

void solve(const NamedCases& asked) {
  const double before = peak_memory();
  const auto begin = std::chrono::steady_clock::now();
  std::unique_ptr<contact::SurfaceOperator> elasticity = elasticity_of(asked);
  const SharedRows rows =
      asked.is_alone ? SharedRows(asked.grid) : *elasticity->shared_rows();
  if (asked.fails && rows.ranks()->rank() + 1 == rows.ranks()->size())
    elasticity = std::make_unique<FailingOperator>(std::move(elasticity));
  contact::LoadSequence sequence(std::move(elasticity), heights_of(rows),
                                 {mechanics::ContactLaw::hard, 0.0}, 1e-8,
                                 2000);
  const double setup = seconds_since(begin);
  const double sent = asked.is_alone ? 0.0 : counting_group().sent();
  const double calls = asked.is_alone ? 0.0 : counting_group().calls();
  const auto start = std::chrono::steady_clock::now();
  const CpuClock clock(2); // of the process
  const contact::ContactSolution solution =
      sequence.solve({mechanics::Control::nominal_pressure, 0.01});
  const double time = seconds_since(start);
  const std::vector<double> cpu_times = of_ranks(rows, clock.seconds());
  const double sent_in_step =
      asked.is_alone ? 0.0 : counting_group().sent() - sent;
  const double calls_in_step =
      asked.is_alone ? 0.0 : counting_group().calls() - calls;
  const std::vector<double> sent_by_ranks = of_ranks(rows, sent_in_step);
  const std::vector<double> memory = of_ranks(
      rows, (peak_memory() - before) / static_cast<double>(rows.size()));
  const std::string pressure = hash_of(rows, solution.pressure);
  const std::string gap = hash_of(rows, solution.gap);
  if (rows.ranks() != nullptr && rows.ranks()->rank() != 0)
    return;
  fmt::print("pressure {} gap {} mean gap {:a} iterations {} transforms {} "
             "converged {} note '{}'\n",
             pressure, gap, solution.mean_gap, solution.iterations,
             solution.transforms, solution.converged, solution.note);
  fmt::print("points {} ranks {} set-up {:.3f} s, time {:.3f} s\n",
             asked.grid.points_x, cpu_times.size(), setup, time);
  print("CPU time", cpu_times, "s");
  print("memory", memory, "bytes per own node");
  print("sent", sent_by_ranks, "B");
  fmt::print("collective calls {:.0f}\n", calls_in_step);
}

/// Square cells; the length in x is 1.
Grid grid_of(const std::string& points) {
  const std::size_t cross = points.find('x');
  const int points_x = std::atoi(points.c_str());
  const int points_y = cross == std::string::npos
                           ? points_x
                           : std::atoi(points.c_str() + cross + 1);
  return {points_x, points_y, 1.0, static_cast<double>(points_y) / points_x};
}

} // namespace
} // namespace asperity

int main(int argc, char** argv) {
  using namespace asperity;
  if (argc < 4) {
    fmt::print(stderr,
               "arguments: points threads ranks|alone [q1|q2|free|fail]\n");
    return 2;
  }
  const std::string kind = argc > 4 ? argv[4] : "";
  const NamedCases asked{
      grid_of(argv[1]), std::atoi(argv[2]), std::string(argv[3]) == "alone",
      kind == "fail",   kind == "q1",       kind == "q2",
      kind == "free"};
  if (asked.is_alone)
    solve(asked);
  else
    fem::do_share([&] { solve(asked); });
}
