#include "tests/theory/two_bodies.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace asperity::theory {

double contact_modulus(const ElasticBody& body) {
  require_positive("youngs_modulus", body.youngs_modulus, "Pa");
  require_between("poisson_ratio", body.poisson_ratio, -1.0, 0.5, "1");
  const double nu = body.poisson_ratio;
  if (nu == -1.0)
    refuse_argument("poisson_ratio", nu, "above -1 and at most 0.5 [1]");
  return body.youngs_modulus / ((1.0 - nu) * (1.0 + nu));
}

double combined_contact_modulus(const ElasticBody& first,
                                const ElasticBody& second) {
  return 1.0 / (1.0 / contact_modulus(first) + 1.0 / contact_modulus(second));
}

HeightSpectrum combined_spectrum(const HeightSpectrum& first,
                                 const HeightSpectrum& second) {
  if (first.has_density() != second.has_density())
    refuse_argument("number of formulas", 1.0, "0 or 2 of the two spectra");
  if (!first.has_density()) {
    std::vector<SpectrumShell> shells(first.shells().begin(),
                                      first.shells().end());
    shells.insert(shells.end(), second.shells().begin(), second.shells().end());
    return HeightSpectrum(std::move(shells));
  }
  std::vector<double> breaks(first.breaks().begin(), first.breaks().end());
  breaks.insert(breaks.end(), second.breaks().begin(), second.breaks().end());
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return HeightSpectrum(SpectrumFormula{[first, second](double q) {
                                          return first.density(q) +
                                                 second.density(q);
                                        },
                                        std::move(breaks)});
}

} // namespace asperity::theory
