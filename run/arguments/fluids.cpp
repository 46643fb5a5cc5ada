#include "run/arguments/fluids.hpp"

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
  (void)positive_quantity("--flow", viscosity, cases::Dimension::viscosity);
  return {"flow.viscosity=\"" + viscosity + "\"",
          "flow.pressure_drop=\"100 kPa\""};
}

} // namespace asperity::run
