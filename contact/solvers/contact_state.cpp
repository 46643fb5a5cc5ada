#include "contact/solvers/contact_state.hpp"

#include "contact/solvers/flagged_sums.hpp"
#include "contact/solvers/problem_start.hpp"

#include <limits>
#include <utility>

#include "ranks/node_sums.hpp"

namespace asperity::contact {
namespace {

/// Sets the gap of each node to new_gap(node) and finds the lowest one of each
/// block, NaN if any is not finite.
template <class NewGap>
void change_gap(std::span<double> gap, int threads, std::vector<double>& lowest,
                const NewGap& new_gap) {
  double* const w = gap.data();
  double* const low = lowest.data();
  const auto change_block = [=](std::size_t block, std::size_t begin,
                                std::size_t end) {
    double least = std::numeric_limits<double>::infinity();
    double zero = 0.0;
#pragma omp simd reduction(min : least) reduction(+ : zero)
    for (std::size_t i = begin; i < end; ++i) {
      const double own = new_gap(i);
      w[i] = own;
      least = own < least ? own : least;
      zero += 0.0 * own;
    }
    low[block] = least + zero;
  };
  chunked(gap.size(), threads, [&](std::size_t begin, std::size_t end) {
    each_block(begin, end, change_block);
  });
}

} // namespace

ContactState::ContactState(SurfaceOperator& elasticity_,
                           const ContactProblem& problem_,
                           const mechanics::LoadTarget& target_,
                           std::vector<double> initial_pressure)
    : Iteration(elasticity_, problem_, target_, std::move(initial_pressure)),
      raw_gap(pressure.size()),
      residual(pressure.size()),
      freedom(pressure.size()),
      workers(elasticity_.workers()),
      active(blocks_of(pressure.size()), 1),
      written_(active.size(), 0),
      previous_written_(active.size(), 0),
      lowest_(active.size()),
      change_(pressure.size()),
      change_written_(active.size(), 0),
      previous_residual_(pressure.size()) {
  mean_height_ =
      weighted_sum(elasticity.nodal_weights(), problem.heights, workers) /
      static_cast<double>(workers.all_nodes(pressure.size()));
  compute_raw_gap();
}

void ContactState::compute_raw_gap() {
  elasticity.displacement(pressure, raw_gap);
  ++transforms;
  is_computed_ = true;
  const double* const w = raw_gap.data();
  const double* const h = problem.heights.data();
  change_gap(raw_gap, workers.threads, lowest_,
             [=](std::size_t i) { return w[i] - h[i]; });
  contact_sums_ = contact_sums();
}

void ContactState::add_to_gap(float factor, std::span<const float> field) {
  const double* const w = raw_gap.data();
  const float* const f = field.data();
  const double scale = static_cast<double>(factor);
  change_gap(raw_gap, workers.threads, lowest_, [=](std::size_t i) {
    return w[i] + scale * static_cast<double>(f[i]);
  });
}

ContactState::ContactSums ContactState::contact_sums() const {
  const double compliance = problem.local_compliance;
  const double* const p = pressure.data();
  const double* const u = raw_gap.data();
  return with_weights(elasticity.nodal_weights(), [&](const auto weight) {
    return flagged_sum<ContactSums>(
        active, pressure.size(), workers,
        [=](std::size_t begin, std::size_t end) {
          double sum = 0.0, total = 0.0;
#pragma omp simd reduction(+ : sum, total)
          for (std::size_t i = begin; i < end; ++i) {
            const double w = p[i] > 0.0 ? weight[i] : 0.0;
            sum += w * (u[i] + compliance * p[i]);
            total += w;
          }
          return ContactSums{sum, total};
        });
  });
}

float ContactState::free_mean(std::span<const float> field) const {
  if (!by_pressure())
    return 0.0F;
  const float* const z = field.data();
  const std::uint8_t* const free = freedom.data();
  const double sum = flagged_weighted_sum(
      elasticity.nodal_weights(), active, field.size(), workers,
      [=](std::size_t i) {
        return static_cast<double>(free[i] > fixed ? z[i] : 0.0F);
      });
  return static_cast<float>(sum / free_weight);
}

ContactState::Slopes ContactState::slopes(std::span<const float> field,
                                          float mean) const {
  const float* const z = field.data();
  const std::uint8_t* const free = freedom.data();
  const float* const r = residual.data();
  const float* const before = previous_residual_.data();
  return with_weights(elasticity.nodal_weights(), [&](const auto weight) {
    return flagged_sum<Slopes>(
        active, field.size(), workers, [=](std::size_t begin, std::size_t end) {
          double now = 0.0, change = 0.0;
#pragma omp simd reduction(+ : now, change)
          for (std::size_t i = begin; i < end; ++i) {
            const double slope =
                weight[i] * static_cast<double>(allowed(z[i] - mean, free[i]));
            now += slope * static_cast<double>(r[i]);
            change += slope * static_cast<double>(r[i] - before[i]);
          }
          return Slopes{now, change};
        });
  });
}

void ContactState::advance(float step, std::span<const float> direction,
                           std::span<float> compliance_direction) {
  clear_inactive(active, change_written_, std::span(change_));
  double* const p = pressure.data();
  const float* const d = direction.data();
  float* const dp = change_.data();
  const double length = static_cast<double>(step);
  is_computed_ = false;
  const auto sums =
      with_weights(elasticity.nodal_weights(), [&](const auto weight) {
        return flagged_sum<SeveralSums<2>>(
            active, pressure.size(), workers,
            [=](std::size_t begin, std::size_t end) {
              double total = 0.0, cuts = 0.0;
#pragma omp simd reduction(+ : total, cuts)
              for (std::size_t i = begin; i < end; ++i) {
                const double wish = p[i] - length * static_cast<double>(d[i]);
                const double kept = wish > 0.0 ? wish : 0.0;
                dp[i] = static_cast<float>(kept - p[i]);
                p[i] = kept;
                total += weight[i] * kept;
                cuts += kept - wish;
              }
              return SeveralSums<2>{{total, cuts}};
            });
      });
  const auto [pressure_sum, all_cuts] = sums.values;
  if (all_cuts > 0.0) {
    restore_load(pressure_sum);
    elasticity.displacement_change(change_, compliance_direction);
    ++transforms;
    add_to_gap(1.0F, compliance_direction);
  } else {
    add_to_gap(-step, compliance_direction);
  }
  contact_sums_ = contact_sums();
}

void ContactState::restore_load(double pressure_sum) {
  if (!by_pressure())
    return;
  const double scale =
      load_scale(target, workers.all_nodes(pressure.size()), pressure_sum);
  double* const p = pressure.data();
  float* const dp = change_.data();
  flagged(active, pressure.size(), workers.threads,
          [=](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
              dp[i] += static_cast<float>((scale - 1.0) * p[i]);
              p[i] *= scale;
            }
          });
}

ContactSolution ContactState::solution() && {
  if (!is_computed_) {
    scale_to_target(target, elasticity.nodal_weights(), pressure, workers);
    compute_raw_gap();
  }
  residual = change_ = previous_residual_ = std::vector<float>();
  freedom = std::vector<std::uint8_t>();
  std::vector<double> all_displacements(pressure.size());
  double* const displacement = all_displacements.data();
  double* const gap = raw_gap.data();
  const double* const h = problem.heights.data();
  const double rigid = rigid_distance_;
  chunked(pressure.size(), workers.threads,
          [=](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
              displacement[i] = gap[i] + h[i];
              gap[i] += rigid;
            }
          });
  return solution_of(std::move(raw_gap), std::move(all_displacements));
}

} // namespace asperity::contact
