#pragma once

// The surfaces a case needs, built once: heights, statistics, spectrum, and
// what the theory is given of them. Owns the decision not to build any.

#include "cases/types/case.hpp"
#include "results/types/result.hpp"
#include "theory/persson/height_spectrum.hpp"

#include <map>
#include <optional>
#include <vector>

namespace asperity::app {

/// The surface of one realisation as a method takes it.
struct SurfaceOfCase {
  results::SurfaceRecord record; ///< heights, statistics, C(q)
  cases::Scales scales;          ///< the yardsticks' values on it
};

/// True if one of the methods needs heights: all but a theory that takes
/// its spectrum from the formula.
bool needs_surfaces(const std::vector<cases::MethodSpec>& methods);

/// zeta q_0 [rad/m], above which the method's surface has no roughness; empty
/// where the method has no magnification.
std::optional<double> highest_wavevector(const cases::Case& rough_case,
                                         const cases::MethodSpec& method);

/// One surface a realisation, and one more for each magnification that a
/// method asks for.
class CaseSurfaces {
public:
  /// Builds those that the methods need, which may be none. The case must
  /// outlive this.
  /// @throws cases::CaseError, std::domain_error  what the surface room refuses
  CaseSurfaces(const cases::Case& rough_case,
               const std::vector<cases::MethodSpec>& methods);

  /// The surfaces with all of their roughness.
  const std::vector<SurfaceOfCase>& whole() const;

  const SurfaceOfCase& of(const cases::MethodSpec& method,
                          int realization) const;

  /// The statistics of a method's own surface; for a theory by the formula
  /// those that the formula gives, without heights.
  results::SurfaceRecord record_of(const cases::MethodSpec& method,
                                   int realization) const;

private:
  const cases::Case& case_;
  std::vector<SurfaceOfCase> whole_;
  std::map<double, std::vector<SurfaceOfCase>> magnified_;
};

/// The formula's spectrum for a theory, as far as its magnification shows it,
/// or the measured one of a surface.
theory::HeightSpectrum formula_of_case(const cases::Case& rough_case,
                                       const cases::MethodSpec& method);
theory::HeightSpectrum spectrum_of(const SurfaceOfCase& surface);

/// The yardsticks of a case that builds no surface; rms height by the formula,
/// spacing 0 where the case gives no points.
cases::Scales formula_scales(const cases::Case& rough_case,
                             const theory::HeightSpectrum& spectrum);

} // namespace asperity::app
