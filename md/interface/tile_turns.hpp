#pragma once

// The loop of the SIMD kernels over all tiles of some atoms: it provides the
// distances and the beginning of the law of each vector in time.

#include "md/interface/tile_distances.hpp"

#include <cstddef>
#include <span>

namespace asperity::md {

// A division takes as long as half of the other operations of a tile, and the
// chain of operations from a distance to a force is too long for a processor to
// have enough tiles in flight. Each turn of the loop therefore works on several
// vectors: it computes the distances of one, divides for an earlier one, begins
// the law of a still earlier one and completes that of the first.
constexpr std::size_t divided_ahead = 3; ///< vectors
static_assert(divided_ahead < stored_ahead);

/// The law of ReducedLaw for the lanes of a vector, in two steps.
template <std::size_t bytes>
struct Law {
  using Vector = typename Lanes<bytes>::Vector;
  Vector y_end, y_begin, square, third, cube, lever;

  [[gnu::always_inline]] explicit Law(const ReducedLaw& law)
      : y_end(Vector{} + law.y_end),
        y_begin(Vector{} + (law.y_end + law.width)),
        square(Vector{} + law.square),
        third(Vector{} + law.square / 3.0),
        cube(Vector{} + law.cube),
        lever(Vector{} + law.lever) {}

  /// y, u and v of 1/r^2.
  [[gnu::always_inline]] void begin(const Vector& inverse, Vector& y, Vector& u,
                                    Vector& v) const {
    y = inverse * inverse * inverse;
    const Vector above = y > y_end ? y : y_end;
    const Vector tapered = above < y_begin ? above : y_begin;
    u = tapered - y_end;
    v = above - tapered;
  }
};

/// Goes through all tiles, one vector per turn.
template <std::size_t bytes>
class Turns {
public:
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;

  [[gnu::always_inline]] Turns(const Law<bytes>& law,
                               std::span<const Window> windows, double spacing,
                               typename Distances<bytes>::OfTile* stored)
      : law_(law), distances_(windows, spacing, stored) {
    for (std::size_t i = 0; i < divided_ahead; ++i)
      inverse_[i] = 1.0 / distances_.square(i);
    law_.begin(inverse_[0], y_, u_, v_);
  }

  /// Gives 1/r^2, y, u and v of the vector of this turn and begins a later one.
  [[gnu::always_inline]] void next(std::size_t part, Vector& inverse, Vector& y,
                                   Vector& u, Vector& v) {
    const Vector latest = 1.0 / distances_.square(part + divided_ahead);
    inverse = inverse_[0];
    y = y_;
    u = u_;
    v = v_;
    for (std::size_t i = 0; i + 1 < divided_ahead; ++i)
      inverse_[i] = inverse_[i + 1];
    inverse_[divided_ahead - 1] = latest;
    law_.begin(inverse_[0], y_, u_, v_);
  }

  [[gnu::always_inline]] const Vector& dz(std::size_t part) const {
    return distances_.dz(part);
  }

  [[gnu::always_inline]] void next_tile() { distances_.next_tile(); }

private:
  Law<bytes> law_;
  Distances<bytes> distances_;
  Vector inverse_[divided_ahead];
  Vector y_, u_, v_;
};

} // namespace asperity::md
