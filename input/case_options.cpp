#include "input/case_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace asperity::input {
namespace {

using enum OptionGroup;

/// The options of maps, bodies and loads.
std::vector<CaseOption> problem_rows() {
  return {{map, "--length", "surface.length", "Q", "20 um",
           "side length in x of a map whose file states none,\n"
           "e.g. \"20 um\""},
          {map, "--height-unit", "surface.height_unit", "U", "nm",
           "unit of the heights of such a map, e.g. nm"},
          {map, "--length-unit", "surface.length_unit", "U", "um",
           "unit of the positions of a list x y z, e.g. um"},
          {map, "--missing-value", "surface.missing_value", "X", "-9999",
           "number at points of a map that were not measured,\n"
           "e.g. -9999"},
          {map, "--channel", "surface.channel", "NAME", "Height",
           "channel of the file, by its title or number"},
          {map, "--level", "surface.level", "FORM", "plane",
           "form removed from a map: none, plane, bow, sphere or\n"
           "cylinder (default: plane)"},
          {map, "--remove-spikes", "surface.remove_spikes", "X", "8",
           "replace points of a map that are so many robust\n"
           "standard deviations off their neighbours, e.g. 8"},
          {map, "--cut-off", "surface.cut_off", "Q", "600 nm",
           "remove shorter waves of a map, e.g. \"600 nm\", or\n"
           "\"reliable\": those in its noise"},
          {body, "--contact-modulus", "material.contact_modulus", "Q", "2 GPa",
           "E* of the block, or of both bodies, e.g. \"2 GPa\""},
          {body, "--youngs-modulus", "material.youngs_modulus", "Q", "2 GPa",
           "E of the block in the place of E*, e.g. \"2 GPa\""},
          {body, "--poisson-ratio", "material.poisson_ratio", "X", "0.3",
           "Poisson's ratio of the block, e.g. 0.3"},
          {body, "--counter-youngs-modulus", "material.counter.youngs_modulus",
           "Q", "210 GPa",
           "E of the body on it (default: it is rigid),\n"
           "e.g. \"210 GPa\""},
          {body, "--counter-poisson-ratio", "material.counter.poisson_ratio",
           "X", "0.3", "Poisson's ratio of that body, e.g. 0.3"},
          {load, "--pressure", "load.nominal_pressure", "Q", "1 MPa",
           "nominal pressure, e.g. \"1 MPa\", or a range of them,\n"
           "\"1 kPa..1 MPa\"; may be repeated"}};
}

std::vector<CaseOption> effect_rows() {
  return {{effect, "--flow", "flow.viscosity", "FLUID", "water",
           "fluid that leaks through the gap: water, air, or a\n"
           "viscosity, e.g. \"0.1 Pa s\"; the pressure drop is\n"
           "100 kPa or flow.pressure_drop"},
          {effect, "--work-of-adhesion", "halfspace.work_of_adhesion", "Q",
           "50 mJ/m^2",
           "of the faces of a half-space, e.g. \"50 mJ/m^2\"; a map\n"
           "is pressed and pulled off"},
          {effect, "--friction", "friction.coefficient", "X", "0.5",
           "coefficient of friction, for partial slip under the\n"
           "largest load"},
          {effect, "--hardness", "halfspace.hardness", "Q", "2 GPa",
           "largest contact pressure of the half-space and of\n"
           "the theory of a map, e.g. \"2 GPa\"",
           "theory.hardness"},
          {effect, "--thermal-conductivity", "conductance.thermal_conductivity",
           "Q", "0.2 W/(m K)",
           "of the block, e.g. \"0.2 W/(m K)\": heat through the\n"
           "contact"},
          {effect, "--counter-thermal-conductivity",
           "conductance.counter_thermal_conductivity", "Q", "16 W/(m K)",
           "of the body on it, e.g. \"16 W/(m K)\""},
          {effect, "--resistivity", "conductance.resistivity", "Q", "17 nOhm m",
           "of the block, e.g. \"17 nOhm m\": current through the\n"
           "contact"},
          {effect, "--counter-resistivity", "conductance.counter_resistivity",
           "Q", "24 nOhm m", "of the body on it, e.g. \"24 nOhm m\""}};
}

/// A word of a command line.
std::string word(const std::string& text) {
  return text.find(' ') == text.npos ? text : "\"" + text + "\"";
}

} // namespace

std::span<const CaseOption> case_options() {
  static const std::vector<CaseOption> rows = [] {
    std::vector<CaseOption> all = problem_rows();
    std::ranges::move(effect_rows(), std::back_inserter(all));
    return all;
  }();
  return rows;
}

std::string CaseOption::with(std::string_view text) const {
  return fmt::format("{} {}", name, word(std::string(text)));
}

std::string setting(std::string_view key, std::string_view value) {
  const std::span<const CaseOption> options = case_options();
  const auto option = std::ranges::find(options, key, &CaseOption::key);
  return option == options.end()
             ? "--set " + word(fmt::format("{}={}", key, value))
             : option->with(value);
}

} // namespace asperity::input
