#pragma once

// [conductance]: its settings, the columns of its answers, and its object.

#include "results/types/method_columns.hpp"
#include "studies/study.hpp"

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

/// [conductance]: heat and current through the contact of each load step, and
/// its normal stiffness (contact/solvers/punch_stiffness.hpp).
extern const Study conductance_study;

/// Its pages, which its object joins.
const reports::StudyPages& conductance_pages();

} // namespace asperity::studies

namespace asperity::columns {

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
