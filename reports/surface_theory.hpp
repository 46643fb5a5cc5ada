#pragma once

// Persson's theory of the very surface a method ran on, for the fit of gamma.

#include "reports/fits.hpp"

namespace asperity::reports {

/// u(p) of (14) for gamma = 1 and 0, from the exact spectrum of the heights
/// (no binning: one shell a length of wavevector). Empty if the heights were
/// not kept.
GapTheory theory_of_surface(const results::SurfaceRecord& surface,
                            double contact_modulus);

} // namespace asperity::reports
