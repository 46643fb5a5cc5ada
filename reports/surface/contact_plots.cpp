// The figures of the predicted contact of a surface report.
#include "base/special_numbers.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/surface/surface_figures.hpp"
#include "reports/surface/surface_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace asperity::reports {
namespace {

/// The area against the shortest wave that is kept; what is not reliable is
/// shaded.
Figure cut_off_figure(const PredictedContact& contact) {
  Figure figure;
  figure.name = "predicted-cut-off";
  figure.title = "Predicted contact area against the cut-off";
  CsvTable table(
      {"curve", "index", "cut-off [um]", "A/A_0 light [1]", "A/A_0 heavy [1]"});
  for (const CutOffArea& area : contact.cut_offs)
    table.add("theory", {0.0, area.wavelength * 1e6, area.light, area.heavy});
  const double end = 2e6 * std::numbers::pi / contact.wavevector_high;
  figure.caption = fmt::format(
      "Contact area by Persson's theory if all waves below a cut-off are "
      "removed. A resolved area does not change with the last waves; here it "
      "is that of the reliable range, down to {}. In the shaded part "
      "the spectrum is not reliable. [surface] cut_off presses the map with "
      "one of these cut-offs.",
      quantity_text(1e-6 * end, "m", 3));
  ChartPanel panel{
      .x = {.label = "shortest wavelength that is kept [µm]", .is_log = true},
      .y = {
          .label = "contact area A / A_0", .is_log = true, .has_powers = true}};
  panel.curves = {curve(quantity_text(contact.heavy_load, "Pa"),
                        line("#D55E00", 1.8), 0, 3, 5),
                  curve(quantity_text(contact.light_load, "Pa"),
                        line("#0072B2", 1.8), 0, 3, 4)};
  panel.marks = {{.low = -infinity,
                  .high = rounded(end, 6),
                  .color = "#59636e",
                  .opacity = 0.1}};
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

} // namespace

std::vector<Figure> contact_figures(const PredictedContact& contact) {
  const double modulus = contact.contact_modulus;
  const std::string slope = digits_text(contact.rms_slope, 3);
  Figure separation;
  separation.name = "predicted-separation";
  separation.title = "Predicted separation";
  const bool is_high = contact.rms_height > 2e-6;
  CsvTable table(
      {"curve", "index", is_high ? "u [um]" : "u [nm]", "p [Pa]", "A/A_0 [1]"});
  for (const PredictedLoad& load : contact.loads)
    table.add("theory", {0.0, load.mean_gap * (is_high ? 1e6 : 1e9),
                         load.nominal_pressure, load.area_fraction});
  separation.data = table.text();
  separation.caption = fmt::format(
      "Nominal pressure against mean separation by Persson's theory with E* = "
      "{} and γ = {:g}, for roughness of wavelengths {} (rms height {}, rms "
      "slope {}). At low pressure p = β E* exp(−u/u₀) with u₀ = {}, β = {}.",
      quantity_text(modulus, "Pa"), contact.gamma,
      wavelengths_text(contact.wavevector_low, contact.wavevector_high),
      quantity_text(contact.rms_height, "m"), slope,
      quantity_text(contact.decay_length, "m"),
      digits_text(contact.pressure_prefactor, 3));
  const double heaviest = contact.loads.back().nominal_pressure;
  ChartAxis pressure =
      pressure_axis("nominal pressure p / E*", "nominal pressure p", modulus,
                    heaviest / modulus);
  pressure.is_log = pressure.has_powers = true;
  const CurveStyle style = line("#222222", 1.8);
  ChartCurve drawn = curve("", style, 0, 3, 4);
  drawn.factor = 1.0 / modulus; // to p/E*, of which the axis has MPa first
  separation.panels = {{.x = {.label = is_high ? "mean separation u [µm]"
                                               : "mean separation u [nm]",
                              .low = 0.0},
                        .y = pressure,
                        .curves = {drawn}}};
  use_other_units(separation.panels.front());
  separation.panels.front().x.other =
      OtherUnits{"mean separation u / h_{rms}",
                 (is_high ? 1e-6 : 1e-9) / contact.rms_height};
  separation.is_physical = true;
  Figure area = separation;
  area.name = "predicted-area";
  area.title = "Predicted contact area";
  area.caption = fmt::format(
      "Contact area against nominal pressure by the same theory, A/A₀ = erf(√2 "
      "p/(E* h')) with the rms slope h' = {}; the data hold 31 loads.",
      slope);
  drawn = curve("", style, 0, 4, 5);
  drawn.x_factor = 1.0 / modulus;
  area.panels = {{.x = pressure,
                  .y = {.label = "contact area A / A_0",
                        .is_log = true,
                        .has_powers = true},
                  .curves = {drawn}}};
  use_other_units(area.panels.front());
  std::vector<Figure> figures{separation, area};
  if (!contact.cut_offs.empty())
    figures.push_back(cut_off_figure(contact));
  return figures;
}

} // namespace asperity::reports
