#include "input/reader/case_text.hpp"

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

std::string_view without_overrides(std::string_view text) {
  while (!text.empty()) {
    const std::size_t last = text.ends_with('\n') && text.size() > 1
                                 ? text.size() - 2
                                 : text.size() - 1;
    const std::size_t end = text.rfind('\n', last);
    const std::size_t begin = end == std::string_view::npos ? 0 : end + 1;
    if (!text.substr(begin).starts_with(marker))
      break;
    text = text.substr(0, begin);
  }
  return text;
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
