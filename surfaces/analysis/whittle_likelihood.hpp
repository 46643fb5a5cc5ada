#pragma once

// The likelihood of a self-affine spectrum with noise and its maximisation for
// a given cut-off. It is internal to self_affine_fit.

#include "surfaces/analysis/spectrum_estimate.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace asperity::surfaces {

/// ln of S at 1 rad/m extrapolated along the self-affine part, H, ln q_0 and
/// ln N: S(q) = exp(p[0]) max(q, q_0)^(-2 - 2 H).
using WhittleParameters = std::array<double, 4>;

using Covariance = std::array<std::array<double, 4>, 4>;

/// ln S(q).
double log_signal(const WhittleParameters& parameters, double wavevector);

/// A fit whose first `count` rings follow S + N; the other rings are free.
struct WhittlePart {
  std::size_t count = 0;
  WhittleParameters parameters{};
  double value = 0.0;  ///< minus the log-likelihood, up to a constant
  double beyond = 0.0; ///< the share of the other rings, each with the cost of
                       ///< its freedom
};

/// Fits the model by Fisher scoring from several starts.
/// @param start  one more start; if given, only starts near it are tried unless
///               count is a multiple of eight
WhittlePart fit_part(const std::vector<SpectrumRing>& rings, std::size_t count,
                     const std::optional<WhittleParameters>& start);

/// Fits the same rings without a roll-off.
WhittlePart without_roll_off(const std::vector<SpectrumRing>& rings,
                             const WhittlePart& part);

/// Deviance of the rings below the cut-off, joined to 15 per decade, over its
/// expected value [1].
double dispersion_of(const std::vector<SpectrumRing>& rings,
                     const WhittlePart& part);

/// Inverse Fisher information times `widening`; zero for parameters that are
/// not determined: the noise if it is negligible, and q_0 without a roll-off.
Covariance covariance_of(const std::vector<SpectrumRing>& rings,
                         const WhittlePart& part, bool has_roll_off,
                         double widening);

} // namespace asperity::surfaces
