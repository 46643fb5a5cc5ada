#include "base/json.hpp"
#include "reports/surface/surface_page.hpp"
#include "reports/surface/surface_quantities.hpp"

#include <numbers>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

Json rows_json(const std::vector<surfaces::SpectrumRing>& rows) {
  Json list = Json::array();
  for (const surfaces::SpectrumRing& row : rows) {
    const surfaces::DensityInterval interval = confidence_of(row);
    list.push_back({{"wavevector", row.wavevector},
                    {"density", row.density},
                    {"low", interval.low},
                    {"high", interval.high},
                    {"degrees_of_freedom", row.degrees_of_freedom}});
  }
  return list;
}

Json quantities_json(const std::vector<SurfaceQuantity>& quantities) {
  Json object;
  for (const SurfaceQuantity& quantity : quantities) {
    Json entry{{"value", quantity.by_nodes},
               {"unit", quantity.unit},
               {"symbol", quantity.symbol},
               {"meaning", quantity.meaning}};
    if (std::isfinite(quantity.by_spectrum))
      entry["by_spectrum"] = quantity.by_spectrum;
    object[quantity.key] = entry;
  }
  return object;
}

Json fit_json(const surfaces::SelfAffineFit& fit) {
  Json object;
  for (const FittedQuantity& quantity : quantities_of(fit)) {
    const surfaces::FittedParameter& fitted = quantity.parameter;
    Json entry{{"value", fitted.value},
               {"low", fitted.low},
               {"high", fitted.high},
               {"unit", quantity.unit},
               {"symbol", quantity.symbol},
               {"meaning", quantity.meaning},
               {"interval", interval_text(quantity)}};
    if (!fitted.reason.empty())
      entry["reason"] = fitted.reason;
    if (quantity.unit == "1/m") // a wavelength is easier to imagine
      entry["wavelength"] = 2.0 * std::numbers::pi / fitted.value;
    object[quantity.key] = entry;
  }
  object["plateau"] = fit.plateau;
  object["noise"] = fit.noise;
  object["dispersion"] = fit.dispersion;
  object["is_model"] = fit.is_model;
  return object;
}

Json map_json(const surfaces::MapAnalysis& map) {
  const Grid& grid = map.map.grid;
  const surfaces::ReliableRange& range = map.range;
  Json object{{"name", map.name},
              {"origin", map.origin},
              {"warnings", map.warnings},
              {"points", {grid.points_x, grid.points_y}},
              {"lengths", {grid.length_x, grid.length_y}},
              {"is_periodic", map.is_periodic},
              {"parameters", quantities_json(quantities_of(map))},
              {"reliable",
               {{"low", range.low},
                {"high", range.high},
                {"low_reason", range.low_reason},
                {"high_reason", range.high_reason},
                {"words", range_text(map)}}}};
  if (range.noise)
    object["reliable"]["noise_floor"] = range.noise->density;
  if (range.tip_wavevector)
    object["reliable"]["tip_wavevector"] = *range.tip_wavevector;
  object["self_affine"] = map.fit ? fit_json(*map.fit) : Json(nullptr);
  object["spectrum"] = rows_json(joined_rings(map.spectrum.rings, 15.0));
  Json scales = Json::array();
  for (const surfaces::LocalDifferences& scale : map.scales)
    scales.push_back({{"distance", scale.distance()},
                      {"rms_slope", scale.rms_slope()},
                      {"rms_curvature", scale.rms_curvature()},
                      {"sharpest_peak", -scale.lowest_second}});
  object["scales"] = scales;
  return object;
}

Json line_json(const surfaces::LineAnalysis& line) {
  return {
      {"name", line.name},
      {"origin", line.origin},
      {"points", line.line.heights.size()},
      {"length", line.line.length()},
      {"parameters", quantities_json(quantities_of(line))},
      {"reliable",
       {{"low", line.low}, {"high", line.high}, {"words", range_text(line)}}},
      {"line_spectrum", rows_json(line.line_rows)},
      {"spectrum", rows_json(line.rows)}};
}

Json contact_json(const PredictedContact& contact) {
  Json loads = Json::array();
  for (const PredictedLoad& load : contact.loads)
    loads.push_back({{"nominal_pressure", load.nominal_pressure},
                     {"mean_gap", load.mean_gap},
                     {"area_fraction", load.area_fraction}});
  return {{"contact_modulus", contact.contact_modulus},
          {"gamma", contact.gamma},
          {"rms_height", contact.rms_height},
          {"rms_slope", contact.rms_slope},
          {"wavevector_low", contact.wavevector_low},
          {"wavevector_high", contact.wavevector_high},
          {"decay_length", contact.decay_length},
          {"pressure_prefactor", contact.pressure_prefactor},
          {"loads", loads}};
}

} // namespace

nlohmann::ordered_json surface_json(const SurfaceReport& report) {
  Json maps = Json::array();
  for (const surfaces::MapAnalysis& map : report.maps)
    maps.push_back(map_json(map));
  Json lines = Json::array();
  for (const surfaces::LineAnalysis& line : report.lines)
    lines.push_back(line_json(line));
  Json object{{"format", "asperity-surface"},
              {"schema", 1},
              {"title", report.title},
              {"maps", maps},
              {"lines", lines}};
  if (report.contact)
    object["contact"] = contact_json(*report.contact);
  return object;
}

} // namespace asperity::reports
