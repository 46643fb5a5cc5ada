#pragma once

// What the theory's studies find, as tables of a result. Pure functions from
// the theory to columns; which names they have is written in docs/results.md.

#include "cases/types/studies.hpp"
#include "results/types/result.hpp"
#include "theory/persson/adhesion.hpp"
#include "theory/persson/magnification.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::app {

/// One contact under each load of a study.
std::vector<theory::MagnifiedContact>
magnified_contacts(const theory::PerssonContact& contact,
                   const cases::MagnificationStudy& study);

/// A row a load: its weight of contact, its mean gap, the ends of zeta.
results::Table loads_table(std::span<const theory::MagnifiedContact> contacts);

/// A row a magnification: A, h_rms, u, u to the letter of (23), u_1 (infinite
/// where the library's is, near zeta_0) and the density of (27) at u_1.
results::Table magnification_table(const std::string& name,
                                   const theory::MagnifiedContact& contact,
                                   const cases::MagnificationStudy& study);

/// Quantiles of the distribution (27) of u_1 with its density, close together
/// at both ends; the weight of its delta function is in the title.
results::Table gap_distribution_table(const std::string& name,
                                      const theory::MagnifiedContact& contact);

/// A row a load: the critical pore and what leaks through it; NaN where the
/// open area does not percolate.
results::Table leak_table(std::span<const theory::MagnifiedContact> contacts,
                          const cases::LeakStudy& leak);

/// A row a height ratio: partial, complete and equilibrium contact. NaN where
/// a state does not exist; a partial contact that did not converge is NaN too,
/// and the title counts those.
results::Table adhesion_table(const theory::RoughAdhesion& adhesion,
                              const cases::AdhesionStudy& study,
                              double rms_height);

/// One row: the ratio of the flip and the area there (NaN: none between two
/// ratios of the study), and gamma_eff of complete contact at ratio 1.
/// @param rows  of adhesion_table()
results::Table adhesion_flip_table(const theory::RoughAdhesion& adhesion,
                                   const cases::AdhesionStudy& study,
                                   const results::Table& rows);

} // namespace asperity::app
