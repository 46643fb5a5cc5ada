#pragma once

// curves.csv: every step of every curve as one table for other programs.

#include "results/types/result.hpp"

#include <filesystem>
#include <string>

namespace asperity::results {

/// RFC 4180 (lines end in CR LF, a field with comma, quote or line end is
/// quoted): a header with the units, then a row a step,
///
///     method,realization,step,nominal_pressure [Pa],mean_gap [m],
///     area_fraction [1],area_fraction_corrected [1],area_fraction_fit [1],
///     area_fraction_moment [1],contact_perimeter [1/m],
///     elastic_energy [J/m^2],contact_stiffness [Pa/m],iterations,residual,
///     cpu_time [s],status
///
/// Numbers have the fewest digits that give the same double back; one a method
/// does not have is "nan". Status is converged or not_converged.
std::string curves_csv(const Result& result);

/// Writes it whole or not at all.
/// @throws std::system_error  naming the path
void write_curves_csv(const Result& result, const std::filesystem::path& path);

} // namespace asperity::results
