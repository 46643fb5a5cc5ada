#include "reports/analysis/warnings.hpp"

#include "base/shown_number.hpp"
#include "input/case_options.hpp"
#include "input/reader/locking.hpp"
#include "input/types/omissions.hpp"
#include "reports/analysis/exact.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/analysis/surface_theory.hpp"
#include "reports/analysis/theory_agreement.hpp"
#include "surfaces/analysis/reliable_range.hpp"
#include "surfaces/assumptions.hpp"
#include "surfaces/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace asperity::reports {
namespace {

using results::Result;
using results::SurfaceRecord;
using Limits = WarningLimits;

/// Averages over the realisations that have the number; NaN if none has it.
double mean_of(const Result& result, double SurfaceRecord::*number) {
  double sum = 0.0;
  int count = 0;
  for (const SurfaceRecord& surface : result.surfaces)
    if (std::isfinite(surface.*number)) {
      sum += surface.*number;
      ++count;
    }
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// The text up to the last semicolon within so many words, or "..." after them.
std::string first_words(const std::string& text, int most) {
  int words = 0;
  std::size_t part = std::string::npos;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == ';')
      part = at;
    if (text[at] == ' ' && ++words == most)
      return part == std::string::npos ? text.substr(0, at) + " …"
                                       : text.substr(0, part) + ".";
  }
  return text.ends_with('.') ? text : text + ".";
}

void add_moments(const Result& result, std::vector<Warning>& warnings) {
  const double skewness = mean_of(result, &SurfaceRecord::skewness);
  const double kurtosis = mean_of(result, &SurfaceRecord::kurtosis);
  if (!(std::abs(skewness) > Limits::skewness ||
        kurtosis < Limits::kurtosis_low || kurtosis > Limits::kurtosis_high))
    return;
  warnings.push_back(
      {"not_gaussian",
       fmt::format("The surface is not Gaussian: skewness {:.3g} and kurtosis "
                   "{:.3g}, but a Gaussian surface has 0 and 3 (limits: {} to "
                   "{}, {} to {}).",
                   skewness, kurtosis, -Limits::skewness, Limits::skewness,
                   Limits::kurtosis_low, Limits::kurtosis_high),
       "Persson's theory assumes Gaussian heights and does not describe this "
       "surface. Nor does its pressure distribution: do not use "
       "area_fraction_fit, area_fraction_moment or gamma_curve.",
       fmt::format(
           "Heights are not Gaussian (skewness {:.3g}, kurtosis {:.3g}): "
           "use neither the theory nor fits by it.",
           skewness, kurtosis)});
}

void add_slope(const Result& result, std::vector<Warning>& warnings) {
  const double slope = mean_of(result, &SurfaceRecord::rms_slope);
  if (!(slope > Limits::rms_slope))
    return;
  warnings.push_back(
      {"too_steep",
       fmt::format("The surface is too steep for small strain: rms slope "
                   "{:.2g} (limit: {}).",
                   slope, Limits::rms_slope),
       "The elastic methods and the theory are linear: the terms that they "
       "neglect grow with the square of the slope.",
       fmt::format(
           "The rms slope {:.2g} is large for linear elasticity: expect "
           "errors of its square.",
           slope)});
}

void add_resolution(const SurfaceRecord& surface,
                    std::vector<Warning>& warnings) {
  const SpectrumRows rows = spectrum_rows(surface);
  const double share = surfaces::unresolved_slope_share(rows.grid, rows.heights,
                                                        report_threads());
  if (!(share > Limits::unresolved_slope))
    return;
  warnings.push_back(
      {"not_resolved",
       fmt::format("The surface is not resolved: {:.0f} % of its mean square "
                   "slope lies above half the Nyquist wavevector, in waves "
                   "shorter than four node spacings (limit: {:.0f} %).",
                   100.0 * share, 100.0 * Limits::unresolved_slope),
       "Slope, contact area and stiffness are those of this grid, not of the "
       "surface: they change with every refinement of the measurement.",
       fmt::format(
           "{:.0f} % of the mean square slope is in unresolved waves: use "
           "more points, or compare values of surface.cut_off.",
           100.0 * share)});
}

void add_noise(const Result& result, std::vector<Warning>& warnings) {
  const SurfaceRecord& surface = result.surfaces.front();
  const double area = nominal_area(result);
  const std::vector<surfaces::SpectrumRing> rings =
      spectrum_rings(surface, area);
  const auto floor = noise_floor_of(rings, surface.grid, area);
  double whole = 0.0, above = 0.0;
  for (const surfaces::SpectrumRing& ring : rings) {
    const double square =
        ring.wavevector * ring.wavevector * ring.mean_square_height;
    whole += square;
    above += floor && ring.wavevector > floor->wavevector ? square : 0.0;
  }
  if (!(above > Limits::noise_slope * whole))
    return;
  warnings.push_back(
      {"noise",
       fmt::format(
           "The map contains noise of its instrument: beyond a "
           "wavelength of {} its spectrum is flat, and {:.0f} % "
           "of its mean square slope lies there (limit: {:.0f} %).",
           quantity_text(2.0 * std::numbers::pi / floor->wavevector, "m", 3),
           100.0 * above / whole, 100.0 * Limits::noise_slope),
       "Noise is pressed as if it were roughness: slope, contact area and "
       "stiffness are partly those of the instrument. Use cut_off = "
       "\"reliable\", and a sweep over cut_off to see the area against it.",
       fmt::format(
           "{:.0f} % of the mean square slope is noise of the instrument: "
           "use {}.",
           100.0 * above / whole,
           input::setting("surface.cut_off", "reliable"))});
}

void add_lines(const SurfaceRecord& surface, std::vector<Warning>& warnings) {
  const double ratio =
      surfaces::line_offset_ratio(surface.grid, height_rows(surface));
  const double larger = std::max(ratio, 1.0 / ratio);
  if (!(larger > Limits::line_offset))
    return;
  warnings.push_back(
      {"scan_lines",
       fmt::format("The map shows scan lines or grooves along {}: neighbouring "
                   "lines differ {:.1f} times as much in height as those of "
                   "the other direction (limit: {}).",
                   ratio > 1.0 ? "x" : "y", larger, Limits::line_offset),
       "Artefacts of the scan are taken for roughness of the surface. "
       "Persson's theory assumes the same roughness in all directions and does "
       "not describe this map.",
       fmt::format(
           "Scan lines or grooves along {}: if they are artefacts, {} removes "
           "them.",
           ratio > 1.0 ? "x" : "y",
           input::setting("surface.align_lines", "median"))});
}

void add_digits(const SurfaceRecord& surface, std::vector<Warning>& warnings) {
  const double step = surfaces::height_step(surface.grid, height_rows(surface),
                                            surface.rms_height) /
                      surface.rms_height;
  if (!(step > Limits::height_step))
    return;
  warnings.push_back(
      {"few_digits",
       fmt::format("The file of the map has too few digits: its heights are "
                   "multiples of {:.2g} h_rms (limit: {:g}).",
                   step, Limits::height_step),
       "Typical causes are single precision with a large offset and integers "
       "that use a small part of their range. The steps are pressed as if they "
       "were roughness: gaps and light contact are uncertain by about one "
       "step. "
       "Export the heights about their mean, or in double precision.",
       fmt::format(
           "Heights are multiples of {:.2g} h_rms: export them about their "
           "mean, or with more digits.",
           step)});
}

void add_tilt(const SurfaceRecord& surface, std::vector<Warning>& warnings) {
  // The images of a tilted map make a roof, which has no mean plane.
  const results::StoredMap map = surface.heights_of_map();
  const double roughness =
      surfaces::rms_about_plane(surface.map_grid(), [&map](const auto& take) {
        results::each_piece(map, take);
      });
  if (!(surface.rms_height > Limits::tilt * roughness))
    return;
  warnings.push_back(
      {"tilted",
       fmt::format("The map is tilted: its rms height of {} is {} "
                   "times the {} about its mean plane (limit: {:g}).",
                   quantity_text(surface.rms_height, "m", 3),
                   digits_text(surface.rms_height / roughness, 3),
                   quantity_text(roughness, "m", 3), Limits::tilt),
       "Everything in units of h_rms refers to the tilted map: relative to the "
       "roughness, the tolerance of the solvers is larger by this factor. Use "
       "level = \"plane\", or a tolerance that is smaller by it.",
       fmt::format("The map is tilted, {} times its roughness: use {}.",
                   digits_text(surface.rms_height / roughness, 3),
                   input::setting("surface.level", "plane"))});
}

/// Spikes, form and missing points that were found when the map was read.
void add_map_faults(const Result& result, std::vector<Warning>& warnings) {
  for (const auto& [key, fact] : result.provenance)
    if (key == "map warnings")
      warnings.push_back(
          {"map_faults", "The map is not only roughness: " + fact + ".",
           "Contact begins at the highest points: area, spots and gap are "
           "partly those of such points and not of the roughness.",
           first_words(fact, 20), true});
}

void add_window(const Result& result, std::vector<Warning>& warnings) {
  for (const auto& [key, fact] : result.provenance)
    if (key == "window")
      warnings.push_back(
          {"windowed",
           "The map was windowed before the contact was computed: " + fact +
               ".",
           "The computed contact is not that of the measured surface; edges = "
           "\"mirror\" keeps its roughness.",
           "The map was multiplied by a window: surface.edges = \"mirror\" "
           "keeps its "
           "roughness."});
}

/// The methods of the case that the result has.
std::vector<cases::MethodSpec> methods_in(const Result& result,
                                          const cases::Case& contact_case) {
  std::vector<cases::MethodSpec> present;
  for (const cases::MethodSpec& method : contact_case.methods)
    if (result.method(method.name) != nullptr)
      present.push_back(method);
  return present;
}

void add_locking(const Result& result, const cases::Case& contact_case,
                 std::vector<Warning>& warnings) {
  for (const std::string& text : cases::locking_warnings(
           contact_case.material, methods_in(result, contact_case)))
    warnings.push_back(
        {"locking", text + ".",
         "The curves of this method are not those of the "
         "material; do not judge other methods by them.",
         "Finite elements of this material lock: do not judge other methods by "
         "them.",
         true});
}

void add_omissions(const Result& result, const cases::Case& contact_case,
                   std::vector<Warning>& warnings) {
  for (const std::string& text :
       cases::omission_warnings(contact_case, methods_in(result, contact_case)))
    warnings.push_back({"omitted", text + ".",
                        "What the case asks is not in this result, or not for "
                        "the methods with fields.",
                        first_words(text, 20), true});
}

void add_interpolation(const Result& result, const cases::Case& contact_case,
                       std::vector<Warning>& warnings) {
  for (const std::string& text : cases::interpolation_warnings(
           contact_case, methods_in(result, contact_case)))
    warnings.push_back(
        {"oscillating_heights", text + ".",
         "Contact areas and pressures at the edge of the end "
         "are those of another surface.",
         "The surface oscillates at the edge of the end: contact there is that "
         "of another surface.",
         true});
}

/// Warns if the surface around the end of a punch touches in a converged step.
void add_recess(const Result& result, const cases::Case& contact_case,
                std::vector<Warning>& warnings) {
  for (const results::MethodRecord& method : result.methods) {
    const double touching =
        touching_pressure(contact_case.surface, result.contact_modulus,
                          has_free_boundaries(contact_case, method));
    for (const results::CurvePoint& point : method.rows())
      if (method.kind != "theory" &&
          point.status == results::StepStatus::converged &&
          point.nominal_pressure >= touching) {
        warnings.push_back(
            {"recess_touches",
             fmt::format("The surface around the end of the punch touches "
                         "from a nominal pressure of {} on.",
                         quantity_text(touching, "Pa")),
             "The exact solution of a flat end does not hold there: steps "
             "of this pressure and above are not compared with it.",
             fmt::format(
                 "From {} on, the face around the end touches: these steps "
                 "have no exact solution.",
                 quantity_text(touching, "Pa", 3))});
        return;
      }
  }
}

/// Warns if steps of methods other than theories converged, all without load.
void add_no_contact(const Result& result, std::vector<Warning>& warnings) {
  double smallest_gap = std::numeric_limits<double>::infinity();
  for (const results::MethodRecord& method : result.methods)
    for (const results::CurvePoint& point : method.rows()) {
      if (method.kind == "theory" ||
          point.status != results::StepStatus::converged)
        continue;
      if (point.nominal_pressure != 0.0 || point.area_fraction > 0.0)
        return;
      smallest_gap = std::min(smallest_gap, point.mean_gap);
    }
  if (result.surfaces.empty() || !std::isfinite(smallest_gap))
    return;
  const SurfaceRecord& first = result.surfaces.front();
  warnings.push_back(
      {"no_contact",
       fmt::format("No load step reaches contact: the smallest mean gap is "
                   "{:.3g} h_rms, and the highest point lies {:.3g} h_rms "
                   "above the mean plane.",
                   smallest_gap / first.rms_height,
                   first.highest / first.rms_height),
       "All pressures are 0, so that curves and fits are empty and their "
       "figures are left out.",
       fmt::format(
           "No load step reaches contact: press to a mean gap below {}.",
           quantity_text(first.highest, "m", 3))});
}

} // namespace

std::vector<Warning> warnings_of(const Result& result,
                                 const cases::Case& contact_case) {
  std::vector<Warning> warnings;
  add_locking(result, contact_case, warnings);
  add_interpolation(result, contact_case, warnings);
  add_omissions(result, contact_case, warnings);
  add_recess(result, contact_case, warnings);
  add_no_contact(result, warnings);
  const mechanics::SurfaceKind kind = contact_case.surface.kind;
  const bool is_measured = kind == mechanics::SurfaceKind::measured;
  if (!is_measured && !surfaces::is_random(kind))
    return warnings;
  add_map_faults(result, warnings);
  add_window(result, warnings);
  add_moments(result, warnings);
  add_slope(result, warnings);
  if (!result.surfaces.empty() && result.surfaces.front().has_heights()) {
    const SurfaceRecord& first = result.surfaces.front();
    add_resolution(first, warnings);
    if (is_measured) {
      add_noise(result, warnings);
      add_lines(first, warnings);
      add_digits(first, warnings);
      add_tilt(first, warnings);
    }
  }
  for (Warning& warning : theory_disagreements(result, contact_case, warnings))
    warnings.push_back(std::move(warning));
  return warnings;
}

std::string warning_lines(const Result& result, const cases::Case& contact_case,
                          bool has_run) {
  std::string lines;
  for (const Warning& warning : warnings_of(result, contact_case))
    if (!has_run || !warning.is_known_before)
      lines += fmt::format("warning: {}: {}\n", result.case_name, warning.line);
  return lines;
}

} // namespace asperity::reports
