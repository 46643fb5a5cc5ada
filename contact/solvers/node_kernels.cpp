#include "contact/solvers/node_kernels.hpp"

#include "base/simd_pack.hpp"
#include "contact/solvers/node_lanes.hpp"

namespace asperity::contact {
namespace {

// Products of two single-precision fields, and their sums over a block, are in
// single precision: conversions would take most of the time. The factor `scale`
// keeps them from underflow.

/// Which changes the Freedom of adjacent nodes allows.
template <std::size_t bytes>
struct Changes {
  using Pack = NodePack<bytes, float>;
  using Mask = typename Pack::template Mask<float>;

  [[gnu::always_inline]] explicit Changes(const std::uint8_t* freedom) {
    Pack::template convert<std::int32_t>(freedom, codes);
  }

  /// allowed() of contact_state.hpp: a Freedom of 2 allows every change, 1 only
  /// negative ones.
  [[gnu::always_inline]] void
  restrict_to_allowed(typename Pack::Reals& values) const {
    Mask mask;
    Pack::template negative<float>(values, mask);
    mask = -(codes >> 1) | (-(codes & 1) & mask);
    Pack::template restrict_to<float>(mask, values);
  }

  [[gnu::always_inline]] void
  restrict_to_active(typename Pack::Reals& values) const {
    const Mask mask = -(codes >> 1) | -(codes & 1);
    Pack::template restrict_to<float>(mask, values);
  }

  Mask codes;
};

template <std::size_t bytes>
[[gnu::always_inline]] inline double sum_of_free(const NodeFields& all) {
  using Pack = NodePack<bytes, float>;
  Lanes<bytes> total;
  each_node_block(
      all, [&](const NodeFields& f, std::size_t first, std::size_t,
               auto weights) __attribute__((always_inline)) {
        const float* const z = f.preconditioned + first;
        const std::uint8_t* const freedom = f.freedom + first;
        Lanes<bytes, float> sum;
        each_pack<Pack>([&](std::size_t i,
                            std::size_t part) __attribute__((always_inline)) {
          typename Pack::Reals own;
          Pack::take(z + i, own);
          Changes<bytes>(freedom + i).restrict_to_active(own);
          Pack::scale(weights, i, own);
          sum.parts[part] += own;
        });
        total.add(sum);
      });
  return total.total();
}

template <std::size_t bytes>
[[gnu::always_inline]] inline TwoSums slopes(const NodeFields& all,
                                             float mean) {
  using Pack = NodePack<bytes, float>;
  const float scale = all.product_scale;
  Lanes<bytes> now, change;
  each_node_block(
      all, [&](const NodeFields& f, std::size_t first, std::size_t,
               auto weights) __attribute__((always_inline)) {
        const float* const z = f.preconditioned + first;
        const float* const r = f.residual + first;
        const float* const before = f.previous_residual + first;
        const std::uint8_t* const freedom = f.freedom + first;
        Lanes<bytes, float> own_now, own_change;
        each_pack<Pack>([&](std::size_t i,
                            std::size_t part) __attribute__((always_inline)) {
          typename Pack::Reals own, residual, old;
          Pack::take(z + i, own);
          Pack::take(r + i, residual);
          Pack::take(before + i, old);
          own -= mean;
          Changes<bytes>(freedom + i).restrict_to_allowed(own);
          own *= scale;
          Pack::scale(weights, i, own);
          own_now.parts[part] += own * residual;
          own_change.parts[part] += own * (residual - old);
        });
        now.add(own_now);
        change.add(own_change);
      });
  return {now.total() / static_cast<double>(scale),
          change.total() / static_cast<double>(scale)};
}

template <std::size_t bytes>
[[gnu::always_inline]] inline double conjugate(const NodeFields& all,
                                               float mean, float beta) {
  using Pack = NodePack<bytes, float>;
  const float scale = all.product_scale;
  Lanes<bytes> slope;
  each_node_block(
      all, [&](const NodeFields& f, std::size_t first, std::size_t,
               auto weights) __attribute__((always_inline)) {
        const float* const z = f.preconditioned + first;
        const float* const r = f.residual + first;
        float* const direction = f.direction + first;
        const std::uint8_t* const freedom = f.freedom + first;
        Lanes<bytes, float> sum;
        each_pack<Pack>([&](std::size_t i, std::size_t part)
                            __attribute__((always_inline)) {
                              typename Pack::Reals own, old, residual;
                              Pack::take(z + i, own);
                              Pack::take(direction + i, old);
                              Pack::take(r + i, residual);
                              const Changes<bytes> changes(freedom + i);
                              own -= mean;
                              changes.restrict_to_allowed(own);
                              own += beta * old;
                              changes.restrict_to_allowed(own);
                              Pack::put(own, direction + i);
                              own *= scale;
                              Pack::scale(weights, i, own);
                              sum.parts[part] += own * residual;
                            });
        slope.add(sum);
      });
  return slope.total() / static_cast<double>(scale);
}

template <std::size_t bytes>
[[gnu::always_inline]] inline double energy(const NodeFields& all,
                                            float compliance) {
  using Pack = NodePack<bytes, float>;
  const float scale = all.product_scale;
  Lanes<bytes> total;
  each_node_block(
      all, [&](const NodeFields& f, std::size_t first, std::size_t,
               auto weights) __attribute__((always_inline)) {
        const float* const direction = f.direction + first;
        const float* const displaced = f.displaced + first;
        Lanes<bytes, float> sum;
        each_pack<Pack>([&](std::size_t i, std::size_t part)
                            __attribute__((always_inline)) {
                              typename Pack::Reals own, displacement;
                              Pack::take(direction + i, own);
                              Pack::take(displaced + i, displacement);
                              displacement += compliance * own;
                              own *= scale;
                              Pack::scale(weights, i, own);
                              sum.parts[part] += own * displacement;
                            });
        total.add(sum);
      });
  return total.total() / static_cast<double>(scale);
}

template <std::size_t bytes>
[[gnu::always_inline]] inline TwoSums advance(const NodeFields& all,
                                              double step) {
  using Pack = NodePack<bytes, double>;
  using Doubles = typename Pack::Reals;
  Lanes<bytes> total, cuts;
  each_node_block(
      all, [&](const NodeFields& f, std::size_t first, std::size_t,
               auto weights) __attribute__((always_inline)) {
        const float* const direction = f.direction + first;
        double* const pressure = f.pressure + first;
        float* const change = f.change + first;
        each_pack<Pack>([&](std::size_t i,
                            std::size_t part) __attribute__((always_inline)) {
          Doubles own, wish;
          Pack::take(pressure + i, own);
          Pack::template convert<double>(direction + i, wish);
          wish = own - step * wish;
          Doubles kept = wish > 0.0 ? wish : Doubles{};
          Pack::put(kept, pressure + i);
          typename Pack::template Of<float> changed;
          Pack::template convert<float>(kept - own, changed);
          Pack::put(changed, change + i);
          cuts.parts[part] += kept - wish;
          Pack::scale(weights, i, kept);
          total.parts[part] += kept;
        });
      });
  return {total.total(), cuts.total()};
}

template <std::size_t bytes>
[[gnu::always_inline]] inline void scale(const NodeFields& all, double factor) {
  using Pack = NodePack<bytes, double>;
  each_node_block(
      all, [&](const NodeFields& f, std::size_t first, std::size_t,
               auto) __attribute__((always_inline)) {
        double* const pressure = f.pressure + first;
        float* const change = f.change + first;
        each_pack<Pack>([&](std::size_t i,
                            std::size_t) __attribute__((always_inline)) {
          typename Pack::Reals own;
          typename Pack::template Of<float> before, added;
          Pack::take(pressure + i, own);
          Pack::take(change + i, before);
          Pack::template convert<float>((factor - 1.0) * own, added);
          before += added;
          own *= factor;
          Pack::put(own, pressure + i);
          Pack::put(before, change + i);
        });
      });
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
          moved(change, begin),
          moved(heights, begin),
          product_scale};
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

double conjugate_nodes(const NodeFields& fields, float mean, float beta) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return conjugate<bytes()>(fields, mean, beta);
  });
}

double sum_energy(const NodeFields& fields, double compliance) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return energy<bytes()>(fields, static_cast<float>(compliance));
  });
}

TwoSums advance_nodes(const NodeFields& fields, double step) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return advance<bytes()>(fields, step);
  });
}

void scale_nodes(const NodeFields& fields, double factor) {
  on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    scale<bytes()>(fields, factor);
  });
}

} // namespace asperity::contact
