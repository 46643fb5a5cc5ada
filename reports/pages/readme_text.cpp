#include "reports/pages/readme_text.hpp"

#include <sstream>

namespace asperity::reports {
namespace {

// Returns the paragraphs with their markup, each on one line.
std::vector<std::string> paragraphs_of(const std::string& readme) {
  std::vector<std::string> paragraphs(1);
  std::istringstream lines(readme);
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \r") == std::string::npos) {
      if (!paragraphs.back().empty())
        paragraphs.emplace_back();
      continue;
    }
    std::string& last = paragraphs.back();
    last += (last.empty() ? "" : " ") + line;
  }
  if (paragraphs.back().empty())
    paragraphs.pop_back();
  return paragraphs;
}

std::string plain(const std::string& marked) {
  std::string text;
  for (std::size_t i = marked.find_first_not_of("# "); i < marked.size(); ++i) {
    if (marked[i] == '`')
      continue;
    if (marked.compare(i, 2, "**") == 0)
      ++i;
    else
      text += marked[i];
  }
  return text;
}

std::string marked_paragraph_on(const std::string& readme,
                                const std::string& word) {
  const std::string start = "**" + word + ".**";
  for (const std::string& paragraph : paragraphs_of(readme))
    if (paragraph.rfind(start, 0) == 0)
      return paragraph.substr(start.size());
  return "";
}

} // namespace

std::vector<std::string> plain_paragraphs(const std::string& readme) {
  std::vector<std::string> texts;
  for (const std::string& paragraph : paragraphs_of(readme))
    texts.push_back(plain(paragraph));
  return texts;
}

std::string paragraph_on(const std::string& readme, const std::string& word) {
  return plain(marked_paragraph_on(readme, word));
}

} // namespace asperity::reports
