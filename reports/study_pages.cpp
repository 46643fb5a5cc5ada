#include "reports/study_pages.hpp"

namespace asperity::reports {
namespace {

std::vector<const StudyPages*>& all_pages() {
  static std::vector<const StudyPages*> pages;
  return pages;
}

} // namespace

void add_study_pages(const StudyPages& pages) {
  all_pages().push_back(&pages);
  for (const cases::ExpectationName& quantity : pages.quantities)
    cases::add_expectation(quantity);
  for (const NumberAtLoad& number : pages.at_load)
    cases::add_expectation(number.name);
}

std::span<const StudyPages* const> study_pages() {
  return all_pages();
}

} // namespace asperity::reports
