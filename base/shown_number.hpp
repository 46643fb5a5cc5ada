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

/// Rounds to significant digits as a person writes them: "3.33", "0.00231",
/// "12 100"; with an exponent below 1e-4 and from 1e6 on, "2.46e-18". "–" if it
/// is not finite.
std::string digits_text(double value, int digits);

/// Returns a number with its unit, "5.98 nm", "12 100 µm²", "1.25e+06 1/m",
/// "2.46e-18 m³/s" or "3.1" for the unit "1"; m, m^2, N and Pa have a prefix
/// that suits the number, and "%" is that of a share of 1. "–" if it is not
/// finite.
std::string quantity_text(double value, const std::string& unit,
                          int digits = 4);

/// Returns "5.6 ± 1.2 nm", or "12.5 ± 2.8 %" for the unit "%" and shares of 1:
/// both with the digits that two digits of the uncertainty justify, at most
/// four of the number, and with one prefix or exponent, "(0.8 ± 1.3)e-25 m³";
/// as quantity_text() without an uncertainty, or one beyond these digits.
std::string uncertain_text(double value, double uncertainty,
                           const std::string& unit);

/// Returns "33 nm (32 to 34)", with the digits that the width of the interval
/// justifies, at most three of the value; "33.2 nm" if the interval is narrower
/// than these digits or there is none.
std::string interval_text(double value, double low, double high,
                          const std::string& unit);

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
