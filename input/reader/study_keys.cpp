#include "input/reader/study_keys.hpp"

#include <algorithm>

namespace asperity::cases {
namespace {

std::vector<const StudyKeys*>& all_studies() {
  static std::vector<const StudyKeys*> studies;
  return studies;
}

} // namespace

void add_studies(std::span<const StudyKeys* const> studies) {
  all_studies().insert(all_studies().end(), studies.begin(), studies.end());
  for (const StudyKeys* const study : studies)
    for (const AskedTraits& question : study->questions)
      add_question(question);
}

std::span<const StudyKeys* const> known_studies() {
  return all_studies();
}

bool is_asked(const Case& contact_case, const std::string& study) {
  return std::ranges::any_of(all_studies(), [&](const StudyKeys* one) {
    return one->name() == study && one->is_asked(contact_case);
  });
}

} // namespace asperity::cases
