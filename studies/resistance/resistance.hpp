#pragma once

#include "results/types/curve_columns.hpp"
#include "studies/study.hpp"

namespace asperity::columns {

inline const CurveColumn thermal_resistance{
    "resistance",
    {.name = "thermal_resistance",
     .unit = "m^2 K/W",
     .text = "with `[conductance]` and conductivities: [resistance]"
             "(../numerics/conductance.md#resistance) of the nominal area to "
             "heat, 1/`thermal_conductance`; NaN without contact"}};

inline const CurveColumn electrical_resistance{
    "resistance",
    {.name = "electrical_resistance",
     .unit = "Ohm m^2",
     .text = "likewise to current, with resistivities"}};

} // namespace asperity::columns

namespace asperity::studies {

/// The thermal and the electrical resistance of the contact, where
/// [conductance] has the conductivities for them.
extern const Study resistance_study;

/// Its part, which its object joins.
const reports::StudyPages& resistance_pages();

} // namespace asperity::studies
