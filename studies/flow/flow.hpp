#pragma once

// [flow]: its settings, the columns of its answers, and its object.

#include "results/types/curve_columns.hpp"
#include "studies/study.hpp"

#include <array>
#include <optional>
#include <utility>

namespace asperity::studies {

/// Fluids that users and answers call by their names, and their viscosities at
/// 25 C and 100 kPa [Pa s].
/// @see  W. M. Haynes (ed.), CRC Handbook of Chemistry and Physics
inline constexpr std::array<std::pair<const char*, double>, 2> named_fluids{
    {{"water", 0.89e-3}, {"air", 1.85e-5}}};

/// [flow]: a fluid that a pressure drop drives through the gap.
struct FlowStudy {
  double viscosity = 0.0;       ///< eta [Pa s] > 0
  double pressure_drop = 0.0;   ///< Dp [Pa] >= 0
  std::optional<double> length; ///< of the seal, along the flow [m] > 0
  std::optional<double> width;  ///< of the seal, across the flow [m] > 0

  /// Width over length; 1 if they are not given.
  double aspect() const { return width.value_or(1.0) / length.value_or(1.0); }
};

/// [flow]: the flow of a fluid through the gap of each load step by Reynolds'
/// equation (mechanics/flow/reynolds.hpp), and of a theory by the effective
/// medium.
extern const Study flow_study;

/// Its pages, which its object joins.
const reports::StudyPages& flow_pages();

} // namespace asperity::studies

namespace asperity::columns {

inline const DirectedColumn flow_factor{
    "flow",
    {.name = "flow_factor",
     .unit = "1",
     .text = "with `[flow]` only: [flow through the "
             "gap](../numerics/flow.md) along x over that of smooth faces "
             "at the mean gap; 0 if the contact is sealed, NaN if the step "
             "has not converged"}};

inline const DirectedColumn flow_conductance{
    "flow",
    {.name = "flow_conductance",
     .unit = "m^3",
     .text = "likewise the flow of a square with 12 eta = Dp = 1"}};

inline const DirectedColumn critical_gap{
    "flow",
    {.name = "critical_gap",
     .unit = "m",
     .text = "likewise the narrowest place of the widest path; theory: u_1 "
             "where the open area percolates"}};

inline const DirectedColumn leak_rate{
    "flow",
    {.name = "leak_rate",
     .unit = "m^3/s",
     .text = "likewise the leak rate of the seal"}};

inline const CurveColumn effective_medium{
    "flow",
    {.name = "effective_medium",
     .unit = "m^3",
     .text = "likewise the flow of a square by the effective medium, which "
             "has no direction"}};

} // namespace asperity::columns
