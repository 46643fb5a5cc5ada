#include "base/simd_pack.hpp"
#include "contact/solvers/node_kernels.hpp"
#include "contact/solvers/node_lanes.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace asperity::contact {
namespace {

/// Numbers of nodes of a block.
struct FreedomCount {
  std::uint64_t active, changed; ///< became active or inactive
};

/// Eight freedoms at a time, as the bytes of a number.
using EightFreedoms = std::uint64_t;
constexpr EightFreedoms ones = 0x0101010101010101U;

/// 1 in the bytes of the active nodes.
[[gnu::always_inline]] inline EightFreedoms active_in(EightFreedoms codes) {
  return (codes | codes >> 1U) & ones;
}

/// Sets the freedom of n nodes; the other ones of a block have codes of 0.
template <class Count>
[[gnu::always_inline]] inline FreedomCount
store_freedom(const Terms& codes, Count n, std::uint8_t* freedom) {
  std::array<std::int32_t, block_nodes> narrow; // one conversion at a time
  for (std::size_t i = 0; i < block_nodes; ++i)
    narrow[i] = static_cast<std::int32_t>(codes.values[i]);
  std::array<std::uint8_t, block_nodes> before{}, now;
  for (std::size_t i = 0; i < block_nodes; ++i)
    now[i] = static_cast<std::uint8_t>(narrow[i]);
  std::memcpy(before.data(), freedom, n);
  std::memcpy(freedom, now.data(), n);
  EightFreedoms active = 0, changed = 0; // at most 8 in a byte
  for (std::size_t i = 0; i < block_nodes; i += sizeof(EightFreedoms)) {
    EightFreedoms was = 0, is = 0;
    std::memcpy(&was, before.data() + i, sizeof(was));
    std::memcpy(&is, now.data() + i, sizeof(is));
    active += active_in(is);
    changed += active_in(is) ^ active_in(was);
  }
  const auto sum = [](EightFreedoms bytes) { return (bytes * ones) >> 56U; };
  return {sum(active), sum(changed)};
}

template <std::size_t bytes>
[[gnu::always_inline]] inline MeasuredNodes
measure(const NodeFields& f, double rigid, double compliance,
        std::uint8_t* active) {
  Lanes<bytes> error, zero, weight;
  FreedomCount counts{0, 0};
  each_node_block(
      f.nodes, [&](std::size_t first, auto n) __attribute__((always_inline)) {
        if (active[first / block_nodes] == 0)
          return;
        const double* const p = f.pressure + first;
        const double* const w = f.raw_gap + first;
        float* const r = f.residual + first;
        std::uint8_t* const freedom = f.freedom + first;
        Terms sizes(n), zeros(n), codes(n);
        for (std::size_t i = 0; i < n; ++i) {
          const double value = w[i] + compliance * p[i] + rigid;
          const std::int64_t pushed = p[i] > 0.0 ? -1 : 0;
          const std::int64_t overlaps = value < 0.0 ? -1 : 0;
          const std::int64_t is_free = pushed | overlaps;
          const double kept = masked(value, is_free);
          r[i] = static_cast<float>(kept);
          sizes[i] = -std::abs(kept);
          zeros[i] = 0.0 * value;
          codes[i] = masked(1.0, is_free) + masked(1.0, pushed);
        }
        const FreedomCount count = store_freedom(codes, n, freedom);
        active[first / block_nodes] = count.active > 0 ? 1 : 0;
        counts.active += count.active;
        counts.changed += count.changed;
        if (f.weight != nullptr) {
          Terms weights(n);
          for (std::size_t i = 0; i < n; ++i)
            weights[i] = codes[i] > 0.0 ? f.weight[first + i] : 0.0;
          weight.add(weights);
        }
        error.keep_smallest(sizes);
        zero.add(zeros);
      });
  return {zero.total() - error.smallest(),
          f.weight != nullptr ? weight.total()
                              : static_cast<double>(counts.active),
          static_cast<double>(counts.changed)};
}

/// raw_gap = next(node, raw_gap).
template <std::size_t bytes, class Next>
[[gnu::always_inline]] inline TwoSums
change(const NodeFields& f, const Next& next, double compliance,
       const std::uint8_t* active, double* lowest) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto lowest_of_all = typename Lanes<bytes>::Vector{} - infinity;
  Lanes<bytes> residual, weight;
  each_node_block(
      f.nodes, [&](std::size_t first, auto n) __attribute__((always_inline)) {
        double* const w = f.raw_gap + first;
        Terms gaps(n, infinity), zeros(n);
        for (std::size_t i = 0; i < n; ++i) {
          const double own = next(first + i, w[i]);
          w[i] = own;
          gaps[i] = own;
          zeros[i] = 0.0 * own;
        }
        Lanes<bytes> least, zero;
        for (auto& part : least.parts)
          part += infinity;
        least.keep_smallest(gaps);
        zero.add(zeros);
        for (std::size_t part = 0; part < least.parts.size(); ++part)
          least.parts[part] =
              zero.parts[part] == 0.0 ? least.parts[part] : lowest_of_all;
        lowest[first / block_nodes] = least.smallest();
        if (active[first / block_nodes] == 0)
          return;
        const double* const p = f.pressure + first;
        Terms residuals(n), weights(n);
        for (std::size_t i = 0; i < n; ++i) {
          const std::int64_t pushed = p[i] > 0.0 ? -1 : 0;
          residuals[i] = masked(gaps[i] + compliance * p[i], pushed);
          weights[i] = masked(1.0, pushed);
        }
        residuals.scale(f.weight, first, n);
        weights.scale(f.weight, first, n);
        residual.add(residuals);
        weight.add(weights);
      });
  return {residual.total(), weight.total()};
}

} // namespace

MeasuredNodes measure_nodes(const NodeFields& fields, double rigid,
                            double compliance, std::uint8_t* active) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return measure<bytes()>(fields, rigid, compliance, active);
  });
}

TwoSums change_gap(const NodeFields& fields, double factor, double compliance,
                   const std::uint8_t* active, double* lowest) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    const auto next =
        [ factor, u = fields.displaced ](std::size_t i, double own)
            __attribute__((always_inline)) {
      return own + factor * static_cast<double>(u[i]);
    };
    return change<bytes()>(fields, next, compliance, active, lowest);
  });
}

TwoSums subtract_heights(const NodeFields& fields, const double* heights,
                         double compliance, const std::uint8_t* active,
                         double* lowest) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    const auto next = [heights](std::size_t i, double own)
        __attribute__((always_inline)) {
      return own - heights[i];
    };
    return change<bytes()>(fields, next, compliance, active, lowest);
  });
}

} // namespace asperity::contact
