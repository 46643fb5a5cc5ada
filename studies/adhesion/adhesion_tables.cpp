#include "studies/adhesion/adhesion_tables.hpp"

#include "base/special_numbers.hpp"

#include <fmt/format.h>

namespace asperity::studies {
namespace {

using results::Column;
using results::Table;
using theory::AdhesiveState;
using theory::RoughAdhesion;

/// The columns gamma_eff/Dgamma and A/A_0 of one state.
struct StateColumns {
  explicit StateColumns(const std::string& state)
      : binding{"binding_" + state, "1", {}},
        area{"area_fraction_" + state, "1", {}} {}

  void add(bool exists, const AdhesiveState& state, double work_of_adhesion) {
    binding.values.push_back(exists ? state.effective_work / work_of_adhesion
                                    : not_a_number);
    area.values.push_back(exists ? state.area_fraction : not_a_number);
  }

  Column binding;
  Column area;
};

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
  Column ratio{"height_ratio", "1", {}};
  Column height{"rms_height", "m", {}};
  Column force{"pull_off_force", "N", {}};
  StateColumns partial("partial");
  StateColumns complete("complete");
  StateColumns equilibrium("equilibrium");
  int failures = 0;
  for (int k = 0; k < study.points; ++k) {
    const double at = ratio_at(study, k);
    const AdhesiveState part = adhesion.partial_contact(at);
    const AdhesiveState rest = adhesion.equilibrium(at);
    failures += part.converged ? 0 : 1;
    ratio.values.push_back(at);
    height.values.push_back(at * rms_height);
    partial.add(part.exists && part.converged, part, study.work_of_adhesion);
    complete.add(true, adhesion.complete_contact(at), study.work_of_adhesion);
    equilibrium.add(rest.exists && part.converged, rest,
                    study.work_of_adhesion);
    if (study.sphere_radius)
      force.values.push_back(theory::rough_pull_off_force(*study.sphere_radius,
                                                          rest.effective_work));
  }
  Table table{"adhesion",
              "gamma_eff/Dgamma and A/A_0 against h_rms/h_rms0",
              {ratio, height, partial.binding, complete.binding,
               equilibrium.binding, partial.area, complete.area,
               equilibrium.area}};
  if (study.sphere_radius)
    table.columns.push_back(force);
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
