#include "base/plain_text.hpp"

#include <boost/locale/utf.hpp>

namespace asperity {

std::size_t find_not_plain(std::string_view text) {
  namespace utf = boost::locale::utf;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    const char* const start = at;
    const utf::code_point point = utf::utf_traits<char>::decode(at, end);
    const bool is_control =
        (point < 0x20 && point != '\t' && point != '\n' && point != '\r') ||
        (point >= 0x7f && point < 0xa0);
    if (point == utf::illegal || point == utf::incomplete || is_control)
      return static_cast<std::size_t>(start - text.data());
  }
  return std::string_view::npos;
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown(text.substr(0, longest));
  for (std::size_t bad = 0; (bad = find_not_plain(shown)) != shown.npos;)
    shown[bad] = '?';
  for (char& letter : shown)
    if (letter == '\n' || letter == '\r')
      letter = '?';
  return text.size() > longest ? shown + "..." : shown;
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos)
    return "";
  return std::string(
      text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

} // namespace asperity
