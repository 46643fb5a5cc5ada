#include "reports/explore/script_words.hpp"

#include "reports/explore/chart_of_script.hpp"

#include <sstream>
#include <string_view>
#include <utility>

namespace asperity::reports {
namespace {

/// Follows quotes and parentheses through a text.
class Nesting {
public:
  /// Returns true if the character belongs to a quoted or bracketed part.
  bool is_inside(char c) {
    const bool was_quoted = is_quoted_;
    if (c == '\'')
      is_quoted_ = !is_quoted_;
    else if (!is_quoted_ && (c == '(' || c == '['))
      ++depth_;
    else if (!is_quoted_ && depth_ > 0 && (c == ')' || c == ']'))
      --depth_;
    return was_quoted || is_quoted_ || depth_ > 0;
  }

private:
  bool is_quoted_ = false;
  int depth_ = 0;
};

std::vector<std::string> split(const std::string& text,
                               std::string_view separators) {
  std::vector<std::string> parts(1);
  Nesting nesting;
  for (const char c : text) {
    if (!nesting.is_inside(c) && separators.find(c) != std::string::npos)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t start = text.find_first_not_of(' ');
  return start == std::string::npos
             ? ""
             : text.substr(start, text.find_last_not_of(' ') + 1 - start);
}

} // namespace

std::vector<std::string> commands_of(const std::string& script) {
  std::vector<std::string> commands;
  std::istringstream lines(script);
  std::string command;
  for (std::string line; std::getline(lines, line);) {
    const bool continues = line.ends_with('\\');
    command += continues ? line.substr(0, line.size() - 1) : line;
    if (continues)
      continue;
    if (!command.empty() && command.front() != '#')
      commands.push_back(command);
    command.clear();
  }
  return commands;
}

std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words = split(command, " ,");
  std::erase(words, "");
  return words;
}

std::vector<std::string> split_outside(const std::string& text,
                                       char separator) {
  std::vector<std::string> parts = split(text, std::string_view(&separator, 1));
  for (std::string& part : parts)
    part = trimmed(part);
  return parts;
}

std::string unquoted(const std::string& word) {
  return word.size() >= 2 && word.front() == '\'' && word.back() == '\''
             ? word.substr(1, word.size() - 2)
             : word;
}

namespace {

/// Returns a digit below or above the line, or "_rms" for other letters.
std::string shifted(const std::string& text, bool is_below) {
  static const std::vector<std::string> below{"₀", "₁", "₂", "₃", "₄",
                                              "₅", "₆", "₇", "₈", "₉"};
  static const std::vector<std::string> above{"⁰", "¹", "²", "³", "⁴",
                                              "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (text.find_first_not_of("0123456789") != std::string::npos || text.empty())
    return (is_below ? "_" : "^") + text;
  std::string digits;
  for (const char digit : text)
    digits += (is_below ? below : above)[static_cast<std::size_t>(digit - '0')];
  return digits;
}

} // namespace

std::string plain_label(const std::string& markup) {
  std::string text;
  for (std::size_t i = 0; i < markup.size(); ++i) {
    const char c = markup[i];
    const bool has_next = i + 1 < markup.size();
    if (c == '\\' && has_next) {
      text += markup[++i];
    } else if ((c == '_' || c == '^') && has_next) {
      const std::size_t end =
          markup[i + 1] == '{' ? markup.find('}', i + 1) : i + 1;
      if (end == std::string::npos)
        return markup;
      text += shifted(markup[i + 1] == '{' ? markup.substr(i + 2, end - i - 2)
                                           : markup.substr(i + 1, 1),
                      c == '_');
      i = end;
    } else if (c == ' ' && !text.empty() && text.back() == ' ') {
      continue; // two blanks widen the gap on paper
    } else if (c != '{' && c != '}') {
      text += c;
    }
  }
  return text;
}

} // namespace asperity::reports
