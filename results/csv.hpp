#pragma once

// Writes every step of every curve as tables for use by other programs:
// curves.csv with what was computed, times.csv with what it cost.

#include "results/types/result.hpp"

#include <string>

namespace asperity::results {

/// Returns the table in the format of RFC 4180 (lines end in CR LF; a field
/// with a comma, a quote or a line break is quoted). A header with the units is
/// followed by one row per step:
///
///     method,realization,step,nominal_pressure [Pa],mean_gap [m],
///     area_fraction [1],area_fraction_corrected [1],contact_perimeter [1/m],
///     elastic_energy [J/m^2],contact_energy [J/m^2],contact_stiffness [Pa/m],
///     iterations,residual,is_unloading,...,status
///
/// Between is_unloading and status are the columns of methods and studies in
/// which some row has a number (curve_columns.hpp).
///
/// Two runs of one case by one build give the same bytes. Numbers have the
/// fewest digits that reproduce the same double. A quantity that a method does
/// not provide is "nan". The status is converged or not_converged.
std::string curves_csv(const Result& result);

/// Returns the CPU times in the same format, which differ from run to run:
///
///     method,realization,step,cpu_time [s],transform_time [s],
///     observation_time [s]
///
/// A row without a step gives the set-up time of a method on a realisation.
std::string times_csv(const Result& result);

} // namespace asperity::results
