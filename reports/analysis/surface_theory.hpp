#pragma once

// Persson's theory of the very surface a method ran on, for the fit of gamma.

#include "cases/types/case.hpp"
#include "reports/numbers/fits.hpp"

#include <optional>

namespace asperity::reports {

/// What fits need of the theory of one surface. Empty `gap`: the theory of
/// this surface cannot be had.
struct SurfaceTheory {
  GapTheory gap;                      ///< u(p) of (14) for gamma = 1 and 0
  double decay_length = not_a_number; ///< u_0 of (18) at gamma = 1 [m]; u_0 is
                                      ///< proportional to gamma
};

/// From the spectrum of the heights, a shell a length of wavevector: lengths
/// within 1e-6 of each other are one. Empty if the heights were not kept.
SurfaceTheory theory_of_surface(const results::SurfaceRecord& surface,
                                double contact_modulus);

/// From the formula of a self-affine case, of the roughness up to `highest`
/// [rad/m] where that is given; empty for other kinds.
SurfaceTheory theory_of_formula(const cases::SurfaceSpec& surface,
                                double contact_modulus,
                                std::optional<double> highest = {});

} // namespace asperity::reports
