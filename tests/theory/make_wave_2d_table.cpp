// Prints theory/exact/wave_2d_table.cpp. Build make_wave_2d_table in the
// release preset (it takes minutes), then
//
//     make_wave_2d_table > theory/exact/wave_2d_table.cpp
//
// With the argument "check" it solves between the rows instead and prints the
// difference of Wave2dContact from these solutions.
#include "tests/theory/wave_2d_solution.hpp"
#include "theory/exact/wave_2d.hpp"
#include "theory/exact/wave_2d_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace asperity::theory {
namespace {

constexpr int fine = 512, n_offsets = 8;

std::vector<Wave2dSolution> limits(const std::vector<double>& pressures) {
  const auto coarse_means = solve_wave_2d(pressures, fine / 2, n_offsets);
  std::vector<Wave2dSolution> means = solve_wave_2d(pressures, fine, n_offsets);
  for (std::size_t k = 0; k < means.size(); ++k)
    means[k] = extrapolated(coarse_means[k], means[k]);
  return means;
}

// Equal steps of (p/p*)^{2/3}, and finer ones where neighbouring contact spots
// merge and the area has a steep, singular slope.
std::vector<double> loads_of_rows() {
  std::vector<double> loads;
  for (int k = 1; k < 40; ++k)
    loads.push_back(k / 40.0);
  for (const double load : {0.355, 0.36, 0.365, 0.37, 0.3725, 0.3775, 0.38,
                            0.385, 0.39, 0.395, 0.4125})
    loads.push_back(load);
  std::sort(loads.begin(), loads.end());
  return loads;
}

std::vector<double> pressures_of(const std::vector<double>& loads) {
  std::vector<double> pressures;
  for (const double load : loads)
    pressures.push_back(std::pow(load, 1.5));
  return pressures;
}

void print_table() {
  std::puts("// Printed by tests/theory/make_wave_2d_table.cpp: do not edit.\n"
            "#include \"theory/exact/wave_2d_table.hpp\"\n\n"
            "namespace asperity::theory {\n\n"
            "const std::array<Wave2dRow, n_wave_2d_rows> wave_2d_table{{");
  const std::vector<double> loads = loads_of_rows();
  const std::vector<Wave2dSolution> rows = limits(pressures_of(loads));
  for (std::size_t k = 0; k < rows.size(); ++k)
    std::printf("    {%.4f, %.6f, %.9f},\n", loads[k], rows[k].area_fraction,
                rows[k].mean_gap);
  std::puts("}};\n\n} // namespace asperity::theory");
}

void check_between_rows() {
  const double pi = std::numbers::pi;
  const Wave2dContact wave(1.0, 1.0,
                           1.0 / (std::numbers::sqrt2 * pi)); // p* = 1
  std::vector<double> loads = loads_of_rows();
  loads.insert(loads.begin(), 0.0);
  loads.push_back(1.0);
  for (std::size_t k = 0; k + 1 < loads.size(); ++k)
    loads[k] = 0.5 * (loads[k] + loads[k + 1]);
  loads.pop_back();
  const std::vector<double> pressures = pressures_of(loads);
  const std::vector<Wave2dSolution> found = limits(pressures);
  for (std::size_t k = 0; k < found.size(); ++k)
    std::printf("p/p* %.5f  area %.6f %+.1e  gap %.9f %+.1e  energy %+.1e\n",
                pressures[k], found[k].area_fraction,
                wave.area_fraction(pressures[k]) - found[k].area_fraction,
                found[k].mean_gap,
                wave.mean_gap(pressures[k]) - found[k].mean_gap,
                wave.elastic_energy(pressures[k]) - found[k].energy);
}

} // namespace
} // namespace asperity::theory

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "check")
    asperity::theory::check_between_rows();
  else
    asperity::theory::print_table();
}
