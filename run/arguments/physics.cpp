#include "run/arguments/physics.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "input/nearest.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/measured_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <string_view>
#include <variant>

namespace asperity::run {
namespace {

/// The hardness of the first method that has one.
std::optional<mechanics::Quantity> hardness_of(const cases::Case& read) {
  for (const cases::MethodSpec& method : read.methods)
    if (const auto hardness = method.hardness())
      return hardness;
  return std::nullopt;
}

double rms_slope_of(const mechanics::SurfaceSpec& surface) {
  return surfaces::statistics(
             surfaces::with_edges(surfaces::levelled_map(surface),
                                  surface.edges))
      .rms_slope;
}

} // namespace

std::vector<std::string> flow_overrides(const std::string& fluid) {
  const std::map<std::string, std::string> viscosities{{"air", "1.85e-5 Pa s"},
                                                       {"water", "0.89 mPa s"}};
  std::string viscosity = fluid;
  if (const auto named = viscosities.find(fluid); named != viscosities.end())
    viscosity = named->second;
  else if (fluid.empty() ||
           std::isalpha(static_cast<unsigned char>(fluid.front())) != 0)
    throw input::InputError(fmt::format(
        "--flow = \"{}\" is no known fluid: water, air, or a viscosity such as "
        "\"0.1 Pa s\"; nearest: {}",
        fluid, input::nearest(fluid, {"air", "water"})));
  (void)positive_quantity("--flow", viscosity, input::Dimension::viscosity);
  return {"flow.viscosity=\"" + viscosity + "\"",
          "flow.pressure_drop=\"100 kPa\""};
}

std::vector<std::string> adhesion_overrides(const std::string& work,
                                            AdhesivePath path) {
  (void)positive_quantity("--work-of-adhesion", work,
                          input::Dimension::energy_per_area);
  std::vector<std::string> overrides{"halfspace.contact=\"exponential\"",
                                     "halfspace.work_of_adhesion=\"" + work +
                                         '"'};
  if (path == AdhesivePath::by_pressure)
    overrides.emplace_back(
        R"(load={ nominal_pressure = { from = "0.001 E* h'", to = "0.3 E* h'", )"
        R"(steps = 10, spacing = "log" }, cycle = "load-unload" })");
  if (path == AdhesivePath::by_gap)
    overrides.emplace_back(
        R"(load={ mean_gap = { from = "4 h_rms", to = "0.5 h_rms", )"
        R"(steps = 15, spacing = "linear" }, cycle = "load-unload" })");
  return overrides;
}

std::string loads_below_hardness(const std::vector<cases::Case>& presses) {
  constexpr double safe_share = 0.9; // of the hardness
  double share = 1.0;
  for (const cases::Case& contact_case : presses) {
    const std::optional<mechanics::Quantity> hardness =
        hardness_of(contact_case);
    if (!hardness)
      continue;
    mechanics::Scales scales;
    scales.contact_modulus = contact_case.material.contact_modulus;
    scales.rms_slope = rms_slope_of(contact_case.surface);
    share = std::min(share, safe_share * hardness->in_si(scales) /
                                (scales.contact_modulus * scales.rms_slope));
  }
  return share < 1.0
             ? fmt::format("load={{ nominal_pressure = {{ from = \"{:.3g} E* "
                           "h'\", to = \"{:.3g} E* h'\", steps = 12, spacing "
                           "= \"area\" }} }}",
                           0.01 * share, share)
             : "";
}

double positive_quantity(const std::string& option, const std::string& text,
                         input::Dimension dimension) {
  const input::ValueReading read = input::read_with_unit(text, dimension);
  if (!read.value)
    throw input::InputError(
        fmt::format("{} = \"{}\" {}", option, printable(text), read.mistake));
  if (!(*read.value > 0.0))
    throw input::InputError(fmt::format("{} = \"{}\", but must be > 0 [{}]",
                                        option, text,
                                        input::si_unit(dimension)));
  return *read.value;
}

std::string length_unit_text(const std::string& option,
                             const std::string& unit) {
  const bool has_number =
      unit.empty() || std::string_view("0123456789.+-").find(unit.front()) !=
                          std::string_view::npos;
  std::string text = has_number ? unit : "1 " + unit;
  (void)positive_quantity(option, text, input::Dimension::length);
  return text;
}

} // namespace asperity::run
