#include "md/minimise/system.hpp"

namespace asperity::md {

LayerView layer_of(const System& system, std::span<const double> state) {
  const std::size_t n = system.layer().size();
  return {state.subspan(0, n), state.subspan(n, n), state.subspan(2 * n, n)};
}

std::vector<double> normal_forces(const System& system,
                                  std::span<const double> state) {
  const std::size_t n = system.layer().size();
  std::vector<double> x(n);
  std::vector<double> y(n);
  std::vector<double> z(n);
  system.interface().energy_and_forces(layer_of(system, state), {x, y, z});
  return z;
}

} // namespace asperity::md
