#include "reports/surface/surface_quantities.hpp"

#include "base/special_numbers.hpp"
#include "reports/numbers/number_text.hpp"
#include "surfaces/analysis/contact_fitness.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace asperity::reports {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

} // namespace

std::vector<SurfaceQuantity> quantities_of(const surfaces::MapAnalysis& map) {
  const surfaces::HeightParameters& heights = map.heights;
  const surfaces::SpectrumEstimate& spectrum = map.spectrum;
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

std::string interval_text(const FittedQuantity& quantity) {
  const surfaces::FittedParameter& fitted = quantity.parameter;
  if (!std::isfinite(fitted.value))
    return fitted_text(quantity);
  if (!std::isfinite(fitted.low))
    return fitted.reason;
  return fmt::format(
      "{} to {}{}", quantity_text(fitted.low, quantity.unit),
      quantity_text(fitted.high, quantity.unit),
      fitted.reason.empty() ? "" : fmt::format(" ({})", fitted.reason));
}

std::string wavelengths_text(double low, double high) {
  return fmt::format("{} to {}", quantity_text(two_pi / low, "m"),
                     quantity_text(two_pi / high, "m"));
}

std::string range_text(const surfaces::MapAnalysis& map) {
  const surfaces::ReliableRange& range = map.range;
  if (reliable_rows(map).empty())
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

std::string fitness_text(const surfaces::MapAnalysis& map) {
  const Grid& grid = map.map.grid;
  return surfaces::fitness_sentence(surfaces::contact_fitness(
      map.spectrum.rings,
      map.range.noise ? std::optional(map.range.noise->wavevector)
                      : std::nullopt,
      std::max(grid.spacing_x(), grid.spacing_y()),
      std::min(grid.length_x, grid.length_y)));
}

} // namespace asperity::reports
