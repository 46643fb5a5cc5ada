#include "base/shown_number.hpp"

namespace asperity {

std::string shown_text(Shown number, std::string_view format) {
  const std::string pattern = "{:" + std::string(format) + "}";
  std::string text = fmt::format(fmt::runtime(pattern), number.value);
  const std::string_view mantissa =
      std::string_view(text).substr(0, text.find_first_of("eE"));
  if (mantissa.find('-') != std::string_view::npos &&
      mantissa.find_first_of("123456789in") == std::string_view::npos)
    text = fmt::format(fmt::runtime(pattern), 0.0);
  return text;
}

} // namespace asperity
