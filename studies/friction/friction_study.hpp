#pragma once

// [friction]: its settings and the columns of its answers.

#include "mechanics/quantity.hpp"
#include "results/types/curve_columns.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace asperity::studies {

/// [friction]: partial slip under one normal load of the case.
struct FrictionStudy {
  double coefficient = 0.0; ///< mu [1] > 0
  /// P, nominal [Pa] > 0; none: the largest load.
  std::optional<mechanics::Quantity> normal_load;
  /// Q/(mu P) [1] of tangential loads that get load steps of their own.
  std::vector<mechanics::Quantity> tangential_loads;
  /// The load steps of P and of the lighter load nearest to P/2, whose maps
  /// give that of the traction; empty unless the loads are pressures that rise.
  std::vector<std::size_t> map_steps = {};
};

} // namespace asperity::studies

namespace asperity::columns {

inline const CurveColumn stick_stiffness_x{
    "friction",
    {.name = "stick_stiffness_x",
     .unit = "Pa/m",
     .text = "half-space with `[friction]`: tangential load over "
             "displacement of far points along x, per nominal area, if all "
             "of the contact sticks ([friction](../numerics/friction.md))"}};

inline const CurveColumn stick_stiffness_y{
    "friction",
    {.name = "stick_stiffness_y", .unit = "Pa/m", .text = "likewise along y"}};

} // namespace asperity::columns
