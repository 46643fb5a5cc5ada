#include "contact/solvers/node_kernels.hpp"

#include "base/ranks/node_weights.hpp"
#include "base/simd_pack.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

// The loops are plain ones that the compiler turns into vectors of any width:
// conditions are masks, and what has another width than the other fields, the
// freedom of the nodes, is converted in a loop of its own.

#define INLINED __attribute__((always_inline))

namespace asperity::contact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Sums, or other partial results, of the nodes whose places in a block are the
/// same modulo 16: they are added in the same order for any width of vectors.
template <class Real>
using Lanes = std::array<Real, 16>;
constexpr std::size_t n_lanes = 16;

template <class Join>
INLINED inline double folded(Lanes<double> lanes, const Join& join) {
  for (std::size_t half = n_lanes / 2; half > 0; half /= 2)
    for (std::size_t i = 0; i < half; ++i)
      lanes[i] = join(lanes[i], lanes[i + half]);
  return lanes[0];
}

INLINED inline double total(const Lanes<double>& lanes) {
  return folded(lanes, [](double a, double b) { return a + b; });
}

/// Returns loop(weights), compiled for this processor.
template <class Loop>
auto on_weights(const NodeFields& fields, const Loop& loop) {
  return on_this_processor([&](auto) INLINED {
    return fields.weight == nullptr ? loop(EqualWeights())
                                    : loop(fields.weight);
  });
}

/// Calls do_block(first node, number of nodes) for the blocks of a range; the
/// number is a constant for all but an incomplete one.
template <class DoBlock>
INLINED inline void each_node_block(const NodeRange& range,
                                    const DoBlock& do_block) {
  std::size_t first = range.begin;
  for (; first + block_nodes <= range.end; first += block_nodes)
    do_block(first, std::integral_constant<std::size_t, block_nodes>());
  if (first < range.end)
    do_block(first, range.end - first);
}

/// Calls do_node(i, lane) for n nodes from `first` on.
template <class Count, class DoNode>
INLINED inline void each_lane(std::size_t first, Count n,
                              const DoNode& do_node) {
  std::size_t k = 0;
  for (; k + n_lanes <= n; k += n_lanes)
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      do_node(first + k + lane, lane);
  for (; k < n; ++k)
    do_node(first + k, k % n_lanes);
}

/// Adds product(i, freedom, weight) over a range of nodes. Products, and their
/// sums over a block, are in single precision: conversions would take most of
/// the time. The factor product_scale keeps them from underflow.
template <std::size_t n_sums, class Product>
SeveralSums<n_sums> sum_products(const NodeFields& f, const NodeRange& range,
                                 const Product& product) {
  return on_weights(f, [&](const auto weights) INLINED {
    std::array<Lanes<double>, n_sums> lanes{};
    each_node_block(range, [&](std::size_t first, auto n) INLINED {
      std::array<std::int32_t, block_nodes> freedom;
      for (std::size_t i = 0; i < n; ++i)
        freedom[i] = f.freedom[first + i];
      std::array<Lanes<float>, n_sums> own{};
      each_lane(first, n, [&](std::size_t i, std::size_t lane) INLINED {
        const auto weight = static_cast<float>(weights[i]);
        const auto terms = product(i, freedom[i - first], weight);
        for (std::size_t k = 0; k < n_sums; ++k)
          own[k][lane] += terms[k];
      });
      for (std::size_t k = 0; k < n_sums; ++k)
        for (std::size_t lane = 0; lane < n_lanes; ++lane)
          lanes[k][lane] += static_cast<double>(own[k][lane]);
    });
    SeveralSums<n_sums> sums;
    for (std::size_t k = 0; k < n_sums; ++k)
      sums.values[k] = total(lanes[k]);
    return sums;
  });
}

/// raw_gap = next(node, raw_gap) in a block without contact. Returns the lowest
/// gap; -infinity if one is not finite.
template <class Count, class Next>
INLINED inline double lowest_changed(const NodeFields& f, std::size_t first,
                                     Count n, const Next& next) {
  double* const raw_gap = f.raw_gap;
  Lanes<double> least, sum{};
  least.fill(infinity);
  each_lane(first, n, [&](std::size_t i, std::size_t lane) INLINED {
    const double gap = next(i, raw_gap[i]);
    raw_gap[i] = gap;
    least[lane] = gap < least[lane] ? gap : least[lane];
    sum[lane] += gap;
  });
  const double lowest =
      folded(least, [](double a, double b) { return b < a ? b : a; });
  return std::isfinite(total(sum)) ? lowest : -infinity;
}

/// raw_gap = next(node, raw_gap). A block has either sums over its contact or a
/// lowest gap: one loop with both waits for registers.
template <class Next>
TwoSums change(const NodeFields& f, const NodeRange& range, const Next& next) {
  return on_weights(f, [&](const auto weights) INLINED {
    const double* const p = f.pressure;
    double* const raw_gap = f.raw_gap;
    const double compliance = f.compliance;
    const double hardness = f.hardness;
    Lanes<double> residual{}, weight{};
    each_node_block(range, [&](std::size_t first, auto n) INLINED {
      if (f.active[first / block_nodes] == 0) {
        f.lowest[first / block_nodes] = lowest_changed(f, first, n, next);
        return;
      }
      each_lane(first, n, [&](std::size_t i, std::size_t lane) INLINED {
        const double gap = next(i, raw_gap[i]);
        raw_gap[i] = gap;
        const double own = gap + compliance * p[i];
        const bool is_elastic = (p[i] > 0.0) & (p[i] < hardness);
        residual[lane] += masked(own * weights[i], is_elastic);
        weight[lane] += masked(weights[i], is_elastic);
      });
    });
    return TwoSums{{total(residual), total(weight)}};
  });
}

/// Sets the freedom of n nodes. Returns whether one is active.
/// @param changed  their number that became active or inactive is added
template <class Count>
INLINED inline bool store_freedom(const std::array<double, block_nodes>& codes,
                                  Count n, std::uint8_t* freedom,
                                  int& changed) {
  std::array<std::int32_t, block_nodes> narrow; // one conversion at a time
  for (std::size_t i = 0; i < block_nodes; ++i)
    narrow[i] = static_cast<std::int32_t>(codes[i]);
  std::uint8_t any = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto now = static_cast<std::uint8_t>(narrow[i]);
    any |= now;
    changed += (now > fixed) != (freedom[i] > fixed) ? 1 : 0;
    freedom[i] = now;
  }
  return any > fixed;
}

/// The pressure of a node after a step.
struct Advanced {
  INLINED Advanced(const NodeFields& fields, const Advance& advance)
      : pressure_(fields.pressure),
        direction_(fields.direction),
        hardness_(fields.hardness),
        advance_(advance) {}

  INLINED bool moves(std::size_t i) const { return direction_[i] != 0.0F; }

  INLINED double wish(std::size_t i) const {
    return pressure_[i] - advance_.step * static_cast<double>(direction_[i]);
  }

  INLINED double kept(std::size_t i, double wish) const {
    const double scaled = moves(i) ? advance_.factor * wish : wish;
    const double below = scaled < hardness_ ? scaled : hardness_;
    return below > 0.0 ? below : 0.0;
  }

private:
  const double* pressure_;
  const float* direction_;
  double hardness_;
  Advance advance_;
};

} // namespace

MeasuredNodes measure_nodes(const NodeFields& fields, const NodeRange& range,
                            double rigid) {
  return on_weights(fields, [&](const auto weights) INLINED {
    const double* const p = fields.pressure;
    const double* const raw_gap = fields.raw_gap;
    const double compliance = fields.compliance;
    const double hardness = fields.hardness;
    Lanes<double> error{}, sum{}, weight{};
    int changed = 0;
    each_node_block(range, [&](std::size_t first, auto n) INLINED {
      std::uint8_t& is_active = fields.active[first / block_nodes];
      if (is_active == 0)
        return;
      std::array<double, block_nodes> codes{};
      Lanes<double> at_hardness{};
      each_lane(first, n, [&](std::size_t i, std::size_t lane) INLINED {
        const double value = raw_gap[i] + compliance * p[i] + rigid;
        const bool has_pressure = p[i] > 0.0;
        const bool is_capped = p[i] >= hardness;
        const bool may_gain = (has_pressure | (value < 0.0)) & !is_capped;
        const bool may_fall = has_pressure & !(is_capped & (value <= 0.0));
        const bool is_free = may_gain | may_fall;
        const double kept = masked(value, is_free);
        fields.residual[i] = static_cast<float>(kept);
        codes[i - first] = masked(1.0, may_gain) + masked(2.0, may_fall);
        at_hardness[lane] += masked(1.0, is_capped);
        const double size = std::abs(kept);
        error[lane] = size > error[lane] ? size : error[lane];
        sum[lane] += value;
        weight[lane] += masked(weights[i], is_free);
      });
      const bool any = store_freedom(codes, n, fields.freedom + first, changed);
      is_active = any || total(at_hardness) > 0.0 ? 1 : 0;
    });
    const double largest =
        folded(error, [](double a, double b) { return b > a ? b : a; });
    return MeasuredNodes{0.0 * total(sum) + largest, total(weight),
                         static_cast<double>(changed)};
  });
}

TwoSums change_gap(const NodeFields& fields, const NodeRange& range,
                   double factor) {
  const float* const change_of_gap = fields.displaced;
  return change(fields, range, [=](std::size_t i, double gap) INLINED {
    return gap + factor * static_cast<double>(change_of_gap[i]);
  });
}

TwoSums subtract_heights(const NodeFields& fields, const NodeRange& range) {
  const double* const h = fields.heights;
  return change(fields, range,
                [=](std::size_t i, double gap) INLINED { return gap - h[i]; });
}

Sum sum_free(const NodeFields& fields, const NodeRange& range) {
  const float* const z = fields.preconditioned;
  const auto sums = sum_products<1>(
      fields, range,
      [=](std::size_t i, std::int32_t freedom, float weight) INLINED {
        return std::array{masked(z[i], freedom > fixed) * weight};
      });
  return {sums.values[0]};
}

TwoSums sum_slopes(const NodeFields& fields, const NodeRange& range,
                   float mean) {
  const float* const z = fields.preconditioned;
  const float* const r = fields.residual;
  const float* const before = fields.previous_residual;
  const float scale = fields.product_scale;
  TwoSums sums = sum_products<2>(
      fields, range,
      [=](std::size_t i, std::int32_t freedom, float weight) INLINED {
        const float own = allowed(z[i] - mean, freedom) * scale * weight;
        return std::array{own * r[i], own * (r[i] - before[i])};
      });
  for (double& sum : sums.values)
    sum /= static_cast<double>(scale);
  return sums;
}

Sum conjugate_nodes(const NodeFields& fields, const NodeRange& range,
                    float mean, float beta) {
  const float* const z = fields.preconditioned;
  const float* const r = fields.residual;
  float* const d = fields.direction;
  const float scale = fields.product_scale;
  const auto sums = sum_products<1>(
      fields, range,
      [=](std::size_t i, std::int32_t freedom, float weight) INLINED {
        const float own = allowed(z[i] - mean, freedom);
        d[i] = allowed(own + beta * d[i], freedom);
        return std::array{d[i] * scale * weight * r[i]};
      });
  return {sums.values[0] / static_cast<double>(scale)};
}

Sum sum_energy(const NodeFields& fields, const NodeRange& range) {
  const float* const d = fields.direction;
  const float* const cd = fields.displaced;
  const float scale = fields.product_scale;
  const auto compliance = static_cast<float>(fields.compliance);
  const auto sums = sum_products<1>(
      fields, range, [=](std::size_t i, std::int32_t, float weight) INLINED {
        return std::array{d[i] * scale * weight * (cd[i] + compliance * d[i])};
      });
  return {sums.values[0] / static_cast<double>(scale)};
}

TwoSums advance_nodes(const NodeFields& fields, const NodeRange& range,
                      const Advance& advance) {
  double* const p = fields.pressure;
  float* const change = fields.change;
  return on_weights(fields, [&](const auto weights) INLINED {
    const Advanced next(fields, advance);
    Lanes<double> sum{}, cuts{};
    each_node_block(range, [&](std::size_t first, auto n) INLINED {
      each_lane(first, n, [&](std::size_t i, std::size_t lane) INLINED {
        const double wish = next.wish(i);
        const double kept = next.kept(i, wish);
        change[i] = static_cast<float>(kept - p[i]);
        p[i] = kept;
        cuts[lane] += std::abs(kept - wish);
        sum[lane] += kept * weights[i];
      });
    });
    return TwoSums{{total(sum), total(cuts)}};
  });
}

AdvancedLoad sum_advanced(const NodeFields& fields, const NodeRange& range,
                          const Advance& advance) {
  return on_weights(fields, [&](const auto weights) INLINED {
    const Advanced next(fields, advance);
    Lanes<double> sum{}, cuts{}, slope{}, largest{};
    each_node_block(range, [&](std::size_t first, auto n) INLINED {
      each_lane(first, n, [&](std::size_t i, std::size_t lane) INLINED {
        const double wish = next.wish(i);
        const double kept = next.kept(i, wish);
        cuts[lane] += std::abs(kept - wish);
        sum[lane] += kept * weights[i];
        slope[lane] += masked(wish * weights[i], next.moves(i) & (kept > 0.0) &
                                                     (kept < fields.hardness));
        largest[lane] = kept > largest[lane] ? kept : largest[lane];
      });
    });
    return AdvancedLoad{
        total(sum), total(cuts), total(slope),
        folded(largest, [](double a, double b) { return b > a ? b : a; })};
  });
}

void scale_nodes(const NodeFields& fields, const NodeRange& range,
                 double factor) {
  double* const p = fields.pressure;
  float* const change = fields.change;
  on_this_processor([=](auto) INLINED {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      change[i] += static_cast<float>((factor - 1.0) * p[i]);
      p[i] *= factor;
    }
  });
}

} // namespace asperity::contact

#undef INLINED
