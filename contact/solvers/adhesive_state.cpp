#include "contact/solvers/adhesive_state.hpp"

#include "base/ranks/node_sums.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace asperity::contact {
namespace {

/// Changes of the gap, relative to the range, up to which the change of W is
/// found from the mean of W' at both ends. Its error is of third order, and it
/// does not cancel.
constexpr double small_change = 1e-4;

/// Share of its distance to the core that a node may go in one step.
constexpr double longest_approach = 0.4;

/// Stiffness k of M over k_c with a wall: M then knows the longest waves, which
/// are softer than most of the heights. Without a wall k = k_c: M joins its two
/// parts there, and a smaller one nearly doubles the work of the test for a
/// minimum.
constexpr double softening = 0.03;

/// Least k over the stiffness of the shortest waves: M is a difference in
/// single precision, of which this share is left for them.
constexpr double softest_wave = 3e-5;

/// Starts are nowhere negative: a gap in roundoff of the wall is closed.
std::vector<double> checked_start(const SurfaceOperator& elasticity,
                                  const AdhesiveProblem& problem,
                                  const mechanics::LoadTarget& target,
                                  std::vector<double> start) {
  const auto require_size = [&](const char* name, std::size_t size) {
    if (size != elasticity.n_nodes())
      refuse_argument(name, static_cast<double>(size), "the number of nodes");
  };
  require_size("heights.size()", problem.heights.size());
  require_size("start.size()", start.size());
  if (!elasticity.has_inverse() || !elasticity.nodal_weights().empty())
    refuse_argument("adhesion", problem.law.work_of_adhesion,
                    "left to surfaces whose compliance has an exact inverse, "
                    "and whose nodes have equal areas");
  require_positive("gap_tolerance", problem.gap_tolerance, "m");
  require_positive("preconditioner_stiffness", problem.preconditioner_stiffness,
                   "Pa/m");
  require_positive("work_of_adhesion", problem.law.work_of_adhesion, "J/m^2");
  require_positive("adhesion_range", problem.law.adhesion_range, "m");
  if (!(target.spring > 0.0))
    refuse_argument("spring", target.spring, "> 0 [Pa/m]");
  const bool is_gap = target.control == mechanics::Control::mean_gap;
  if (is_gap && std::isinf(target.spring))
    require_positive("mean_gap", target.amount, "m");
  else if (!is_gap && std::isfinite(target.spring))
    refuse_argument("spring", target.spring,
                    "infinite where the load is prescribed");
  else if (is_gap && !std::isfinite(target.amount))
    refuse_argument("mean_gap", target.amount, "finite [m]");
  else if (!std::isfinite(target.amount))
    refuse_argument("nominal_pressure", target.amount, "finite [Pa]");
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (!(start[i] >= 0.0 ||
          (start[i] > problem.law.least_gap() && std::isfinite(start[i]))))
      refuse_argument("start", start[i], "a gap that the law admits [m]");
    if (!std::isfinite(problem.heights[i]))
      refuse_argument("heights", problem.heights[i], "finite [m]");
  }
  return start;
}

} // namespace

AdhesiveState::AdhesiveState(SurfaceOperator& elasticity_,
                             const AdhesiveProblem& problem_,
                             const mechanics::LoadTarget& target_,
                             std::vector<double> start)
    : elasticity(elasticity_),
      problem(problem_),
      target(target_),
      workers(elasticity_.workers()),
      gap(checked_start(elasticity_, problem_, target_, std::move(start))),
      elastic(gap.size()),
      gradient(gap.size()),
      free(gap.size()),
      stiffest_waves(2.0 * std::numbers::sqrt2 /
                     elasticity_.short_wave_compliance()),
      has_wall_(mechanics::has_wall(problem_.law.law)),
      wave_stiffness_(
          has_wall_ ? std::max(softening * problem_.preconditioner_stiffness,
                               softest_wave * stiffest_waves)
                    : problem_.preconditioner_stiffness),
      next_gap_(gap.size()),
      next_elastic_(gap.size()),
      scratch_(gap.size()) {
  if (by_gap()) {
    const double* const g = gap.data();
    const bool has_open =
        sum([=](std::size_t i) { return g[i] > 0.0 ? 1.0 : 0.0; }) > 0.0;
    each([&](std::size_t i) { free[i] = !has_open || g[i] > 0.0 ? 1 : 0; });
    restore_mean(gap, target.amount, 0.0);
  }
  find_elastic(gap, elastic);
  find_free();
}

double AdhesiveState::rms(std::span<const double> field) const {
  return std::sqrt(dot(field, field) / n_nodes());
}

void AdhesiveState::find_elastic(std::span<const double> from,
                                 std::span<double> answer) {
  each([&, h = problem.heights.data()](std::size_t i) {
    answer[i] = from[i] + h[i];
  });
  elasticity.pressure_of(answer, answer);
  ++transforms;
}

void AdhesiveState::find_free() {
  const mechanics::ContactInterface& law = problem.law;
  each([&](std::size_t i) { gradient[i] = elastic[i] - law.pressure(gap[i]); });
  const double closed = wall();
  const double* const g = gap.data();
  const double* const r = gradient.data();
  load = by_gap() ? mean_load() : target.amount;
  if (by_spring())
    load =
        target.spring *
        (sum([=](std::size_t i) { return g[i]; }) / n_nodes() - target.amount);
  each([&](std::size_t i) {
    free[i] = g[i] > closed || r[i] + load < 0.0 ? 1 : 0;
  });
  n_free = sum(
      [f = free.data()](std::size_t i) { return static_cast<double>(f[i]); });
  least_gap =
      -largest_term(gap.size(), workers, [=](std::size_t i) { return -g[i]; });
  uniform_stiffness_ =
      by_gap() || by_spring() ? wave_stiffness_ : stiffness_of_mean_gap();
}

double AdhesiveState::mean_load() const {
  const auto [open, total] =
      several_sums<2>(gap.size(), workers,
                      [g = gap.data(), r = gradient.data(),
                       closed = wall()](std::size_t i, auto& own) {
                        if (g[i] > closed) {
                          own[0] += 1.0;
                          own[1] += r[i];
                        }
                      });
  return -total / open;
}

double AdhesiveState::stiffness_of_mean_gap() const {
  const auto [missing, total] =
      several_sums<2>(gap.size(), workers, [&](std::size_t i, auto& own) {
        if (free[i] == 0) {
          own[1] += stiffest_waves;
          return;
        }
        const double repelled = repulsion(i);
        own[0] += gradient[i] + load;
        own[1] += repelled / (1.0 + repelled / stiffest_waves);
      });
  const double most = problem.preconditioner_stiffness;
  return std::clamp(
      std::max(total, std::abs(missing) / problem.law.adhesion_range) /
          n_nodes(),
      most / n_nodes(), most);
}

void AdhesiveState::residual(std::span<double> answer) const {
  each([&](std::size_t i) { answer[i] = gradient[i] + load; });
  restrict_to_free(answer);
}

void AdhesiveState::restrict_to_free(std::span<double> field) const {
  restrict_to_free(field, by_gap());
}

void AdhesiveState::restrict_to_free(std::span<double> field,
                                     bool is_without_mean) const {
  const std::uint8_t* const f = free.data();
  const double mean = is_without_mean && n_free > 0.0
                          ? sum([=, x = field.data()](std::size_t i) {
                              return f[i] != 0 ? x[i] : 0.0;
                            }) / n_free
                          : 0.0;
  each([=, x = field.data()](std::size_t i) {
    x[i] = f[i] != 0 ? x[i] - mean : 0.0;
  });
}

double AdhesiveState::repulsion(std::size_t i) const {
  return has_wall_ ? 0.0 : std::max(0.0, problem.law.stiffness(gap[i]));
}

// (K + k)^-1 = (1 - (C + 1/k)^-1 / k) / k. The mean of the inverse is
// arbitrary, and that of M is 1/k_u. In single precision the field is of order
// 1, because stiffnesses of small surfaces are 1e20 Pa/m and more. With a
// spring of the stiffness c, which may be the stiffest part, M is that of a
// given mean gap beside 1/(k + c n_free/n) of the mean of the free nodes.
void AdhesiveState::precondition(std::span<const double> field,
                                 std::span<double> answer) {
  const double stiffness = wave_stiffness_;
  const double mean_field =
      by_spring() && n_free > 0.0
          ? sum([=](std::size_t i) { return field[i]; }) / n_free
          : 0.0;
  const auto own = [=, this](std::size_t i) {
    return free[i] != 0 ? field[i] - mean_field : 0.0;
  };
  const double size = std::sqrt(
      sum([&](std::size_t i) { return own(i) * own(i); }) / n_nodes());
  const double unit = size > 0.0 && std::isfinite(size)
                          ? std::ldexp(1.0, std::ilogb(size))
                          : 1.0;
  // With a wall S is 1, and its roots would cost as much as the transforms.
  each([&](std::size_t i) {
    const double scale =
        has_wall_ ? 1.0 : 1.0 / std::sqrt(1.0 + repulsion(i) / stiffness);
    scratch_[i] = static_cast<float>(scale * own(i) / unit);
  });
  const auto mean_of_scratch = [&] {
    return sum([s = scratch_.data()](std::size_t i) {
             return static_cast<double>(s[i]);
           }) /
           n_nodes() * unit;
  };
  const double uniform =
      mean_of_scratch() * (1.0 / uniform_stiffness_ - 1.0 / stiffness);
  elasticity.pressure_estimate(scratch_, 1.0 / stiffness, scratch_);
  ++transforms;
  const double mean = mean_of_scratch();
  each([&](std::size_t i) {
    const double repelled = repulsion(i);
    const double square = has_wall_ ? 1.0 : 1.0 / (1.0 + repelled / stiffness);
    const double scale = has_wall_ ? 1.0 : std::sqrt(square);
    const double waves =
        (scale * own(i) -
         (static_cast<double>(scratch_[i]) * unit - mean) / stiffness) /
        stiffness;
    answer[i] = scale * (waves + uniform) +
                (1.0 - square) / (repelled + stiffest_waves) * own(i);
  });
  restrict_to_free(answer, by_gap() || by_spring());
  if (by_spring()) {
    const double shift =
        mean_field / (stiffness + target.spring * n_free / n_nodes());
    each([&](std::size_t i) { answer[i] += free[i] != 0 ? shift : 0.0; });
  }
}

void AdhesiveState::apply_hessian(std::span<const double> field,
                                  std::span<double> answer) {
  elasticity.pressure_of(field, answer);
  ++transforms;
  const double of_spring =
      by_spring() ? target.spring / n_nodes() *
                        sum([=](std::size_t i) { return field[i]; })
                  : 0.0;
  each([&](std::size_t i) {
    answer[i] += problem.law.stiffness(gap[i]) * field[i] + of_spring;
  });
  restrict_to_free(answer);
}

// The mean of max(0, g - shift) falls with the shift and is convex, so that
// Newton's method ends after as many steps as there are breaks between.
void AdhesiveState::restore_mean(std::span<double> moved, double mean,
                                 double closed) const {
  constexpr int most_steps = 100;
  const double* const g = moved.data();
  const std::uint8_t* const f = free.data();
  const double wanted = mean * n_nodes() - sum([=](std::size_t i) {
                          return f[i] != 0 ? 0.0 : g[i];
                        });
  double shift = 0.0;
  for (int step = 0; step < most_steps; ++step) {
    const auto [total, open] =
        several_sums<2>(moved.size(), workers, [=](std::size_t i, auto& own) {
          if (f[i] != 0 && g[i] - shift > closed) {
            own[0] += g[i] - shift;
            own[1] += 1.0;
          }
        });
    const double change = (total - wanted) / std::max(1.0, open);
    shift += change;
    if (std::abs(change) <= 1e-15 * (std::abs(mean) + std::abs(shift)))
      break;
  }
  each([=, x = moved.data()](std::size_t i) {
    if (f[i] != 0)
      x[i] = std::max(closed, x[i] - shift);
  });
}

AdhesiveState::Change AdhesiveState::try_step(std::span<const double> direction,
                                              double length) {
  // No node goes more than 0.4 of the way to the core of a law without a wall.
  const bool has_wall = std::isfinite(wall());
  const double core = problem.law.least_gap();
  const double bound = // restore_mean() clips
      by_gap() || by_spring() ? -std::numeric_limits<double>::infinity() : 0.0;
  each([&](std::size_t i) {
    const double nearest =
        has_wall ? bound : gap[i] - longest_approach * (gap[i] - core);
    next_gap_[i] = free[i] == 0
                       ? gap[i]
                       : std::max(nearest, gap[i] + length * direction[i]);
  });
  if (by_gap())
    restore_mean(next_gap_, target.amount, wall());
  else if (by_spring()) // goes where the step leads without the wall
    restore_mean(next_gap_,
                 sum([=, this](std::size_t i) {
                   return gap[i] + (free[i] != 0 ? length * direction[i] : 0.0);
                 }) / n_nodes(),
                 wall());
  find_elastic(next_gap_, next_elastic_);
  const mechanics::ContactInterface& law = problem.law;
  const double range = law.range();
  const double small = small_change * law.adhesion_range;
  const auto change_of_law = [&](std::size_t i, double by) {
    const bool is_smooth = (gap[i] < range) == (next_gap_[i] < range);
    if (std::abs(by) < small && is_smooth)
      return -0.5 * by * (law.pressure(gap[i]) + law.pressure(next_gap_[i]));
    return law.energy(next_gap_[i]) - law.energy(gap[i]);
  };
  const auto [energy, slope, shift] =
      several_sums<3>(gap.size(), workers, [&](std::size_t i, auto& own) {
        const double by = next_gap_[i] - gap[i];
        if (by == 0.0)
          return;
        own[0] += by * (0.5 * (elastic[i] + next_elastic_[i]) + load) +
                  change_of_law(i, by);
        own[1] += by * (gradient[i] + load);
        own[2] += by;
      });
  const double n = n_nodes();
  const double of_spring =
      by_spring() ? 0.5 * target.spring * (shift / n) * (shift / n) : 0.0;
  return {energy / n + of_spring, slope / n};
}

void AdhesiveState::take(std::span<float> step, std::span<float> bend) {
  each([&](std::size_t i) {
    step[i] = static_cast<float>(next_gap_[i] - gap[i]);
  });
  next_elastic_.swap(elastic);
  std::vector<double>& before = next_elastic_; // is free until the next step
  before.swap(gradient);
  gap.swap(next_gap_);
  find_free();
  each([&](std::size_t i) {
    bend[i] = static_cast<float>(gradient[i] - before[i]);
  });
}

void AdhesiveState::take() {
  gap.swap(next_gap_);
  elastic.swap(next_elastic_);
  find_free();
}

double AdhesiveState::missing_load() const {
  const std::uint8_t* const has_counter =
      problem.opposed.empty() ? nullptr : problem.opposed.data();
  const auto [opposed, alone] =
      several_sums<2>(gap.size(), workers, [&](std::size_t i, auto& own) {
        if (free[i] != 0) {
          const bool is_alone = has_counter != nullptr && has_counter[i] == 0;
          own[is_alone ? 1 : 0] += gradient[i] + load;
        }
      });
  // A prescribed mean gap has the load that leaves none.
  return std::max(by_gap() ? 0.0 : std::abs(opposed), std::abs(alone)) /
         n_nodes();
}

double AdhesiveState::accepted_load() const {
  const auto [borne, height] = several_sums<2>(
      gap.size(), workers,
      [&, h = problem.heights.data()](std::size_t i, auto& own) {
        own[0] += std::abs(elastic[i] + load);
        own[1] += (gap[i] + h[i]) * (gap[i] + h[i]);
      });
  const double n = n_nodes();
  // The errors of the nodes are independent; a spring has those of its length.
  const double of_spring =
      by_spring()
          ? target.spring * (std::abs(target.amount) + std::sqrt(height / n))
          : 0.0;
  // That of a transform grows with the logarithm of its size, and the tension
  // of a law may cancel in each node.
  const double rounding =
      std::numeric_limits<double>::epsilon() *
      (std::log2(n) * (stiffest_waves * std::sqrt(height) / n + of_spring) -
       problem.law.pressure_bounds().smallest);
  return std::max(problem.load_tolerance * borne / n, rounding);
}

double AdhesiveState::unresolved_load() const {
  return std::sqrt(2.0 * problem.preconditioner_stiffness *
                   std::numeric_limits<double>::epsilon() *
                   problem.law.work_of_adhesion);
}

// The tension of a law falls beyond strongest_gap(): where the smallest gap
// cannot carry p_0, no node can, and a larger distance has less energy.
bool AdhesiveState::is_detached() const {
  return target.control == mechanics::Control::nominal_pressure &&
         target.amount <= 0.0 && least_gap > problem.law.strongest_gap() &&
         -problem.law.pressure(least_gap) <= -target.amount &&
         (target.amount < 0.0 || least_gap >= problem.law.range());
}

} // namespace asperity::contact
