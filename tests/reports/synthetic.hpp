#pragma once

// A result like that of a run, made of formulas: the theory's own curves on
// random surfaces, and "methods" that differ from it by known amounts.

#include "results/types/result.hpp"
#include "theory/persson/persson.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "synthetic_surface.hpp"

namespace asperity::reports::synthetic {

inline constexpr double area_factor = 1.25; // of the "fem" over theory
inline constexpr double gap_shift = 0.02;   // of the "fem", in h_rms

/// The curve of the formula with its gap shifted (in h_rms) and its area
/// scaled.
inline results::Curve curve(const theory::PerssonContact& contact, double shift,
                            double area_scale) {
  results::Curve curve;
  for (int i = 0; i < 16; ++i) {
    results::CurvePoint point;
    point.step = i;
    point.nominal_pressure = 1e-4 * std::pow(500.0, i / 15.0) * contact_modulus;
    point.mean_gap = contact.mean_gap(point.nominal_pressure) +
                     shift * contact.spectrum().rms_height();
    const double area = contact.area_fraction(point.nominal_pressure);
    point.area_fraction = std::min(1.0, area_scale * area);
    point.area_fraction_corrected =
        1.0 + 0.9 * (point.area_fraction - 1.0) - 0.1 + 0.1 * area;
    point.iterations = shift == 0.0 ? 0 : 20 + i;
    point.cpu_time = 0.05 + 0.01 * i;
    point.residual = 1e-9;
    curve.points.push_back(point);
  }
  return curve;
}

/// Maps similar to contact: the pressure grows with the height above a plane
/// that rises from load to load.
inline results::Fields fields(const results::SurfaceRecord& surface, int step,
                              double nominal_pressure, double level) {
  results::Fields maps;
  maps.step = step;
  maps.nominal_pressure = nominal_pressure;
  maps.grid = surface.grid;
  double sum = 0.0;
  for (const double height : surface.heights) {
    const double overlap = height - level * surface.rms_height;
    maps.pressure.push_back(std::max(0.0, overlap));
    maps.gap.push_back(std::max(0.0, -overlap));
    sum += maps.pressure.back();
  }
  const double scale =
      nominal_pressure * static_cast<double>(surface.heights.size()) / sum;
  for (double& pressure : maps.pressure)
    pressure *= scale;
  return maps;
}

/// The theory of the formula and a "fem" on `realizations` surfaces.
inline results::Result rough_result(const cases::Case& rough,
                                    int realizations) {
  results::Result result;
  result.case_name = rough.name;
  result.case_title = rough.title;
  result.case_text = "title = \"A <polymer> & so on\"\n";
  result.case_hash = "0123456789abcdef";
  result.status = "complete";
  result.contact_modulus = contact_modulus;
  result.provenance = {{"program", "asperity 0.1.0"}, {"host", "somewhere"}};
  const theory::PerssonContact contact = contact_of(rough.surface);
  results::MethodRecord theory{
      "theory", "theory", "Persson's theory of the formula", {}};
  theory.realizations.push_back(curve(contact, 0.0, 1.0));
  results::MethodRecord fem{"fem", "fem", "condensed Q1 block, penalty", {}};
  for (int r = 0; r < realizations; ++r) {
    result.surfaces.push_back(
        surface(rough.surface, 100u + static_cast<unsigned>(r)));
    fem.realizations.push_back(
        curve(contact, gap_shift * (1.0 + 0.2 * (r - 1)), area_factor));
  }
  for (const auto& [step, level] :
       {std::pair(2, 2.2), std::pair(8, 1.2), std::pair(14, 0.2)})
    fem.realizations.front().fields.push_back(
        fields(result.surfaces.front(), step,
               fem.realizations.front()
                   .points[static_cast<std::size_t>(step)]
                   .nominal_pressure,
               level));
  result.methods = {theory, fem};
  return result;
}

} // namespace asperity::reports::synthetic
