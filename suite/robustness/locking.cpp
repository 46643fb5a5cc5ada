#include "suite/robustness/locking.hpp"

#include "input/reader/read_case.hpp"
#include "run/methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

/// Returns the compliance C of the wave [m/Pa] by each method of a case: the
/// displacement due to its own pressure, projected on the wave.
std::vector<double> compliances_of(const cases::Case& contact_case, int waves) {
  const methods::CaseSurfaces surfaces(contact_case, contact_case.methods);
  methods::MethodFactory factory(contact_case);
  const Grid& grid = surfaces.whole().front().record.grid;
  std::vector<double> wave(grid.size());
  for (std::size_t i = 0; i < wave.size(); ++i)
    wave[i] = std::cos(2.0 * std::numbers::pi * waves * static_cast<double>(i) /
                       grid.points_x);
  std::vector<double> compliances;
  for (const cases::MethodSpec& method : contact_case.methods) {
    const auto block = factory.operator_of(method, surfaces.of(method, 0), 1);
    std::vector<double> answer(grid.size());
    block->displacement(wave, answer);
    const std::span<const double> weights = block->nodal_weights();
    double moved = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < wave.size(); ++i) {
      const double weight = weights.empty() ? 1.0 : weights[i];
      moved += weight * wave[i] * answer[i];
      square += weight * wave[i] * wave[i];
    }
    compliances.push_back(moved / square);
  }
  return compliances;
}

} // namespace

std::vector<LockingRow> locking_table() {
  std::vector<LockingRow> rows;
  for (const double thickness : {1.0, 0.1})
    for (const int waves : {1, 4})
      for (const double poisson_ratio : {0.0, 0.3, 0.49, 0.4999}) {
        const std::vector<double> found = compliances_of(
            cases::read_case_text(
                fmt::format(
                    "schema = 1\ntitle = \"locking\"\n[surface]\nkind = "
                    "\"wave-2d\"\nlength = 1.0\npoints = 32\namplitude = "
                    "0.01\nwavelength = 1.0\n[material]\ncontact_modulus = "
                    "1e9\npoisson_ratio = {0}\n[load]\nnominal_pressure = "
                    "[\"0.1 E*\"]\n[halfspace]\ncontact = \"hard\"\nthickness "
                    "= {1:.1f}\n[fem]\nsolver = \"condensed\"\ncontact = "
                    "\"hard\"\ndepth = {1:.1f}\n[fem.q1]\nelement = "
                    "\"Q1\"\n[fem.q2]\nelement = \"Q2\"\n"
                    "surface_cell_depth = {2:.1f}\n",
                    poisson_ratio, thickness, std::min(1.0, 8.0 * thickness)),
                "locking.toml", {}),
            waves);
        rows.push_back({poisson_ratio, thickness, waves,
                        found.at(2) / found.at(0) - 1.0,
                        found.at(3) / found.at(0) - 1.0});
      }
  return rows;
}

} // namespace asperity::robustness
