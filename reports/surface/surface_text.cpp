#include "reports/numbers/number_text.hpp"
#include "reports/surface/surface_page.hpp"
#include "reports/surface/surface_quantities.hpp"
#include "reports/sweeps/sweep_scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::reports {
namespace {

/// Pads by characters, of which UTF-8 may need several bytes.
std::string padded(const std::string& text, std::size_t width) {
  const auto continued = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
      }));
  const std::size_t length = text.size() - continued;
  return text + std::string(length < width ? width - length : 0, ' ');
}

std::string table_text(const std::vector<SurfaceQuantity>& quantities,
                       bool has_spectrum) {
  std::string text = has_spectrum ? "        by nodes      by spectrum\n" : "";
  for (const SurfaceQuantity& quantity : quantities)
    text += fmt::format(
        "  {}{}{}{}\n", padded(quantity.symbol, 6),
        padded(quantity_text(quantity.by_nodes, quantity.unit), 14),
        has_spectrum
            ? padded(std::isfinite(quantity.by_spectrum)
                         ? quantity_text(quantity.by_spectrum, quantity.unit)
                         : "",
                     14)
            : "",
        quantity.meaning);
  return text;
}

std::string scatter_text(const surfaces::SelfAffineFit& fit) {
  if (!(fit.dispersion > 2.0) && fit.is_model)
    return "";
  return fmt::format("    The rings scatter {:.2g} times as much about the "
                     "model as they would for a Gaussian self-affine surface; "
                     "{}.\n",
                     std::sqrt(fit.dispersion),
                     fit.is_model ? "the intervals are widened accordingly"
                                  : "it is not this model, and no intervals "
                                    "are stated");
}

std::string map_text(const surfaces::MapAnalysis& map) {
  const Grid& grid = map.map.grid;
  std::string text = fmt::format("{}: {} x {} points over {} x {}\n  {}\n",
                                 map.name, grid.points_x, grid.points_y,
                                 quantity_text(grid.length_x, "m"),
                                 quantity_text(grid.length_y, "m"), map.origin);
  for (const std::string& warning : map.warnings)
    text += fmt::format("  warning: {}\n", warning);
  text += table_text(quantities_of(map), true);
  text += fmt::format("  reliable: {}\n", range_text(map));
  text += fmt::format("  {}\n", fitness_text(map));
  if (!map.fit)
    return text + "  self-affine model: not fitted, too few rings in the "
                  "reliable range\n";
  text += "  self-affine model, 95 % intervals:\n";
  for (const FittedQuantity& quantity : quantities_of(*map.fit))
    text += fmt::format("    {}{}\n", padded(quantity.symbol, 7),
                        fitted_text(quantity));
  return text + scatter_text(*map.fit);
}

/// The heights of several maps by nodes, a row each, with mean, standard
/// deviation of one map and outliers; "" for fewer than two.
std::string maps_text(const std::vector<surfaces::MapAnalysis>& maps) {
  if (maps.size() < 2)
    return "";
  constexpr std::size_t name_width = 24;
  constexpr std::size_t number_width = 12;
  const std::array shown{"sq", "sdq", "ssk", "sku", "sz"};
  std::string head = padded("map", name_width);
  std::string means = padded("mean", name_width);
  std::string deviations = padded("standard deviation", name_width);
  std::string outliers;
  std::vector<std::string> rows;
  rows.reserve(maps.size());
  for (const surfaces::MapAnalysis& map : maps)
    rows.push_back(padded(map.name, name_width));
  for (const char* key : shown) {
    std::vector<double> values;
    SurfaceQuantity quantity;
    for (std::size_t i = 0; i < maps.size(); ++i) {
      const std::vector<SurfaceQuantity> all = quantities_of(maps[i]);
      quantity = *std::ranges::find(all, key, &SurfaceQuantity::key);
      values.push_back(quantity.by_nodes);
      rows[i] += " " + padded(quantity_text(values[i], quantity.unit, 4),
                              number_width);
    }
    const Spread spread = spread_of(values);
    head += " " + padded(quantity.symbol, number_width);
    means += " " +
             padded(quantity_text(spread.mean, quantity.unit, 4), number_width);
    deviations +=
        " " +
        padded(quantity_text(spread.deviation, quantity.unit, 2), number_width);
    for (const std::size_t i : outliers_of(values))
      outliers += fmt::format("{}{} of {}", outliers.empty() ? "" : "; ",
                              quantity.symbol, maps[i].name);
  }
  std::string text = head + "\n";
  for (const std::string& row : rows)
    text += row + "\n";
  return fmt::format("{}{}\n{}\noutliers: {}\n", text, means, deviations,
                     outliers.empty() ? "none" : outliers);
}

std::string line_text(const surfaces::LineAnalysis& line) {
  return fmt::format("{}: {} points over {}\n  {}\n{}  reliable: {}\n",
                     line.name, line.line.heights.size(),
                     quantity_text(line.line.length(), "m"), line.origin,
                     table_text(quantities_of(line), false), range_text(line));
}

std::string contact_text(const PredictedContact& contact) {
  std::string text = fmt::format(
      "contact by Persson's theory, E* = {}, gamma = {:g}, roughness "
      "of "
      "wavelengths {}:\n  u_0 = {}, beta = {:.4g}\n  {:>12} {:>12} {:>10}\n",
      quantity_text(contact.contact_modulus, "Pa"), contact.gamma,
      wavelengths_text(contact.wavevector_low, contact.wavevector_high),
      quantity_text(contact.decay_length, "m"), contact.pressure_prefactor,
      "pressure", "mean gap", "area");
  for (std::size_t i = 0; i < contact.loads.size(); i += 5) {
    const PredictedLoad& load = contact.loads[i];
    text += fmt::format("  {:>12} {:>12} {:>10}\n",
                        quantity_text(load.nominal_pressure, "Pa", 3),
                        quantity_text(load.mean_gap, "m", 3),
                        quantity_text(load.area_fraction, "%", 3));
  }
  return text;
}

} // namespace

std::string surface_text(const SurfaceReport& report) {
  std::string text;
  for (const surfaces::MapAnalysis& map : report.maps)
    text += map_text(map);
  for (const surfaces::LineAnalysis& line : report.lines)
    text += line_text(line);
  text += maps_text(report.maps);
  if (report.contact)
    text += contact_text(*report.contact);
  return text;
}

std::string spectrum_text(const std::vector<surfaces::SpectrumRing>& rows,
                          const std::string& comment) {
  std::string text = fmt::format("# {}\n# q [1/m]  C [m^4], <h^2> = 2 pi int "
                                 "q C dq\n",
                                 comment);
  for (const surfaces::SpectrumRing& row : rows)
    text += fmt::format("{:.8e} {:.8e}\n", row.wavevector, row.density);
  return text;
}

} // namespace asperity::reports
