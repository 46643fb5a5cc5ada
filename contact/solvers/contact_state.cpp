#include "contact/solvers/contact_state.hpp"

#include "base/maximum.hpp"
#include "contact/operators/chunked_sum.hpp"
#include "contact/operators/node_weights.hpp"
#include "contact/solvers/problem_start.hpp"

#include <cmath>
#include <utility>

namespace asperity::contact {
namespace {

/// The displacement is recomputed when the error has fallen by this factor
/// since the last time: the accumulated single-precision changes have by then
/// left an error of about 1e-7 of the first one.
constexpr double recurrence_range = 1e-4;

struct ResidualSums {
  double error = 0.0, free_weight = 0.0, freed = 0.0;

  ResidualSums& operator+=(const ResidualSums& other) {
    error = maximum(error, other.error);
    free_weight += other.free_weight;
    freed += other.freed;
    return *this;
  }
};

} // namespace

ContactState::ContactState(SurfaceOperator& elasticity_,
                           const ContactProblem& problem_,
                           const mechanics::LoadTarget& target_,
                           std::span<const double> initial_pressure)
    : elasticity(elasticity_),
      problem(problem_),
      target(target_),
      pressure(
          starting_pressure(elasticity_, problem_, target_, initial_pressure)),
      raw_gap(pressure.size()),
      residual(pressure.size()),
      freedom(pressure.size()),
      threads(elasticity_.threads()),
      previous_residual_(pressure.size()) {
  const double* const h = problem.heights.data();
  const auto sum =
      with_weights(elasticity.nodal_weights(), [&](const auto weight) {
        return chunked_sum<Sum>(pressure.size(), threads,
                                [=](std::size_t begin, std::size_t end) {
                                  double total = 0.0;
                                  for (std::size_t i = begin; i < end; ++i)
                                    total += weight[i] * h[i];
                                  return Sum{total};
                                });
      });
  mean_height_ = sum.value / static_cast<double>(pressure.size());
  compute_raw_gap();
}

void ContactState::compute_raw_gap() {
  elasticity.displacement(pressure, raw_gap);
  ++transforms;
  is_computed_ = true;
  double* const w = raw_gap.data();
  const double* const h = problem.heights.data();
  chunked(pressure.size(), threads, [=](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      w[i] -= h[i];
  });
  contact_sums_ = contact_sums();
}

ContactState::ContactSums ContactState::contact_sums() const {
  const double compliance = problem.local_compliance;
  const double* const p = pressure.data();
  const double* const u = raw_gap.data();
  return with_weights(elasticity.nodal_weights(), [&](const auto weight) {
    return chunked_sum<ContactSums>(
        pressure.size(), threads, [=](std::size_t begin, std::size_t end) {
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

void ContactState::update_residual() {
  std::swap(residual, previous_residual_);
  measure_residual();
  if (is_computed_) {
    computed_error_ = gap_error;
  } else if (is_converged() || gap_error < recurrence_range * computed_error_) {
    scale_to_target(target, elasticity.nodal_weights(), pressure, threads);
    compute_raw_gap();
    measure_residual();
    computed_error_ = gap_error;
  }
}

void ContactState::measure_residual() {
  const double compliance = problem.local_compliance;
  const double* const p = pressure.data();
  const double* const w = raw_gap.data();
  float* const r = residual.data();
  std::uint8_t* const free = freedom.data();
  rigid_distance_ = by_pressure()
                        ? -contact_sums_.residual / contact_sums_.weight
                        : target.amount + mean_height_;
  const double rigid = rigid_distance_;
  const auto sums =
      with_weights(elasticity.nodal_weights(), [&](const auto weight) {
        return chunked_sum<ResidualSums>(
            pressure.size(), threads, [=](std::size_t begin, std::size_t end) {
              double error = 0.0, total = 0.0, changed = 0.0;
              double zero = 0.0; // NaN where any value is not finite
#pragma omp simd reduction(+ : total, changed, zero) reduction(max : error)
              for (std::size_t i = begin; i < end; ++i) {
                const double value = w[i] + compliance * p[i] + rigid;
                const double overlap = value < 0.0 ? 1.0 : 0.0;
                const double code = p[i] > 0.0 ? 2.0 : overlap;
                const double kept = code > 0.0 ? value : 0.0;
                const double size = std::abs(kept);
                const bool was_free = free[i] > fixed;
                changed += was_free != (code > 0.0) ? 1.0 : 0.0;
                free[i] = static_cast<std::uint8_t>(code);
                r[i] = static_cast<float>(kept);
                error = size > error ? size : error;
                zero += 0.0 * value;
                total += code > 0.0 ? weight[i] : 0.0;
              }
              return ResidualSums{error + zero, total, changed};
            });
      });
  gap_error = sums.error;
  free_weight = sums.free_weight;
  freed += sums.freed;
}

float ContactState::free_mean(std::span<const float> field) const {
  if (!by_pressure())
    return 0.0F;
  const float* const z = field.data();
  const std::uint8_t* const free = freedom.data();
  const Sum sum =
      with_weights(elasticity.nodal_weights(), [&](const auto weight) {
        return chunked_sum<Sum>(
            field.size(), threads, [=](std::size_t begin, std::size_t end) {
              double total = 0.0;
#pragma omp simd reduction(+ : total)
              for (std::size_t i = begin; i < end; ++i) {
                const float kept = free[i] > fixed ? z[i] : 0.0F;
                total += weight[i] * static_cast<double>(kept);
              }
              return Sum{total};
            });
      });
  return static_cast<float>(sum.value / free_weight);
}

ContactState::Slopes ContactState::slopes(std::span<const float> field,
                                          float mean) const {
  const float* const z = field.data();
  const std::uint8_t* const free = freedom.data();
  const float* const r = residual.data();
  const float* const before = previous_residual_.data();
  return with_weights(elasticity.nodal_weights(), [&](const auto weight) {
    return chunked_sum<Slopes>(
        field.size(), threads, [=](std::size_t begin, std::size_t end) {
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
  double* const p = pressure.data();
  double* const u = raw_gap.data();
  const float* const d = direction.data();
  float* const cd = compliance_direction.data();
  const double length = static_cast<double>(step);
  const double compliance = problem.local_compliance;
  is_computed_ = false;
  const auto sums =
      with_weights(elasticity.nodal_weights(), [&](const auto weight) {
        return chunked_sum<SeveralSums<4>>(
            pressure.size(), threads, [=](std::size_t begin, std::size_t end) {
              double total = 0.0, cuts = 0.0, gap_sum = 0.0, contact = 0.0;
#pragma omp simd reduction(+ : total, cuts, gap_sum, contact)
              for (std::size_t i = begin; i < end; ++i) {
                const double wish = p[i] - length * static_cast<double>(d[i]);
                const double kept = wish > 0.0 ? wish : 0.0;
                const double gap = u[i] - length * static_cast<double>(cd[i]);
                const double w = kept > 0.0 ? weight[i] : 0.0;
                p[i] = kept;
                u[i] = gap;
                cd[i] = static_cast<float>(kept - wish);
                total += weight[i] * kept;
                cuts += kept - wish;
                gap_sum += w * (gap + compliance * kept);
                contact += w;
              }
              return SeveralSums<4>{{total, cuts, gap_sum, contact}};
            });
      });
  const auto [pressure_sum, all_cuts, residual_sum, weight_sum] = sums.values;
  contact_sums_ = {residual_sum, weight_sum};
  if (all_cuts > 0.0)
    correct_cuts(compliance_direction, pressure_sum);
}

void ContactState::correct_cuts(std::span<float> change, double pressure_sum) {
  const double scale =
      by_pressure() ? load_scale(target, pressure.size(), pressure_sum) : 1.0;
  double* const p = pressure.data();
  double* const u = raw_gap.data();
  float* const field = change.data();
  chunked(pressure.size(), threads, [=](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      field[i] += static_cast<float>((scale - 1.0) * p[i]);
      p[i] *= scale;
    }
  });
  elasticity.displacement_change(change, change);
  ++transforms;
  const double compliance = problem.local_compliance;
  contact_sums_ =
      with_weights(elasticity.nodal_weights(), [&](const auto weight) {
        return chunked_sum<ContactSums>(
            pressure.size(), threads, [=](std::size_t begin, std::size_t end) {
              double sum = 0.0, total = 0.0;
#pragma omp simd reduction(+ : sum, total)
              for (std::size_t i = begin; i < end; ++i) {
                u[i] += static_cast<double>(field[i]);
                const double w = p[i] > 0.0 ? weight[i] : 0.0;
                sum += w * (u[i] + compliance * p[i]);
                total += w;
              }
              return ContactSums{sum, total};
            });
      });
}

ContactSolution ContactState::solution() && {
  ContactSolution answer;
  if (!is_computed_) {
    scale_to_target(target, elasticity.nodal_weights(), pressure, threads);
    compute_raw_gap();
  }
  const std::size_t nodes = pressure.size();
  answer.displacement.resize(nodes);
  double* const displacement = answer.displacement.data();
  double* const gap = raw_gap.data();
  const double* const h = problem.heights.data();
  const double* const p = pressure.data();
  const double rigid = rigid_distance_;
  const auto sums =
      with_weights(elasticity.nodal_weights(), [&](const auto weight) {
        return chunked_sum<SeveralSums<2>>(
            nodes, threads, [=](std::size_t begin, std::size_t end) {
              double pressure_sum = 0.0, gap_sum = 0.0;
              for (std::size_t i = begin; i < end; ++i) {
                displacement[i] = gap[i] + h[i];
                gap[i] += rigid;
                pressure_sum += weight[i] * p[i];
                gap_sum += weight[i] * gap[i];
              }
              return SeveralSums<2>{{pressure_sum, gap_sum}};
            });
      });
  const auto [pressure_sum, gap_sum] = sums.values;
  answer.nominal_pressure = pressure_sum / static_cast<double>(nodes);
  answer.mean_gap = gap_sum / static_cast<double>(nodes);
  answer.pressure = std::move(pressure);
  answer.gap = std::move(raw_gap);
  answer.gap_error = gap_error;
  answer.iterations = iterations;
  answer.transforms = transforms;
  answer.converged = is_converged();
  if (!answer.converged)
    answer.note = not_converged_note(gap_error, iterations);
  return answer;
}

} // namespace asperity::contact
