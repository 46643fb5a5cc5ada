#include "base/shown_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace asperity {
namespace {

/// A unit with the prefix that suits a number, and its size.
struct ShownUnit {
  double size = 1.0;
  std::string name; ///< with a blank before it
};

/// "m³/s" for "m^3/s".
std::string with_superscripts(std::string unit) {
  for (const auto& [power, sign] :
       {std::pair("^2", "²"), std::pair("^3", "³"), std::pair("^4", "⁴")})
    for (std::size_t at = 0; (at = unit.find(power, at)) != unit.npos;)
      unit.replace(at, 2, sign);
  return unit;
}

ShownUnit suited_unit(double value, const std::string& unit) {
  struct Prefix {
    double size;
    const char* name;
  };

  constexpr std::array prefixes{
      Prefix{1e9, "G"},  Prefix{1e6, "M"},  Prefix{1e3, "k"}, Prefix{1.0, ""},
      Prefix{1e-3, "m"}, Prefix{1e-6, "µ"}, Prefix{1e-9, "n"}};
  const bool is_area = unit == "m^2";
  if (is_area || unit == "m" || unit == "N" || unit == "Pa")
    for (const auto& [prefix, name] : prefixes) {
      const double size = is_area ? prefix * prefix : prefix;
      const bool is_usual = !is_area || prefix <= 1.0;
      // 0.61 µm² is no 610 000 nm².
      const double least = is_area && prefix == 1e-6 ? 0.01 : 0.9995;
      if (is_usual && value != 0.0 &&
          (std::abs(value) >= least * size || prefix == 1e-9))
        return {size, fmt::format(" {}{}", name, is_area ? "m²" : unit)};
    }
  if (unit == "%")
    return {0.01, " %"};
  return {1.0, unit == "1" ? "" : " " + with_superscripts(unit)};
}

/// A number with decimals and, from 10 000 on, a blank between thousands.
std::string with_decimals(double value, int decimals) {
  std::string text = shown_text(Shown{value}, fmt::format(".{}f", decimals));
  const std::size_t end = std::min(text.find('.'), text.size());
  const std::size_t start = text.front() == '-' ? 1 : 0;
  if (end - start > 4)
    for (std::size_t left = end - start; left > 3; left -= 3)
      text.insert(start + left - 3, " ");
  return text;
}

/// The power of ten of the first digit of a number rounded to `digits`.
int first_digit(double value, int digits) {
  const auto rounded = fmt::format("{:.{}e}", std::abs(value), digits - 1);
  return std::stoi(rounded.substr(rounded.find('e') + 1));
}

/// Whether a number with this first digit is written with an exponent.
bool has_exponent(int power) {
  return power < -4 || power >= 6;
}

} // namespace

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

std::string digits_text(double value, int digits) {
  if (!std::isfinite(value))
    return "–";
  if (value == 0.0)
    return "0";
  const int power = first_digit(value, digits);
  if (has_exponent(power))
    return fmt::format("{:.{}g}", value, digits);
  const double step = std::pow(10.0, power - digits + 1);
  const double rounded = std::round(value / step) * step;
  std::string text = with_decimals(rounded, std::max(0, digits - 1 - power));
  if (text.find('.') != std::string::npos)
    text.erase(std::min(text.find_last_not_of('0') + 1, text.size()));
  if (text.ends_with('.'))
    text.pop_back();
  return text;
}

std::string quantity_text(double value, const std::string& unit, int digits) {
  if (!std::isfinite(value))
    return "–";
  const ShownUnit shown = suited_unit(value, unit);
  return digits_text(value / shown.size, digits) + shown.name;
}

std::string uncertain_text(double value, double uncertainty,
                           const std::string& unit) {
  constexpr int most_digits = 4;
  const ShownUnit shown =
      suited_unit(std::fmax(std::abs(value), uncertainty), unit);
  const double number = value / shown.size;
  const double half = uncertainty / shown.size;
  if (!std::isfinite(number) || !std::isfinite(half) || !(half > 0.0))
    return quantity_text(value, unit, most_digits);
  const int last = std::max(number == 0.0 ? -most_digits
                                          : first_digit(number, most_digits) -
                                                most_digits + 1,
                            first_digit(half, 2) - 1);
  const double step = std::pow(10.0, last);
  if (half < 0.5 * step)
    return quantity_text(value, unit, most_digits);
  const int power = first_digit(std::fmax(std::abs(number), half), most_digits);
  const int common = has_exponent(power) ? power : 0;
  const auto text = [&](double one) {
    return with_decimals(std::round(one / step) * step / std::pow(10.0, common),
                         std::max(0, common - last));
  };
  const std::string both = text(number) + " ± " + text(half);
  return (common == 0 ? both : fmt::format("({})e{:+03d}", both, common)) +
         shown.name;
}

std::string interval_text(double value, double low, double high,
                          const std::string& unit) {
  constexpr int most_digits = 3;
  const ShownUnit shown = suited_unit(value, unit);
  const double number = value / shown.size;
  const double half = 0.5 * (high - low) / shown.size;
  if (!(half > 0.0) || !std::isfinite(half + number))
    return quantity_text(value, unit, most_digits);
  const int last = std::max(number == 0.0 ? -most_digits
                                          : first_digit(number, most_digits) -
                                                most_digits + 1,
                            first_digit(half, 1));
  if (half < 0.5 * std::pow(10.0, last))
    return quantity_text(value, unit, most_digits);
  if (last < -6 || last > 6)
    return fmt::format("{:.2g}{} ({:.2g} to {:.2g})", number, shown.name,
                       low / shown.size, high / shown.size);
  const double step = std::pow(10.0, last);
  const auto text = [&](double one) {
    return with_decimals(std::round(one / step) * step, std::max(0, -last));
  };
  return fmt::format("{}{} ({} to {})", text(number), shown.name,
                     text(low / shown.size), text(high / shown.size));
}

} // namespace asperity
