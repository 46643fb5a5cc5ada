#pragma once

// The tables of [magnification]; docs/reference/results.md lists the column
// names. Equation numbers refer to Yang and Persson (2008).

#include "results/types/result.hpp"
#include "studies/magnification/magnification.hpp"
#include "theory/persson/magnification.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::studies {

/// Returns one contact per load of a study.
std::vector<theory::MagnifiedContact>
magnified_contacts(const theory::PerssonContact& contact,
                   const MagnificationStudy& study);

/// Returns a table with one row per load: contact area fraction, mean gap and
/// the limits of zeta.
results::Table loads_table(std::span<const theory::MagnifiedContact> contacts);

/// Returns a table with one row per magnification: A, h_rms, u, u from Eq. (23)
/// as printed, u_1 (infinite near zeta_0, as opening_gap() returns it) and the
/// density of Eq. (27) at u_1.
results::Table magnification_table(const std::string& name,
                                   const theory::MagnifiedContact& contact,
                                   const MagnificationStudy& study);

/// Returns quantiles of the distribution of u_1, Eq. (27), with its density.
/// They are closely spaced at both ends. The title gives the weight of the
/// delta function.
results::Table gap_distribution_table(const std::string& name,
                                      const theory::MagnifiedContact& contact);

/// Returns a table with one row per load: the critical pore and the leakage
/// through it. Values are NaN if the open area does not percolate.
results::Table leak_table(std::span<const theory::MagnifiedContact> contacts,
                          const LeakStudy& study);

} // namespace asperity::studies
