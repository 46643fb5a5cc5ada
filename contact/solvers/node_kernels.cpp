#include "contact/solvers/node_kernels.hpp"

#include "base/simd_pack.hpp"
#include "contact/solvers/node_lanes.hpp"

#include <array>

namespace asperity::contact {
namespace {

/// allowed() of contact_state.hpp: a Freedom of 2 allows every change, 1 only
/// negative ones.
[[gnu::always_inline]] inline float restricted(float value,
                                               std::int32_t freedom) {
  const float gain = value < 0.0F ? value : 0.0F;
  return masked(value, -(freedom >> 1)) + masked(gain, -(freedom & 1));
}

/// The freedom of the nodes of a block as numbers of four bytes.
struct Freedoms {
  template <class Count>
  [[gnu::always_inline]] Freedoms(const std::uint8_t* freedom, Count n) {
    for (std::size_t i = 0; i < n; ++i)
      codes[i] = freedom[i];
  }

  std::array<std::int32_t, block_nodes> codes;
};

template <std::size_t bytes>
[[gnu::always_inline]] inline double sum_of_free(const NodeFields& f) {
  Lanes<bytes> sum;
  each_node_block(
      f.nodes, [&](std::size_t first, auto n) __attribute__((always_inline)) {
        const float* const z = f.preconditioned + first;
        const Freedoms freedom(f.freedom + first, n);
        Terms terms(n);
        for (std::size_t i = 0; i < n; ++i)
          terms[i] =
              static_cast<double>(masked(z[i], freedom.codes[i] > 0 ? -1 : 0));
        terms.scale(f.weight, first, n);
        sum.add(terms);
      });
  return sum.total();
}

template <std::size_t bytes>
[[gnu::always_inline]] inline TwoSums slopes(const NodeFields& f, float mean) {
  Lanes<bytes> now, change;
  each_node_block(
      f.nodes, [&](std::size_t first, auto n) __attribute__((always_inline)) {
        const float* const z = f.preconditioned + first;
        const float* const r = f.residual + first;
        const float* const before = f.previous_residual + first;
        const Freedoms freedom(f.freedom + first, n);
        Terms nows(n), changes(n);
        for (std::size_t i = 0; i < n; ++i) {
          const double slope =
              static_cast<double>(restricted(z[i] - mean, freedom.codes[i]));
          nows[i] = slope * static_cast<double>(r[i]);
          changes[i] = slope * static_cast<double>(r[i] - before[i]);
        }
        nows.scale(f.weight, first, n);
        changes.scale(f.weight, first, n);
        now.add(nows);
        change.add(changes);
      });
  return {now.total(), change.total()};
}

template <std::size_t bytes>
[[gnu::always_inline]] inline double conjugate(const NodeFields& f, float mean,
                                               float beta, float* direction) {
  Lanes<bytes> slope;
  each_node_block(
      f.nodes, [&](std::size_t first, auto n) __attribute__((always_inline)) {
        const float* const z = f.preconditioned + first;
        const float* const r = f.residual + first;
        float* const d = direction + first;
        const Freedoms freedom(f.freedom + first, n);
        Terms terms(n);
        for (std::size_t i = 0; i < n; ++i) {
          const float own = restricted(z[i] - mean, freedom.codes[i]);
          const float value = restricted(own + beta * d[i], freedom.codes[i]);
          d[i] = value;
          terms[i] = static_cast<double>(value) * static_cast<double>(r[i]);
        }
        terms.scale(f.weight, first, n);
        slope.add(terms);
      });
  return slope.total();
}

template <std::size_t bytes>
[[gnu::always_inline]] inline double energy(const NodeFields& f,
                                            double compliance) {
  Lanes<bytes> sum;
  each_node_block(
      f.nodes, [&](std::size_t first, auto n) __attribute__((always_inline)) {
        const float* const d = f.direction + first;
        const float* const cd = f.displaced + first;
        Terms terms(n);
        for (std::size_t i = 0; i < n; ++i) {
          const double own = static_cast<double>(d[i]);
          terms[i] = own * (static_cast<double>(cd[i]) + compliance * own);
        }
        terms.scale(f.weight, first, n);
        sum.add(terms);
      });
  return sum.total();
}

template <std::size_t bytes>
[[gnu::always_inline]] inline TwoSums advance(const NodeFields& f,
                                              double step) {
  Lanes<bytes> total, cuts;
  each_node_block(
      f.nodes, [&](std::size_t first, auto n) __attribute__((always_inline)) {
        const float* const d = f.direction + first;
        double* const p = f.pressure + first;
        float* const dp = f.change + first;
        Terms totals(n), cut(n);
        for (std::size_t i = 0; i < n; ++i) {
          const double wish = p[i] - step * static_cast<double>(d[i]);
          const double kept = wish > 0.0 ? wish : 0.0;
          dp[i] = static_cast<float>(kept - p[i]);
          p[i] = kept;
          totals[i] = kept;
          cut[i] = kept - wish;
        }
        totals.scale(f.weight, first, n);
        total.add(totals);
        cuts.add(cut);
      });
  return {total.total(), cuts.total()};
}

template <class Field>
Field* moved(Field* field, std::size_t nodes) {
  return field != nullptr ? field + nodes : nullptr;
}

} // namespace

NodeFields NodeFields::at(std::size_t begin, std::size_t end) const {
  return {end - begin,
          moved(weight, begin),
          moved(pressure, begin),
          moved(raw_gap, begin),
          moved(residual, begin),
          moved(previous_residual, begin),
          moved(freedom, begin),
          moved(preconditioned, begin),
          moved(direction, begin),
          moved(displaced, begin),
          moved(change, begin)};
}

double sum_free(const NodeFields& fields) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return sum_of_free<bytes()>(fields);
  });
}

TwoSums sum_slopes(const NodeFields& fields, float mean) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return slopes<bytes()>(fields, mean);
  });
}

double conjugate_nodes(const NodeFields& fields, float mean, float beta,
                       float* direction) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return conjugate<bytes()>(fields, mean, beta, direction);
  });
}

double sum_energy(const NodeFields& fields, double compliance) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return energy<bytes()>(fields, compliance);
  });
}

TwoSums advance_nodes(const NodeFields& fields, double step) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return advance<bytes()>(fields, step);
  });
}

} // namespace asperity::contact
