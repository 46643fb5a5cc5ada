#pragma once

// Formats numbers for readers.

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace asperity {

/// A number that fmt formats as any other, except that one that rounds to zero
/// has no minus sign: fmt::format("{:+.2f}", Shown{-0.001}) is "+0.00".
struct Shown {
  double value = 0.0;
};

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

  template <class Context>
  auto format(const asperity::Shown& number, Context& context) const {
    const std::string pattern = "{:" + std::string(format_) + "}";
    std::string text = fmt::format(fmt::runtime(pattern), number.value);
    const std::string_view mantissa =
        std::string_view(text).substr(0, text.find_first_of("eE"));
    if (mantissa.find('-') != std::string_view::npos &&
        mantissa.find_first_of("123456789in") == std::string_view::npos)
      text = fmt::format(fmt::runtime(pattern), 0.0);
    return fmt::format_to(context.out(), "{}", text);
  }

private:
  std::string_view format_;
};
