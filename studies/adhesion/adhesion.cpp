#include "studies/adhesion/adhesion.hpp"

#include "studies/adhesion/adhesion_study.hpp"
#include "studies/adhesion/adhesion_tables.hpp"

namespace asperity::studies {
namespace {

std::vector<AskedTable>
tables_of_adhesion(const cases::Case& contact_case,
                   const theory::PerssonContact& contact) {
  const auto& study = *contact_case.study<AdhesionStudy>();
  theory::AdhesivePair pair{.contact_modulus = contact.contact_modulus(),
                            .work_of_adhesion = study.work_of_adhesion,
                            .gamma = contact.gamma()};
  if (study.detachment_factor)
    pair.detachment_factor = *study.detachment_factor;
  const auto adhesion = std::make_shared<const theory::RoughAdhesion>(
      contact.spectrum(), pair, study.steps);
  const auto rows = [&study, adhesion, height = contact.spectrum().rms_height(),
                     found = std::make_shared<results::Table>()] {
    if (found->columns.empty())
      *found = adhesion_table(*adhesion, study, height);
    return *found;
  };
  return {{"adhesion", rows}, {"adhesion-flip", [=, &study] {
                                 return adhesion_flip_table(*adhesion, study,
                                                            rows());
                               }}};
}

} // namespace

const Study adhesion_study{.keys = adhesion_keys,
                           .pages = adhesion_pages,
                           .theory_tables = tables_of_adhesion};

} // namespace asperity::studies
