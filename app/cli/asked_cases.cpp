#include "app/cli/asked_cases.hpp"

#include "cases/reader/read_case.hpp"
#include "cases/text/node.hpp"
#include "cases/text/toml_text.hpp"
#include "reports/pages/paper_report.hpp"

#include <fmt/format.h>

namespace asperity::app {
namespace {

std::string title_override(const std::string& title) {
  cases::Node text;
  text.type = cases::NodeType::text;
  text.text = title;
  return "title=" + cases::toml_value(text);
}

ReadCase read_with_reference(const FoundCase& found,
                             std::vector<std::string> overrides,
                             bool is_quick) {
  const std::string file = found.file.string();
  if (is_quick) {
    const cases::Case whole = cases::read_case(file);
    std::vector<std::string> quick = quick_overrides(found.file);
    if (quick.empty())
      fmt::print("{}: there is no quick.set next to the case file; the full "
                 "case runs\n",
                 whole.name);
    else
      quick.push_back(title_override(whole.title + reports::quick_mark));
    overrides.insert(overrides.begin(), quick.begin(), quick.end());
  }
  ReadCase read{found, cases::read_case(file, overrides), "", overrides};
  read.reference = reference_text_of(read.contact_case);
  if (read.found.name.empty())
    read.found.name = read.contact_case.name;
  return read;
}

} // namespace

Asked read_asked(const std::string& word,
                 const std::vector<std::string>& overrides, bool is_quick) {
  Asked asked{find_cases(word), {}};
  for (const FoundCase& found : asked.found.cases)
    asked.cases.push_back(read_with_reference(found, overrides, is_quick));
  return asked;
}

} // namespace asperity::app
