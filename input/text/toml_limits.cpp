#include "input/text/toml_limits.hpp"

#include "base/plain_text.hpp"
#include "base/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::cases {
namespace {

/// Scans TOML only as far as needed to distinguish brackets, dots and
/// separators of the syntax from those in strings and comments.
class Scan {
public:
  explicit Scan(const std::string& text) : text_(text) {}

  std::optional<BrokenLimit> run() {
    while (at_ < text_.size() && what_.empty())
      step();
    return what_.empty() ? std::nullopt
                         : std::optional(BrokenLimit{line_, what_});
  }

private:
  void step() {
    const char letter = text_[at_];
    if (letter == '"' || letter == '\'')
      return skip_string(letter);
    if (letter == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
      return;
    }
    ++at_;
    if (letter == '.') {
      if (++key_parts_ > longest_key)
        what_ = fmt::format("is a key of more than {} parts", longest_key);
    } else if (std::string_view("[]{}=,\n").find(letter) !=
               std::string_view::npos) {
      key_parts_ = 1;
      take_sign(letter);
    }
  }

  void take_sign(char sign) {
    if (sign == '\n')
      ++line_;
    else if (sign == '=' || sign == ',')
      ++values_;
    else if (sign == '[' || sign == '{')
      ++depth_;
    else
      depth_ = std::max(0, depth_ - 1);
    if (depth_ > deepest_nesting)
      what_ =
          fmt::format("is nested more than {} levels deep", deepest_nesting);
    if (values_ > most_values)
      what_ = fmt::format("has more than {} values", most_values);
  }

  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool is_multiline = text_.compare(at_, 3, three) == 0;
    at_ += is_multiline ? 3 : 1;
    while (at_ < text_.size()) {
      const bool is_newline = text_[at_] == '\n';
      if (is_newline && !is_multiline)
        return; // not TOML; the TOML library reports the error
      line_ += is_newline ? 1 : 0;
      if (quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size() &&
          text_[at_ + 1] != '\n') {
        at_ += 2;
      } else if (!is_multiline && text_[at_] == quote) {
        ++at_;
        return;
      } else if (is_multiline && text_.compare(at_, 3, three) == 0) {
        at_ += 3;
        for (int more = 0; more < 2 && at_ < text_.size(); ++more)
          at_ += text_[at_] == quote ? 1 : 0; // quotes at the end of the string
                                              // content
        return;
      } else {
        ++at_;
      }
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int depth_ = 0;
  int key_parts_ = 1;
  int values_ = 0;
  std::string what_;
};

} // namespace

std::optional<BrokenLimit> broken_limit(const std::string& text) {
  if (text.size() > largest_case_text)
    return BrokenLimit{
        0, fmt::format("has {} bytes, but must have at most {} ({})",
                       text.size(), largest_case_text,
                       bytes_text(static_cast<double>(largest_case_text)))};
  if (const std::size_t bad = find_not_plain(text); bad != text.npos)
    return BrokenLimit{
        1 + static_cast<int>(std::count(
                text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad),
                '\n')),
        "is not UTF-8 text without control characters"};
  return Scan(text).run();
}

} // namespace asperity::cases
