#pragma once

// Look-up of objects by place with a tolerance for roundoff of the coordinates.

#include <deal.II/base/point.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace asperity::fem {

/// A map from places to numbers of objects. Places closer than the tolerance
/// are considered equal; different places must be at least three tolerances
/// apart.
class PlaceMap {
public:
  /// @param tolerance  [m] > 0
  explicit PlaceMap(double tolerance) : tolerance_(tolerance) {}

  void insert(const dealii::Point<3>& place, std::size_t thing) {
    things_.emplace(key(place), thing);
  }

  std::optional<std::size_t> find(const dealii::Point<3>& place) const {
    const Key middle = key(place);
    for (int i = 0; i < 27; ++i) {
      const auto found =
          things_.find({middle[0] + shift(i % 3), middle[1] + shift(i / 3 % 3),
                        middle[2] + shift(i / 9)});
      if (found != things_.end())
        return found->second;
    }
    return {};
  }

private:
  using Key = std::array<std::int64_t, 3>;

  static int shift(int i) { return i == 2 ? -1 : i; } // starts with 0

  Key key(const dealii::Point<3>& place) const {
    return {std::llround(place[0] / tolerance_),
            std::llround(place[1] / tolerance_),
            std::llround(place[2] / tolerance_)};
  }

  double tolerance_;
  std::map<Key, std::size_t> things_;
};

} // namespace asperity::fem
