#include "base/simd_pack.hpp"
#include "contact/solvers/node_kernels.hpp"
#include "contact/solvers/node_lanes.hpp"

#include <array>
#include <cstring>
#include <limits>

namespace asperity::contact {
namespace {

/// Counts nodes, eight of them at a time as the bytes of a number.
template <std::size_t bytes>
class FreedomCount {
public:
  /// Sets the freedom of the nodes of a block. Returns whether a node is
  /// active.
  [[gnu::always_inline]] bool
  store(const std::array<double, block_nodes>& codes, std::uint8_t* freedom) {
    std::array<std::int32_t, block_nodes> narrow; // one conversion at a time
    for (std::size_t i = 0; i < block_nodes; ++i)
      narrow[i] = static_cast<std::int32_t>(codes[i]);
    std::array<std::uint8_t, block_nodes> now;
    for (std::size_t i = 0; i < block_nodes; ++i)
      now[i] = static_cast<std::uint8_t>(narrow[i]);
    if (n_stored_ == most_stored)
      add_counts();
    ++n_stored_;
    Eights any{};
    for (std::size_t i = 0; i < block_nodes; i += bytes) {
      Eights was, is;
      std::memcpy(&was, freedom + i, bytes);
      std::memcpy(&is, now.data() + i, bytes);
      is = (is | is >> 1U) & ones; // 1 in the bytes of active nodes
      any |= is;
      active_ += is;
      changed_ += is ^ ((was | was >> 1U) & ones);
    }
    std::memcpy(freedom, now.data(), block_nodes);
    std::uint64_t bits = 0;
    for (const std::uint64_t number : numbers_of(any))
      bits |= number;
    return bits != 0;
  }

  [[gnu::always_inline]] double active() const {
    return n_active_ + total(active_);
  }

  /// Nodes that became active or inactive.
  [[gnu::always_inline]] double changed() const {
    return n_changed_ + total(changed_);
  }

private:
  using Eights = typename SimdPack<std::uint64_t, bytes>::Type;
  static constexpr std::uint64_t ones = 0x0101010101010101U;
  /// A block adds up to block_nodes / bytes to a byte, which holds up to 255.
  static constexpr int most_stored = 255 / (block_nodes / bytes);

  void add_counts() {
    n_active_ += total(active_);
    n_changed_ += total(changed_);
    active_ = changed_ = Eights{};
    n_stored_ = 0;
  }

  [[gnu::always_inline]] static auto numbers_of(const Eights& eights) {
    std::array<std::uint64_t, bytes / sizeof(std::uint64_t)> numbers;
    std::memcpy(numbers.data(), &eights, bytes);
    return numbers;
  }

  /// The sum of all bytes.
  [[gnu::always_inline]] static double total(const Eights& eights) {
    constexpr std::uint64_t even = 0x00ff00ff00ff00ffU;
    std::uint64_t sum = 0;
    for (const std::uint64_t number : numbers_of(eights))
      sum += ((number & even) + (number >> 8U & even)) * 0x0001000100010001U >>
             48U;
    return static_cast<double>(sum);
  }

  Eights active_{}, changed_{}; ///< counts of the last blocks
  int n_stored_ = 0;            ///< blocks in them
  double n_active_ = 0.0, n_changed_ = 0.0;
};

/// The Freedom of adjacent nodes, 1 with the bits `is_free` and 2 with those of
/// `is_pushed` as well; `counted` is 1 at the active ones.
template <class Pack>
[[gnu::always_inline]] inline void
put_codes(const typename Pack::template Mask<double>& is_free,
          const typename Pack::template Mask<double>& is_pushed,
          typename Pack::Reals& counted, double* codes) {
  typename Pack::Reals code = typename Pack::Reals{} + 1.0;
  counted = code;
  Pack::template restrict_to<double>(is_free, counted);
  Pack::template restrict_to<double>(is_pushed, code);
  code += counted;
  Pack::put(code, codes);
}

template <std::size_t bytes>
[[gnu::always_inline]] inline MeasuredNodes
measure(const NodeFields& all, double rigid, double compliance,
        std::uint8_t* active) {
  using Pack = NodePack<bytes, double>;
  using Doubles = typename Pack::Reals;
  using Mask = typename Pack::template Mask<double>;
  const bool is_hard = compliance == 0.0;
  const Mask magnitude = Mask{} + std::numeric_limits<std::int64_t>::max();
  Lanes<bytes> error, sum, weight;
  FreedomCount<bytes> counts;
  each_node_block(
      all, [&](const NodeFields& f, std::size_t first, std::size_t block,
               auto weights) __attribute__((always_inline)) {
        if (active[block] == 0)
          return;
        const double* const pressure = f.pressure + first;
        const double* const raw_gap = f.raw_gap + first;
        float* const residual = f.residual + first;
        alignas(bytes) std::array<double, block_nodes> codes;
        each_pack<Pack>([&](std::size_t i,
                            std::size_t part) __attribute__((always_inline)) {
          Doubles own, value;
          Pack::take(pressure + i, own);
          Pack::take(raw_gap + i, value);
          if (!is_hard)
            value += compliance * own;
          value += rigid;
          sum.parts[part] += value;
          Mask is_free, is_pushed;
          Pack::template negative<double>(0.0 - own, is_pushed);
          Pack::template negative<double>(value, is_free);
          is_free |= is_pushed;
          Pack::template restrict_to<double>(is_free, value);
          typename Pack::template Of<float> narrow;
          Pack::template convert<float>(value, narrow);
          Pack::put(narrow, residual + i);
          Pack::template restrict_to<double>(magnitude, value);
          error.parts[part] =
              value > error.parts[part] ? value : error.parts[part];
          Doubles counted;
          put_codes<Pack>(is_free, is_pushed, counted, codes.data() + i);
          if constexpr (!std::is_same_v<decltype(weights), EqualWeights>) {
            Pack::scale(weights, i, counted);
            weight.parts[part] += counted;
          }
        });
        active[block] = counts.store(codes, f.freedom + first) ? 1 : 0;
      });
  return {0.0 * sum.total() + error.largest(),
          all.weight != nullptr ? weight.total() : counts.active(),
          counts.changed()};
}

/// The lowest number of a block.
template <std::size_t bytes>
struct Lowest {
  using Doubles = typename NodePack<bytes, double>::Reals;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  [[gnu::always_inline]] Lowest() {
    for (auto& part : least.parts)
      part += infinity;
  }

  [[gnu::always_inline]] void take(const Doubles& values, std::size_t part) {
    least.parts[part] = values < least.parts[part] ? values : least.parts[part];
    sum.parts[part] += values;
  }

  /// Minus infinity if a number is not finite.
  [[gnu::always_inline]] double value() const {
    Doubles both = sum.parts[0];
    for (std::size_t part = 1; part < sum.parts.size(); ++part)
      both += sum.parts[part];
    Lanes<bytes> all = least;
    const Doubles lowest_of_all = Doubles{} - infinity;
    both *= 0.0;
    all.parts[0] = both == 0.0 ? all.parts[0] : lowest_of_all;
    return all.smallest();
  }

  Lanes<bytes> least, sum;
};

/// gap += factor displaced
template <std::size_t bytes>
struct AddDisplaced {
  using Pack = NodePack<bytes, double>;

  [[gnu::always_inline]] AddDisplaced at(const NodeFields& f,
                                         std::size_t first) const {
    return {factor, f.displaced + first};
  }

  [[gnu::always_inline]] void operator()(std::size_t i,
                                         typename Pack::Reals& gap) const {
    typename Pack::Reals change;
    Pack::template convert<double>(displaced + i, change);
    gap += factor * change;
  }

  double factor;
  const float* displaced = nullptr;
};

/// gap -= heights
template <std::size_t bytes>
struct SubtractHeights {
  using Pack = NodePack<bytes, double>;

  [[gnu::always_inline]] SubtractHeights at(const NodeFields& f,
                                            std::size_t first) const {
    return {f.heights + first};
  }

  [[gnu::always_inline]] void operator()(std::size_t i,
                                         typename Pack::Reals& gap) const {
    typename Pack::Reals own;
    Pack::take(heights + i, own);
    gap -= own;
  }

  const double* heights = nullptr;
};

/// Calls change_gap.at(fields, first node of a block)(node of it, raw_gap) for
/// vectors of nodes. A block has either sums over its contact or a lowest gap:
/// one loop with both waits for registers.
template <std::size_t bytes, class ChangeGap>
[[gnu::always_inline]] inline TwoSums
change(const NodeFields& all, const ChangeGap& change_gap, double compliance,
       const std::uint8_t* active, double* lowest) {
  using Pack = NodePack<bytes, double>;
  using Doubles = typename Pack::Reals;
  const bool is_hard = compliance == 0.0;
  Lanes<bytes> residual, weight;
  each_node_block(
      all, [&](const NodeFields& f, std::size_t first, std::size_t block,
               auto weights) __attribute__((always_inline)) {
        double* const raw_gap = f.raw_gap + first;
        const double* const pressure = f.pressure + first;
        const ChangeGap change_own = change_gap.at(f, first);
        if (active[block] == 0) {
          Lowest<bytes> least;
          each_pack<Pack>([&](std::size_t i, std::size_t part)
                              __attribute__((always_inline)) {
                                Doubles gap;
                                Pack::take(raw_gap + i, gap);
                                change_own(i, gap);
                                Pack::put(gap, raw_gap + i);
                                least.take(gap, part);
                              });
          lowest[block] = least.value();
          return;
        }
        each_pack<Pack>([&](std::size_t i,
                            std::size_t part) __attribute__((always_inline)) {
          Doubles own, gap, counted = Doubles{} + 1.0;
          Pack::take(pressure + i, own);
          Pack::take(raw_gap + i, gap);
          change_own(i, gap);
          Pack::put(gap, raw_gap + i);
          if (!is_hard)
            gap += compliance * own;
          typename Pack::template Mask<double> is_pushed;
          Pack::template negative<double>(0.0 - own, is_pushed);
          Pack::template restrict_to<double>(is_pushed, gap);
          Pack::template restrict_to<double>(is_pushed, counted);
          Pack::scale(weights, i, gap);
          Pack::scale(weights, i, counted);
          residual.parts[part] += gap;
          weight.parts[part] += counted;
        });
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
    return change<bytes()>(fields, AddDisplaced<bytes()>{factor}, compliance,
                           active, lowest);
  });
}

TwoSums subtract_heights(const NodeFields& fields, double compliance,
                         const std::uint8_t* active, double* lowest) {
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return change<bytes()>(fields, SubtractHeights<bytes()>(), compliance,
                           active, lowest);
  });
}

} // namespace asperity::contact
