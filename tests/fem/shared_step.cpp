// Solves one load step of a rough half-space on the ranks of mpirun and prints
// on rank 0 a hash of the fields, the cost and the memory of each rank. The
// measurements of docs/numerics/shared-rows.md are made with it.
//
// Arguments: points per side, threads per rank, "ranks" or "alone" (one process
// without MPI); then "fail" to let the last rank fail in its tenth transform.
#include "base/content_hash.hpp"
#include "base/peak_memory.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/operators/shared_fourier_operator.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "fem/parallel/mpi_group.hpp"
#include "fem/parallel/ranks.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
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

/// Forwards to a shared operator until the tenth change of pressure.
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
    if (++calls_ == 10)
      throw std::runtime_error("the tenth transform failed on purpose");
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

std::string hash_of(std::span<const double> field) {
  return content_hash({reinterpret_cast<const char*>(field.data()),
                       field.size() * sizeof(double)});
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

/// The memory of each rank [B].
std::vector<double> memory_of_ranks(const SharedRows& rows) {
  const double own = static_cast<double>(peak_memory());
  if (rows.ranks() == nullptr)
    return {own};
  std::vector<double> all(static_cast<std::size_t>(rows.ranks()->size()));
  const std::vector<std::size_t> counts(all.size(), sizeof(double));
  rows.ranks()->gather_to_all(std::as_bytes(std::span(&own, 1)), counts,
                              std::as_writable_bytes(std::span(all)));
  return all;
}

void solve(const Grid& grid, int threads, bool is_alone, bool fails) {
  const mechanics::ElasticBlock block{1.0, 0.3,
                                      std::numeric_limits<double>::infinity(),
                                      mechanics::FarBoundary::clamped};
  const double before = static_cast<double>(peak_memory());
  std::unique_ptr<contact::SurfaceOperator> elasticity;
  if (is_alone)
    elasticity = contact::halfspace_operator(grid, block, threads).clone();
  else
    elasticity = std::make_unique<contact::SharedFourierOperator>(
        grid, fem::mpi_group(), contact::compliance_function(block), threads);
  const SharedRows rows =
      is_alone ? SharedRows(grid) : *elasticity->shared_rows();
  if (fails && rows.ranks()->rank() + 1 == rows.ranks()->size())
    elasticity = std::make_unique<FailingOperator>(std::move(elasticity));
  contact::LoadSequence sequence(std::move(elasticity), heights_of(rows),
                                 {mechanics::ContactLaw::hard, 0.0}, 1e-8,
                                 2000);
  const auto start = std::chrono::steady_clock::now();
  const contact::ContactSolution solution =
      sequence.solve({mechanics::Control::nominal_pressure, 0.01});
  const double time = seconds_since(start);
  const std::vector<double> memory = memory_of_ranks(rows);
  const std::string pressure = hash_of(rows.gathered(solution.pressure));
  const std::string gap = hash_of(rows.gathered(solution.gap));
  if (rows.ranks() != nullptr && rows.ranks()->rank() != 0)
    return;
  fmt::print("pressure {} gap {} mean gap {:a} iterations {} transforms {} "
             "converged {} note '{}'\n",
             pressure, gap, solution.mean_gap, solution.iterations,
             solution.transforms, solution.converged, solution.note);
  fmt::print("time {:.3f} s, bytes per node of all ranks", time);
  for (const double bytes : memory)
    fmt::print(" {:.1f}", (bytes - before) / static_cast<double>(rows.size()));
  fmt::print("\n");
}

/// As the program does it: rank 0 broadcasts a command, then all execute it.
void on_all_ranks(const std::function<void()>& share) {
  if (fem::own_rank() == 0)
    fem::pass_on({fem::OrderKind::command});
  else
    static_cast<void>(fem::next_order());
  fem::do_share(share);
}

} // namespace
} // namespace asperity

int main(int argc, char** argv) {
  using namespace asperity;
  if (argc < 4) {
    fmt::print(stderr, "arguments: points threads ranks|alone [fail]\n");
    return 2;
  }
  const int points = std::atoi(argv[1]);
  const Grid grid{points, points, 1.0, 1.0};
  const bool is_alone = std::string(argv[3]) == "alone";
  if (is_alone)
    solve(grid, std::atoi(argv[2]), true, false);
  else
    on_all_ranks([&] {
      solve(grid, std::atoi(argv[2]), false,
            argc > 4 && std::string(argv[4]) == "fail");
    });
}
