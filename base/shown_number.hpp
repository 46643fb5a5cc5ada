#pragma once

// Formats numbers for readers.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace asperity {

/// A number that fmt formats as any other, except that one that rounds to zero
/// has no minus sign: fmt::format("{:+.2f}", Shown{-0.001}) is "+0.00".
struct Shown {
  double value = 0.0;
};

/// The text of a number in a format of fmt, the part behind the colon.
std::string shown_text(Shown number, std::string_view format);

} // namespace asperity

template <>
struct fmt::formatter<asperity::Shown> {
  constexpr auto parse(format_parse_context& context) {
    auto end = context.begin();
    while (end != context.end() && *end != '}')
      ++end;
    format_ = {context.begin(),
               static_cast<std::size_t>(end - context.begin())};
    return end;
  }

  auto format(asperity::Shown number, format_context& context) const {
    const std::string text = asperity::shown_text(number, format_);
    return std::copy(text.begin(), text.end(), context.out());
  }

private:
  std::string_view format_;
};
