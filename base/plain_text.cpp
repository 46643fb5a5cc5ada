#include "base/plain_text.hpp"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

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

std::string plain_text(std::string_view text) {
  std::string plain(text);
  std::size_t from = 0;
  for (std::size_t bad = 0;
       (bad = find_not_plain(std::string_view(plain).substr(from))) !=
       plain.npos;
       from += bad + 1)
    plain[from + bad] = '?';
  return plain;
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown(text.substr(0, longest));
  const std::size_t cut = // a letter of UTF-8 may be cut behind this byte
      text.size() > longest
          ? shown.size() - std::min<std::size_t>(shown.size(), 3)
          : shown.size();
  std::size_t n_added = 0;
  for (std::size_t bad = 0; (bad = find_not_plain(shown)) != shown.npos;) {
    const auto code = static_cast<unsigned char>(shown[bad]);
    const bool is_letter = code >= 0xA0 && bad < cut + n_added;
    const char latin_1[] = {static_cast<char>(0xC0 | code >> 6),
                            static_cast<char>(0x80 | (code & 0x3F))};
    shown.replace(bad, 1, is_letter ? std::string_view(latin_1, 2) : "?");
    n_added += is_letter ? 1 : 0;
  }
  for (char& letter : shown)
    if (letter == '\n' || letter == '\r')
      letter = '?';
  return text.size() > longest ? shown + "..." : shown;
}

namespace {

constexpr std::string_view good_letters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 ._+-";

} // namespace

bool is_good_name(std::string_view name) {
  return !name.empty() && name.size() <= longest_name &&
         name.find_first_not_of(good_letters) == name.npos;
}

std::string good_name(std::string_view text) {
  std::string name(text.empty() ? "-" : text.substr(0, longest_name));
  for (char& letter : name)
    if (good_letters.find(letter) == good_letters.npos)
      letter = '-';
  return name;
}

std::string line_mistake(std::string_view text, std::size_t longest) {
  if (!text.empty() && text.size() <= longest &&
      find_not_plain(text) == text.npos &&
      text.find_first_of("\r\n") == text.npos)
    return "";
  return "must be one line of 1 to " + std::to_string(longest) +
         " bytes of UTF-8 text without control characters";
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos)
    return "";
  return std::string(
      text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

std::pair<double, std::string_view> number_and_rest(std::string_view text) {
  double number = 0.0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{})
    return {std::nan(""), text};
  return {number, text.substr(static_cast<std::size_t>(end - text.data()))};
}

} // namespace asperity
