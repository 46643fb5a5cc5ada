#include "run/arguments/physics.hpp"

#include "input/input_error.hpp"
#include "input/nearest.hpp"
#include "run/arguments/option_quantity.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>

namespace asperity::run {

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

} // namespace asperity::run
