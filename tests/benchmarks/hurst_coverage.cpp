// Counts how many of the 95 % intervals that the analysis of a map states
// contain the exact value, over maps with blur and noise:
//
//   bench_hurst_coverage POINTS MAPS [all]   "all" prints each map
#include "surfaces/analysis/surface_analysis.hpp"
#include "tests/surfaces/instrument_maps.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace asperity::surfaces;

struct Count {
  int stated = 0;
  int contained = 0;

  /// A lower or an upper limit alone is an interval, too.
  void add(const FittedParameter& fitted, double exact) {
    if (std::isnan(fitted.low) && std::isnan(fitted.high))
      return;
    ++stated;
    contained += !(exact < fitted.low) && !(exact > fitted.high);
  }

  void print(const char* name) const {
    std::printf("  %-12s %d of %d\n", name, contained, stated);
  }
};

} // namespace

int main(int count, char** words) {
  if (count < 3)
    return 2;
  const int points = std::atoi(words[1]);
  const int maps = std::atoi(words[2]);
  Count hurst, roll_off, blur;
  int above_one = 0;
  for (int number = 0; number < maps; ++number) {
    const InstrumentMap exact = instrument_map(number, points);
    const MapAnalysis found =
        analyse_map(measured(exact), exact.is_periodic, {});
    if (!found.fit)
      continue;
    const SelfAffineFit& fit = *found.fit;
    const double pixel = found.map.grid.spacing_x();
    hurst.add(fit.hurst, exact.hurst);
    if (exact.roll_off > 1.0)
      roll_off.add(fit.roll_off,
                   exact.roll_off *
                       asperity::wavevector(1, found.map.grid.length_x));
    blur.add(fit.blur, exact.blur * pixel);
    above_one += fit.hurst.value > 1.0;
    if (count > 3)
      std::printf("%4d %s q0 %4.1f blur %.2f noise %.2f nm H %.3f: %.3f [%.3f, "
                  "%.3f] q1 %.2f s %.2f [%.2f %.2f] dispersion %.2f %s\n",
                  number, exact.is_periodic ? "periodic" : "windowed",
                  exact.roll_off, exact.blur, exact.noise * 1e9, exact.hurst,
                  -1.0 - 0.5 * fit.exponent, fit.hurst.low, fit.hurst.high,
                  fit.cutoff.value / found.spectrum.wavevector_high,
                  std::sqrt(fit.blur_square) / pixel, fit.blur.low / pixel,
                  fit.blur.high / pixel, fit.dispersion,
                  fit.hurst.reason.c_str());
  }
  std::printf(
      "%d x %d points, %d maps; intervals that contain the exact value, "
      "of those stated:\n",
      points, points, maps);
  hurst.print("H");
  roll_off.print("q_0");
  blur.print("blur");
  std::printf("  H above 1    %d\n", above_one);
}
