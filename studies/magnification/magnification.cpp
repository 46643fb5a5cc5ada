#include "studies/magnification/magnification.hpp"

#include "studies/magnification/magnification_study.hpp"
#include "studies/magnification/magnification_tables.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace asperity::studies {
namespace {

using Contacts = std::vector<theory::MagnifiedContact>;

/// The contacts at the loads of the study, which are found once, when the first
/// table asks for them.
std::function<const Contacts&()>
contacts_of(const MagnificationStudy& study,
            const theory::PerssonContact& contact) {
  return [&study, contact,
          found = std::make_shared<Contacts>()]() -> const Contacts& {
    if (found->empty())
      *found = magnified_contacts(contact, study);
    return *found;
  };
}

std::vector<AskedTable>
tables_of_magnification(const cases::Case& contact_case,
                        const theory::PerssonContact& contact) {
  const auto& study = *contact_case.study<MagnificationStudy>();
  const auto contacts = contacts_of(study, contact);
  std::vector<AskedTable> tables{
      {"magnification", [=] { return loads_table(contacts()); }}};
  for (std::size_t i = 0; i < study.nominal_pressures.size(); ++i) {
    const std::string seen = fmt::format("magnification-{}", i + 1);
    const std::string gaps = fmt::format("gap-distribution-{}", i + 1);
    tables.push_back({seen, [=, &study] {
                        return magnification_table(seen, contacts()[i], study);
                      }});
    tables.push_back(
        {gaps, [=] { return gap_distribution_table(gaps, contacts()[i]); }});
  }
  if (study.leak)
    tables.push_back(
        {"leak", [=, &study] { return leak_table(contacts(), *study.leak); }});
  return tables;
}

} // namespace

const Study magnification_study{.keys = magnification_keys,
                                .pages = magnification_pages,
                                .theory_tables = tables_of_magnification};

} // namespace asperity::studies
