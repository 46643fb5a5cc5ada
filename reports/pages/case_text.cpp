#include "base/shown_number.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/pages/html_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace asperity::reports {
namespace {

using mechanics::SurfaceKind;

std::string wavelength_text(double wavevector) {
  return quantity_text(2.0 * std::numbers::pi / wavevector, "m", 3);
}

std::string kind_words(const mechanics::SurfaceSpec& surface) {
  switch (surface.kind) {
  case SurfaceKind::self_affine:
    return fmt::format("self-affine surface, H = {:.3g}, roll-off at {}, "
                       "wavelengths from {} to {}",
                       surface.hurst,
                       wavelength_text(surface.wavevector_roll_off),
                       wavelength_text(surface.wavevector_high),
                       wavelength_text(surface.wavevector_low));
  case SurfaceKind::spectrum:
    return "surface with a tabulated spectrum";
  case SurfaceKind::measured:
    return "measured surface";
  case SurfaceKind::sphere:
    return "sphere of radius " + quantity_text(surface.radius, "m", 6);
  case SurfaceKind::punch:
    return "flat punch of radius " + quantity_text(surface.radius, "m", 6) +
           (surface.tilt == 0.0
                ? ""
                : fmt::format(", tilted by {:.3g}", surface.tilt));
  case SurfaceKind::cone:
    return fmt::format("cone of slope {:.4g}", surface.slope);
  case SurfaceKind::rounded_punch:
    return fmt::format("flat punch of radius {} with an edge of radius {}",
                       quantity_text(surface.radius, "m", 6),
                       quantity_text(surface.edge_radius, "m", 6));
  case SurfaceKind::wave_1d:
    return fmt::format("one-dimensional wave, amplitude {}, length {}",
                       quantity_text(surface.amplitude, "m"),
                       quantity_text(surface.wavelength, "m"));
  case SurfaceKind::wave_2d:
    return fmt::format("two-dimensional wave, amplitude {}, length {}",
                       quantity_text(surface.amplitude, "m"),
                       quantity_text(surface.wavelength, "m"));
  }
  return "surface";
}

std::string surface_words(const mechanics::SurfaceSpec& surface) {
  return kind_words(surface) +
         (surface.form_radius ? ", on a sphere of radius " +
                                    quantity_text(*surface.form_radius, "m", 6)
                              : "");
}

/// The surface whose numbers are stated: a map that is pressed once has its
/// mirror images in the result as well, for other methods.
const results::SurfaceRecord& stated_surface(const ReportEntry& entry) {
  const results::Result& result = *entry.result;
  if (!result.case_text.empty() &&
      entry.contact_case->surface.edges == mechanics::Edges::free)
    for (const results::MethodRecord& method : result.methods)
      if (!method.realizations.empty() &&
          method.realizations.front().own_surface)
        return *method.realizations.front().own_surface;
  return result.surfaces.front();
}

/// Whether a method presses the mirror images of a map that another one presses
/// without them.
bool has_pressed_images(const ReportEntry& entry) {
  const results::Result& result = *entry.result;
  return !result.surfaces.empty() &&
         &stated_surface(entry) != &result.surfaces.front() &&
         std::ranges::any_of(
             result.methods, [](const results::MethodRecord& method) {
               return method.kind != "theory" && !method.realizations.empty() &&
                      !method.realizations.front().own_surface;
             });
}

std::string grid_words(const ReportEntry& entry) {
  const results::Result& result = *entry.result;
  if (result.surfaces.empty())
    return "";
  const results::SurfaceRecord& surface = stated_surface(entry);
  const Grid grid = surface.map_grid();
  std::string words = fmt::format(
      "; {} × {} points over {} × {}, rms height {}, rms slope {:.3g}",
      grid.points_x, grid.points_y, quantity_text(grid.length_x, "m"),
      quantity_text(grid.length_y, "m"), quantity_text(surface.rms_height, "m"),
      surface.rms_slope);
  if (result.surfaces.size() > 1)
    words += fmt::format("; {} realisations", result.surfaces.size());
  return words;
}

/// The prescribed loads of all methods.
struct Loads {
  bool are_gaps = false; ///< and not nominal pressures
  std::size_t steps = 0;
  double least = not_a_number;   ///< [Pa] or [m]
  double largest = not_a_number; ///< [Pa] or [m]
};

Loads loads_of(const ReportEntry& entry) {
  const results::Result& result = *entry.result;
  Loads loads;
  loads.are_gaps =
      !result.case_text.empty() &&
      entry.contact_case->load.control == mechanics::Control::mean_gap;
  for (const results::MethodRecord& method : result.methods)
    for (const results::Curve& curve : method.realizations) {
      loads.steps = std::max(loads.steps, curve.points.size());
      for (const results::CurvePoint& point : curve.points) {
        const double load =
            loads.are_gaps ? point.mean_gap : point.nominal_pressure;
        loads.least = std::fmin(loads.least, load);
        loads.largest = std::fmax(loads.largest, load);
      }
    }
  return loads;
}

std::string load_words(const ReportEntry& entry) {
  const auto [are_gaps, steps, least, largest] = loads_of(entry);
  if (steps == 0)
    return "";
  const double modulus = entry.result->contact_modulus;
  const bool is_one = !(largest > least * (1.0 + 1e-9)) || steps == 1;
  std::string words =
      fmt::format("; {} load step{}, {}{}", steps, steps == 1 ? "" : "s",
                  are_gaps ? is_one ? "mean gap " : "mean gaps " : "",
                  quantity_text(least, are_gaps ? "m" : "Pa", 3));
  if (!is_one)
    words += " to " + quantity_text(largest, are_gaps ? "m" : "Pa", 3);
  if (are_gaps)
    return words;
  return words + (is_one ? fmt::format(" (p/E* = {:.3g})", least / modulus)
                         : fmt::format(" (p/E* from {:.3g} to {:.3g})",
                                       least / modulus, largest / modulus));
}

/// Puts what follows the first comma into parentheses.
std::string with_parentheses(const std::string& words) {
  const std::size_t comma = words.find(", ");
  return comma == std::string::npos
             ? words
             : words.substr(0, comma) + " (" + words.substr(comma + 2) + ")";
}

/// How a map was read and prepared.
std::string map_words(const ReportEntry& entry) {
  const mechanics::SurfaceSpec& surface = entry.contact_case->surface;
  if (surface.kind != SurfaceKind::measured)
    return "";
  constexpr std::array<const char*, 5> removed{
      "not levelled", "levelled by a plane", "levelled by a second-order form",
      "levelled by a sphere", "levelled by a cylinder"};
  std::string words = " (";
  for (const auto& [key, fact] : entry.summary.provenance)
    if (key == "map")
      words += "read by: " + fact + "; ";
  words += removed.at(static_cast<std::size_t>(surface.level));
  if (surface.align_lines != mechanics::LineAlignment::none)
    words += "; scan lines aligned by their medians";
  if (surface.crop)
    words += "; a part of the map";
  if (surface.edges == mechanics::Edges::window)
    words += "; multiplied by a window";
  return words + ")";
}

std::string surface_sentence(const ReportEntry& entry) {
  const results::Result& result = *entry.result;
  const bool has_case = !result.case_text.empty();
  const mechanics::MaterialSpec& material = entry.contact_case->material;
  std::string words = fmt::format(
      "An elastic block with E* = {}{} was pressed against a{} {}{}",
      quantity_text(result.contact_modulus, "Pa"),
      material.layers.empty()
          ? ""
          : fmt::format(" under {} bonded layer{}", material.layers.size(),
                        material.layers.size() == 1 ? "" : "s"),
      material.counter ? "n elastic body, which E* includes, with a" : " rigid",
      has_case ? with_parentheses(surface_words(entry.contact_case->surface))
               : "surface",
      has_case ? map_words(entry) : "");
  if (has_case &&
      entry.contact_case->surface.edges == mechanics::Edges::mirror &&
      entry.contact_case->surface.kind == SurfaceKind::measured)
    words += ", continued by its mirror images";
  if (has_pressed_images(entry))
    words += ", continued by its mirror images where boundaries are periodic";
  if (result.surfaces.empty())
    return words + ".";
  const results::SurfaceRecord& surface = stated_surface(entry);
  const Grid grid = surface.map_grid();
  words += fmt::format(
      ". {} {} × {} points over {} × {}, with rms height {} and rms slope "
      "{:.3g}{}.",
      result.surfaces.size() > 1
          ? fmt::format("Each of {} realisations had", result.surfaces.size())
          : "It had",
      grid.points_x, grid.points_y, quantity_text(grid.length_x, "m"),
      quantity_text(grid.length_y, "m"), quantity_text(surface.rms_height, "m"),
      surface.rms_slope, result.surfaces.size() > 1 ? " in the first one" : "");
  return words;
}

} // namespace

std::string setup_sentences(const ReportEntry& entry) {
  const double modulus = entry.result->contact_modulus;
  const auto [are_gaps, steps, least, largest] = loads_of(entry);
  std::string words = surface_sentence(entry);
  if (are_gaps)
    words += steps == 1
                 ? fmt::format(" The mean gap was {}.",
                               quantity_text(largest, "m", 3))
                 : fmt::format(" The mean gap had {} values from {} to {}.",
                               steps, quantity_text(least, "m", 3),
                               quantity_text(largest, "m", 3));
  else if (steps == 1)
    words +=
        fmt::format(" The nominal pressure was {:.3g} E*.", largest / modulus);
  else if (steps > 1)
    words += fmt::format(
        " The nominal pressure had {} values from {:.3g} E* to {:.3g} E*.",
        steps, least / modulus, largest / modulus);
  return words;
}

std::string case_sentence(const ReportEntry& entry) {
  const results::MethodRecord* const first =
      entry.result->methods.empty() ? nullptr : &entry.result->methods.front();
  if (first != nullptr && first->kind == measured_kind)
    return fmt::format("A {}{}.", first->description, load_words(entry));
  return fmt::format(
      "An elastic block, E* = {}, pressed against a rigid {}{}{}.",
      quantity_text(entry.result->contact_modulus, "Pa"),
      entry.result->case_text.empty()
          ? "surface"
          : surface_words(entry.contact_case->surface),
      grid_words(entry), load_words(entry));
}

} // namespace asperity::reports
