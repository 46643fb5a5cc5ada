#pragma once

// [conductance]: its settings and the columns of its answers.

#include "results/types/curve_columns.hpp"

#include <optional>

namespace asperity::studies {

/// [conductance]: two bodies that exchange heat and current through the spots
/// of contact, and heat through the medium in the gap.
struct ConductanceStudy {
  /// Of the block and of the body on it.
  std::optional<double> thermal_conductivity;         ///< [W/(m K)] > 0
  std::optional<double> counter_thermal_conductivity; ///< [W/(m K)] > 0
  std::optional<double> resistivity;                  ///< [Ohm m] > 0
  std::optional<double> counter_resistivity;          ///< [Ohm m] > 0
  /// Of the medium in the gap; none: it conducts nothing. It passes heat as if
  /// the gap were at least the smallest one.
  std::optional<double> gap_conductivity; ///< [W/(m K)] > 0
  std::optional<double> smallest_gap;     ///< [m] > 0

  /// The harmonic mean of the bodies, 2 k_1 k_2/(k_1 + k_2) [W/(m K)], which
  /// must be given.
  double conductivity() const {
    return 2.0 /
           (1.0 / *thermal_conductivity + 1.0 / *counter_thermal_conductivity);
  }
};

} // namespace asperity::studies

namespace asperity::columns {

inline const CurveColumn relative_conductance{
    "conductance",
    {.name = "relative_conductance",
     .unit = "1/m",
     .text = "with `[conductance]` only: "
             "[conductance](../numerics/conductance.md) of the spots per "
             "nominal area, over the harmonic mean of the conductivities"}};

inline const CurveColumn relative_gap_conductance{
    "conductance",
    {.name = "relative_gap_conductance",
     .unit = "1/m",
     .text = "with `gap_conductivity` only: what [the medium in the "
             "gap](../numerics/conductance.md#heat-through-the-gap) adds "
             "to `relative_conductance`"}};

inline const CurveColumn thermal_conductance{
    "conductance",
    {.name = "thermal_conductance",
     .unit = "W/(m^2 K)",
     .text = "with `[conductance]` and conductivities: conductance of "
             "heat, with the medium in the gap"}};

inline const CurveColumn electrical_conductance{
    "conductance",
    {.name = "electrical_conductance",
     .unit = "1/(Ohm m^2)",
     .text = "with `[conductance]` and resistivities: conductance of "
             "current"}};

} // namespace asperity::columns
