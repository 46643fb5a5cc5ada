#include "app/studies.hpp"

#include "app/interrupt.hpp"
#include "app/study_tables.hpp"
#include "app/surfaces_of_case.hpp"

#include <fmt/format.h>

#include <functional>

namespace asperity::app {
namespace {

using results::Table;

/// Makes a table unless it is there or the run is being ended.
void record(results::ResultWriter& writer, const std::string& name,
            const std::function<Table()>& make) {
  if (!writer.has_table(name) && !is_interrupted())
    writer.record_table(make());
}

void run_magnification(const cases::MagnificationStudy& study,
                       const theory::PerssonContact& contact,
                       results::ResultWriter& writer) {
  const std::vector<theory::MagnifiedContact> contacts =
      magnified_contacts(contact, study);
  record(writer, "magnification", [&] { return loads_table(contacts); });
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::string seen = fmt::format("magnification-{}", i + 1);
    const std::string gaps = fmt::format("gap-distribution-{}", i + 1);
    record(writer, seen,
           [&] { return magnification_table(seen, contacts[i], study); });
    record(writer, gaps,
           [&] { return gap_distribution_table(gaps, contacts[i]); });
  }
  if (study.leak)
    record(writer, "leak", [&] { return leak_table(contacts, *study.leak); });
}

void run_adhesion(const cases::AdhesionStudy& study,
                  const theory::PerssonContact& contact,
                  results::ResultWriter& writer) {
  theory::AdhesivePair pair{.contact_modulus = contact.contact_modulus(),
                            .work_of_adhesion = study.work_of_adhesion,
                            .gamma = contact.gamma()};
  if (study.detachment_factor)
    pair.detachment_factor = *study.detachment_factor;
  if (writer.has_table("adhesion-flip")) // the last to be written
    return;
  const theory::RoughAdhesion adhesion(contact.spectrum(), pair, study.steps);
  const Table rows =
      adhesion_table(adhesion, study, contact.spectrum().rms_height());
  record(writer, rows.name, [&] { return rows; });
  record(writer, "adhesion-flip",
         [&] { return adhesion_flip_table(adhesion, study, rows); });
}

} // namespace

void run_studies(const cases::Case& rough_case, const cases::MethodSpec& theory,
                 results::ResultWriter& writer) {
  if (!rough_case.magnification_study && !rough_case.adhesion_study)
    return;
  const theory::PerssonContact contact(
      formula_of_case(rough_case, theory), rough_case.material.contact_modulus,
      std::get<cases::TheorySettings>(theory.settings).gamma);
  if (rough_case.magnification_study)
    run_magnification(*rough_case.magnification_study, contact, writer);
  if (rough_case.adhesion_study)
    run_adhesion(*rough_case.adhesion_study, contact, writer);
}

} // namespace asperity::app
