#pragma once

// The tables of [adhesion]; docs/reference/results.md lists the column names.

#include "results/types/result.hpp"
#include "studies/adhesion/adhesion.hpp"
#include "theory/persson/adhesion.hpp"

namespace asperity::studies {

/// Returns a table with one row per height ratio: partial, complete and
/// equilibrium contact. Values are NaN if a state does not exist or if its
/// partial contact did not converge; the title counts the latter.
results::Table adhesion_table(const theory::RoughAdhesion& adhesion,
                              const AdhesionStudy& study, double rms_height);

/// Returns a table with one row: the height ratio of the transition from
/// complete to partial contact and the area there (NaN if there is none between
/// two ratios of the study), and gamma_eff of complete contact at ratio 1.
///
/// @param rows  rows of adhesion_table()
results::Table adhesion_flip_table(const theory::RoughAdhesion& adhesion,
                                   const AdhesionStudy& study,
                                   const results::Table& rows);

} // namespace asperity::studies
