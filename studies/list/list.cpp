// The studies. Their keys and pages are known from the start of the program on.
#include "studies/adhesion/adhesion.hpp"
#include "studies/conductance/conductance.hpp"
#include "studies/flow/flow.hpp"
#include "studies/friction/friction.hpp"
#include "studies/magnification/magnification.hpp"
#include "studies/resistance/resistance.hpp"
#include "studies/spots/spots.hpp"
#include "studies/study.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace asperity::studies {
namespace {

const std::array<const Study*, 7> listed{
    &magnification_study, &adhesion_study,   &flow_study,    &spots_study,
    &conductance_study,   &resistance_study, &friction_study};

/// Tells the reader of cases and the reports of all studies.
bool tell_all() {
  for (const Study* const study : listed) {
    const cases::StudyKeys* const keys = &study->keys();
    cases::add_studies({&keys, 1});
    reports::add_study_pages(study->pages());
  }
  return true;
}

[[maybe_unused]] const bool is_told = tell_all();

template <class Work>
void each_asked(const cases::Case& contact_case, const Work& work) {
  for (const Study* const study : listed)
    if (study->keys().is_asked(contact_case))
      work(*study);
}

} // namespace

std::span<const Study* const> all_studies() {
  return listed;
}

Step step_with_maps(const cases::Case& contact_case,
                    const cases::MethodSpec& method,
                    const methods::SurfaceOfCase& surface, const Grid& grid,
                    std::span<const double> pressure,
                    std::span<const double> gap) {
  return {contact_case,
          method,
          surface,
          grid,
          pressure,
          gap,
          {method.contact_criterion(surface.scales.rms_height), pressure, gap}};
}

std::optional<results::Table>
table_of_heaviest_map(const Study& study, const cases::Case& contact_case,
                      const cases::MethodSpec& method,
                      const methods::SurfaceOfCase& surface,
                      const results::Curve& curve) {
  std::vector<const results::Fields*> heaviest;
  for (const results::Fields& maps : curve.fields)
    if (!maps.gap_map().empty() && maps.gap_map().size() == maps.grid.size())
      heaviest.push_back(&maps);
  std::ranges::sort(heaviest, std::ranges::greater{},
                    &results::Fields::nominal_pressure);
  for (const results::Fields* const maps : heaviest) {
    const std::vector<double> pressure = maps->pressure_map().whole();
    const std::vector<double> gap = maps->gap_map().whole();
    if (auto table =
            study.map_table(step_with_maps(contact_case, method, surface,
                                           maps->grid, pressure, gap),
                            maps->map))
      return table;
  }
  return std::nullopt;
}

bool needs_all_maps(const cases::Case& contact_case) {
  return std::ranges::any_of(listed, [&](const Study* study) {
    return study->evaluate != nullptr && study->keys().is_asked(contact_case);
  });
}

void evaluate_studies(const Step& step, results::CurvePoint& row) {
  each_asked(step.contact_case, [&](const Study& study) {
    if (study.evaluate != nullptr)
      study.evaluate(step, row);
  });
  rescale_studies(step.contact_case, row);
}

void evaluate_studies(const cases::Case& contact_case,
                      const theory::PerssonContact& contact,
                      results::CurvePoint& row) {
  each_asked(contact_case, [&](const Study& study) {
    if (study.evaluate_theory != nullptr)
      study.evaluate_theory(contact_case, contact, row);
  });
  rescale_studies(contact_case, row);
}

void rescale_studies(const cases::Case& contact_case,
                     results::CurvePoint& row) {
  each_asked(contact_case, [&](const Study& study) {
    if (study.rescale != nullptr)
      study.rescale(contact_case, row);
  });
}

} // namespace asperity::studies
