#include "reports/surface/surface_quantities.hpp"

#include "base/special_numbers.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace asperity::reports {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double noticed_ratio = 1.5;

struct LengthUnit {
  double metres;
  const char* symbol;
};

std::string length_text(double metres) {
  static constexpr std::array<LengthUnit, 5> units{
      {{1.0, "m"}, {1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}, {1e-12, "pm"}}};
  for (const LengthUnit& unit : units)
    if (std::abs(metres) >= 0.9995 * unit.metres)
      return fmt::format("{:.4g} {}", metres / unit.metres, unit.symbol);
  return metres == 0.0 ? "0 m" : fmt::format("{:.4g} m", metres);
}

} // namespace

std::vector<SurfaceQuantity> quantities_of(const surfaces::MapAnalysis& map) {
  const surfaces::HeightParameters& heights = map.heights;
  const surfaces::SpectrumEstimate& spectrum = map.spectrum;
  const surfaces::BearingCurve& bearing = map.bearing;
  const double none = not_a_number;
  return {
      {"sq", "Sq", "root mean square height", "m", heights.sq,
       spectrum.rms_height},
      {"sa", "Sa", "arithmetic mean height", "m", heights.sa, none},
      {"ssk", "Ssk", "skewness", "1", heights.ssk, none},
      {"sku", "Sku", "kurtosis, 3 for a Gaussian", "1", heights.sku, none},
      {"sp", "Sp", "highest peak above the mean", "m", heights.sp, none},
      {"sv", "Sv", "deepest valley below the mean", "m", heights.sv, none},
      {"sz", "Sz", "Sp + Sv", "m", heights.sz, none},
      {"sdq", "Sdq", "rms slope, both directions", "1", heights.sdq,
       spectrum.rms_slope},
      {"sdr", "Sdr", "developed area over projected area, minus 1", "1",
       heights.sdr, none},
      {"rms_curvature", "h''", "rms curvature (half the Laplacian)", "1/m",
       map.neighbours.rms_curvature(), spectrum.rms_curvature},
      {"nayak", "α", "Nayak's parameter m₀m₄/m₂²", "1", map.nayak,
       nayak_parameter(spectrum)},
      {"sal", "Sal", "shortest decay of the autocorrelation to 0.2", "m",
       map.correlation.shortest, none},
      {"str", "Str", "texture aspect ratio: shortest over longest decay", "1",
       map.correlation.aspect_ratio, none},
      {"sk", "Sk", "core height of the bearing curve", "m", bearing.core_height,
       none},
      {"spk", "Spk", "reduced peak height", "m", bearing.peak_height, none},
      {"svk", "Svk", "reduced valley depth", "m", bearing.valley_depth, none},
      {"smr1", "Smr1", "material ratio at the top of the core", "1",
       bearing.peak_ratio, none},
      {"smr2", "Smr2", "material ratio at the bottom of the core", "1",
       bearing.valley_ratio, none},
  };
}

std::vector<SurfaceQuantity> quantities_of(const surfaces::LineAnalysis& line) {
  const surfaces::ProfileParameters& profile = line.profile;
  const double none = not_a_number;
  return {
      {"pq", "Pq", "root mean square height", "m", profile.pq, none},
      {"pa", "Pa", "arithmetic mean height", "m", profile.pa, none},
      {"psk", "Psk", "skewness", "1", profile.psk, none},
      {"pku", "Pku", "kurtosis, 3 for a Gaussian", "1", profile.pku, none},
      {"pt", "Pt", "highest peak to deepest valley", "m", profile.pt, none},
      {"pdq", "Pdq", "rms slope along the line", "1", profile.pdq, none},
      {"rms_second", "z''", "rms second derivative along the line", "1/m",
       profile.rms_second, none},
  };
}

std::vector<FittedQuantity> quantities_of(const surfaces::SelfAffineFit& fit) {
  return {
      {"hurst", "H", "Hurst exponent", "1", fit.hurst},
      {"wavevector_roll_off", "q₀", "roll-off wavevector", "1/m", fit.roll_off},
      {"wavevector_high", "q₁", "cut-off wavevector", "1/m", fit.cutoff},
      {"blur", "s", "standard deviation of the Gaussian that blurs the map",
       "m", fit.blur},
      {"rms_height", "h_rms", "rms height of the model between the limits", "m",
       fit.rms_height},
  };
}

std::string quantity_text(double value, const std::string& unit) {
  if (!std::isfinite(value))
    return "–";
  if (unit == "m")
    return length_text(value);
  return fmt::format("{:.4g}{}", value, unit == "1" ? "" : " " + unit);
}

std::string fitted_text(const FittedQuantity& quantity) {
  const surfaces::FittedParameter& fitted = quantity.parameter;
  if (!std::isfinite(fitted.value)) {
    const bool has_low = std::isfinite(fitted.low);
    if (!has_low && !std::isfinite(fitted.high))
      return fmt::format("not determined ({})", fitted.reason);
    const double limit = has_low ? fitted.low : fitted.high;
    return fmt::format("{} {} ({})", has_low ? "above" : "below",
                       quantity_text(limit, quantity.unit), fitted.reason);
  }
  const std::string note =
      fitted.reason.empty() ? "" : fmt::format(" ({})", fitted.reason);
  if (!std::isfinite(fitted.low))
    return quantity_text(fitted.value, quantity.unit) + note;
  const std::string high = std::isfinite(fitted.high)
                               ? quantity_text(fitted.high, quantity.unit)
                               : "no limit";
  return fmt::format("{} [{}, {}]{}",
                     quantity_text(fitted.value, quantity.unit),
                     quantity_text(fitted.low, quantity.unit), high,
                     std::isfinite(fitted.high) ? note : "");
}

std::string wavelengths_text(double low, double high) {
  return fmt::format("{} to {}", quantity_text(two_pi / low, "m"),
                     quantity_text(two_pi / high, "m"));
}

std::string range_text(const surfaces::MapAnalysis& map) {
  const surfaces::ReliableRange& range = map.range;
  if (rings_between(part_of(map).rings, range.low, range.high).empty())
    return fmt::format("no wavelength is reliable: the limits by {} and by {} "
                       "leave none",
                       range.low_reason, range.high_reason);
  return fmt::format("wavelengths {} (limits: {}; {})",
                     wavelengths_text(range.low, range.high), range.low_reason,
                     range.high_reason);
}

std::string range_text(const surfaces::LineAnalysis& line) {
  return fmt::format("wavelengths {} (limits: length of the line; conversion "
                     "near the end of the spectrum)",
                     wavelengths_text(line.low, line.high));
}

std::vector<std::string> stitching_notes(const SurfaceReport& report) {
  std::vector<std::string> notes;
  for (const auto& [low, high] : report.stitched.gaps)
    notes.push_back(fmt::format(
        "no map covers the wavelengths {}; the spectrum is interpolated there",
        wavelengths_text(low, high)));
  for (std::size_t part = 0; part < report.stitched.ratios.size(); ++part) {
    const double ratio = report.stitched.ratios[part];
    if (ratio > noticed_ratio || ratio < 1.0 / noticed_ratio)
      notes.push_back(fmt::format("the spectrum of {} is {:.3g} times the mean "
                                  "of all where they overlap",
                                  report.name_of(part), ratio));
  }
  return notes;
}

} // namespace asperity::reports
