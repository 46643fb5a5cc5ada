#include "studies/adhesion/adhesion_tables.hpp"

#include "base/special_numbers.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace asperity::studies {
namespace {

using results::Table;
using theory::AdhesiveState;
using theory::RoughAdhesion;

double ratio_at(const AdhesionStudy& study, int k) {
  return study.from + (study.to - study.from) * k / (study.points - 1);
}

/// Returns the row before the transition to partial contact, which lies between
/// this row and the next one; -1 if there is none.
int row_before_flip(const Table& rows) {
  const std::vector<double> partial = rows.values("binding_partial");
  const std::vector<double> complete = rows.values("binding_complete");
  for (std::size_t i = 0; i + 1 < partial.size(); ++i)
    if (!(partial[i] > complete[i]) && partial[i + 1] > complete[i + 1])
      return static_cast<int>(i);
  return -1;
}

} // namespace

Table adhesion_table(const RoughAdhesion& adhesion, const AdhesionStudy& study,
                     double rms_height) {
  Table table{"adhesion",
              "gamma_eff/Dgamma and A/A_0 against h_rms/h_rms0",
              {{"height_ratio", "1"},
               {"rms_height", "m"},
               {"binding_partial", "1"},
               {"binding_complete", "1"},
               {"binding_equilibrium", "1"},
               {"area_fraction_partial", "1"},
               {"area_fraction_complete", "1"},
               {"area_fraction_equilibrium", "1"}}};
  if (study.sphere_radius)
    table.columns.push_back({"pull_off_force", "N"});
  int failures = 0;
  for (int k = 0; k < study.points; ++k) {
    const double at = ratio_at(study, k);
    const AdhesiveState partial = adhesion.partial_contact(at);
    const AdhesiveState complete = adhesion.complete_contact(at);
    const AdhesiveState rest = adhesion.equilibrium(at);
    failures += partial.converged ? 0 : 1;
    std::vector<double> row{at, at * rms_height};
    const std::pair<bool, const AdhesiveState*> states[] = {
        {partial.exists && partial.converged, &partial},
        {true, &complete},
        {rest.exists && partial.converged, &rest}};
    for (const auto& [exists, state] : states)
      row.push_back(exists ? state->effective_work / study.work_of_adhesion
                           : not_a_number);
    for (const auto& [exists, state] : states)
      row.push_back(exists ? state->area_fraction : not_a_number);
    if (study.sphere_radius)
      row.push_back(theory::rough_pull_off_force(*study.sphere_radius,
                                                 rest.effective_work));
    table.add(row);
  }
  if (failures > 0)
    table.title += fmt::format("; {} of {} partial contacts did not converge",
                               failures, study.points);
  return table;
}

Table adhesion_flip_table(const RoughAdhesion& adhesion,
                          const AdhesionStudy& study, const Table& rows) {
  double ratio = not_a_number;
  double area = not_a_number;
  if (const int row = row_before_flip(rows); row >= 0) {
    ratio = adhesion.flip(ratio_at(study, row), ratio_at(study, row + 1));
    area = adhesion.partial_contact(ratio).area_fraction;
  }
  const double whole = adhesion.complete_contact(1.0).effective_work;
  return {
      "adhesion-flip",
      "Transition from complete to partial contact",
      {{"height_ratio", "1", {ratio}},
       {"area_fraction", "1", {area}},
       {"complete_contact_binding", "1", {whole / study.work_of_adhesion}}}};
}

} // namespace asperity::studies
