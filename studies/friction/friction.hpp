#pragma once

// [friction]: its settings, the columns of its answers, and its object.

#include "mechanics/quantity.hpp"
#include "results/types/curve_columns.hpp"
#include "studies/study.hpp"

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

/// [friction]: partial slip under tangential loads
/// (mechanics/partial_slip.hpp).
extern const Study friction_study;

/// Its pages, which its object joins.
const reports::StudyPages& friction_pages();

} // namespace asperity::studies

namespace asperity::columns {

inline const DirectedColumn stick_stiffness{
    "friction",
    {.name = "stick_stiffness",
     .unit = "Pa/m",
     .text = "half-space with `[friction]`: tangential load over "
             "displacement of far points along x, per nominal area, if all "
             "of the contact sticks ([friction](../numerics/friction.md))"}};

} // namespace asperity::columns
