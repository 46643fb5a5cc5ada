#include "cases/reader/case_text.hpp"

#include <sstream>

namespace asperity::cases {
namespace {

const std::string marker = "#--set ";

} // namespace

std::string text_with_overrides(const std::string& text,
                                const std::vector<std::string>& overrides) {
  std::string whole = text;
  if (!overrides.empty() && !whole.empty() && whole.back() != '\n')
    whole += '\n';
  for (const std::string& entry : overrides)
    whole += marker + entry + "\n";
  return whole;
}

std::vector<std::string> overrides_in(const std::string& text) {
  std::vector<std::string> overrides;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    if (line.rfind(marker, 0) == 0)
      overrides.push_back(line.substr(marker.size()));
    else
      overrides.clear();
  }
  return overrides;
}

} // namespace asperity::cases
