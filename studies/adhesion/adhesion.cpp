#include "studies/adhesion/adhesion.hpp"

#include "input/reader/bound_key.hpp"
#include "studies/adhesion/adhesion_tables.hpp"
#include "studies/key_checks.hpp"

namespace asperity::studies {
namespace {

using cases::between;
using cases::Case;
using cases::Dimension;
using cases::eg;
using cases::key;
using cases::needed;
using cases::positive;
using cases::TableReader;
using Adhesion = AdhesionStudy;

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

constexpr const char* for_theory =
    "Optional; needs a [theory] whose spectrum is the formula.";

cases::Table keys_of_adhesion() {
  return {
      .name = "adhesion",
      .when = for_theory,
      .description =
          "Rough contact held by adhesion alone, Sec. 9 of Yang and Persson "
          "(2008), on the case's surface with all heights scaled.",
      .keys = {
          key<&Adhesion::work_of_adhesion>(
              "work_of_adhesion", Dimension::energy_per_area,
              "Work of adhesion Delta gamma of flat surfaces.",
              needed("0.1 J/m^2")),
          key<&Adhesion::from>("from", positive(),
                               "Lowest ratio of h_rms to that of the case.",
                               needed("0.5")),
          key<&Adhesion::to>("to", positive(), "Highest ratio.", needed("1.5")),
          key<&Adhesion::points>("points", between(2, 10000),
                                 "Number of ratios, at equal differences.",
                                 needed("120")),
          key<&Adhesion::detachment_factor>(
              "detachment_factor", positive(),
              "Factor c of the stress that detaches a contact, sigma_a^2 = c "
              "E* gamma_eff q; not in the paper.",
              eg("0.64", "default: 2/pi, which reproduces the transition of "
                         "the paper")),
          key<&Adhesion::sphere_radius>(
              "sphere_radius", Dimension::length,
              "Radius of a sphere on the surface, for its pull-off force (3 "
              "pi/2) R gamma_eff.",
              eg("1 mm", "default: no pull-off force")),
          key<&Adhesion::steps>(
              "steps", between(10, 100000),
              "Steps of the discretisation between the longest and the "
              "shortest wavelength; second order."),
      }};
}

void read_adhesion(TableReader table, Case& read) {
  check_theory(table, read, false);
  AdhesionStudy study;
  table.read(study);
  check_ends(table, study.from, study.to);
  read.studies.ask(study);
}

const cases::StudyKeys& adhesion_keys() {
  static const cases::StudyKeys keys{
      .tables = {keys_of_adhesion()},
      .read = read_adhesion,
      .is_asked = asks<AdhesionStudy>,
      .questions = {{"[adhesion]", {}, asks<AdhesionStudy>, nullptr}}};
  return keys;
}

} // namespace

const Study adhesion_study{.keys = adhesion_keys,
                           .pages = adhesion_pages,
                           .theory_tables = tables_of_adhesion};

} // namespace asperity::studies
