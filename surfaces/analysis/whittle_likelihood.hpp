#pragma once

// The likelihood of a self-affine spectrum with blur and noise and its
// maximisation for a given cut-off. It is internal to self_affine_fit.

#include "surfaces/analysis/spectrum_estimate.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace asperity::surfaces {

/// ln of the self-affine part at 1 rad/m, H, ln q_0, ln N and the square of the
/// blur s [m^2]: S(q) = exp(p[0]) max(q, q_0)^(-2 - 2 H) exp(-p[4] q^2).
constexpr std::size_t whittle_parameters = 5;
constexpr std::size_t amplitude_at = 0, hurst_at = 1, corner_at = 2,
                      noise_at = 3, blur_at = 4;
using WhittleParameters = std::array<double, whittle_parameters>;

using Covariance =
    std::array<std::array<double, whittle_parameters>, whittle_parameters>;

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

/// Deviance of the rings below the cut-off, joined to 15 per decade.
struct Dispersion {
  double value = 1.0; ///< over its expected value [1]
  double limit = 1.0; ///< which rings of the model exceed once in a thousand
                      ///< maps [1]
};

Dispersion dispersion_of(const std::vector<SpectrumRing>& rings,
                         const WhittlePart& part);

/// Inverse Fisher information times `widening`, for N in units of the smallest
/// ring in the place of ln N; zero for q_0 without a roll-off. Noise and blur
/// count also where the most likely one is 0: a map excludes neither exactly,
/// and each changes H.
Covariance covariance_of(const std::vector<SpectrumRing>& rings,
                         const WhittlePart& part, bool has_roll_off,
                         double widening);

} // namespace asperity::surfaces
