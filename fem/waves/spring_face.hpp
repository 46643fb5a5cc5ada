#pragma once

// Springs under the contact face of a uniform block: which forces they bear.
// Owns the face's compliance as a symbol over kinds of nodes.

#include "fem/waves/lattice_factors.hpp"
#include "fem/waves/spring_solve.hpp"

#include <complex>
#include <span>
#include <vector>

namespace asperity::fem {

/// (L.4), one force a node with a spring. Under a top that lets the block
/// shift freely in z the forces have a prescribed sum, and (L.4) holds up to a
/// uniform displacement, which is the shift:
///
///     (D^-1 + C_0) q = u_0 + shift,   sum_i q_i = F.                   (L.5)
class SpringFace {
public:
  /// @param spectra  outlives this
  /// @param factors, share    of the same rows; every rank gets the whole face
  /// @param shifts_freely     whether the top is free in z
  SpringFace(const KindSpectra& spectra, const LatticeFactors& factors,
             const LatticeShare& share, bool shifts_freely, int threads);

  /// @param springs  spectra.grid().size() values [N/m], 0 to infinity
  void set_springs(std::span<const double> springs);

  bool is_empty() const { return nodes_.empty(); }

  std::size_t bytes() const; ///< of symbols and vectors

  /// @param free_displacement  u_0 [m], grid().size() values
  /// @param total_force        F [N]; read if the block shifts freely
  /// @param tolerance          relative, as LatticeSolver's
  /// @param forces             q [N], overwritten; 0 without a spring
  /// @param shift              [m]; 0 unless the block shifts freely
  SpringSolve solve(std::span<const double> free_displacement,
                    double total_force, double tolerance,
                    std::span<double> forces, double& shift);

private:
  using Symbol = std::vector<Pack>; ///< kinds^2 packs a batch

  void invert(std::span<const double> local_compliance);
  void apply(const Symbol& symbol, std::span<const double> field,
             std::span<double> result);
  /// (D^-1 + C_0) d on the nodes with springs, 0 elsewhere.
  void compliance(std::span<const double> d, std::span<double> result);
  /// Preconditioner: masked, and of sum 0 if the block shifts freely.
  void estimate(std::span<const double> residual, std::span<double> result);
  void remove_mean(std::span<double> field) const;
  double dot(std::span<const double> a, std::span<const double> b) const;

  const KindSpectra& spectra_;
  bool shifts_freely_;
  int threads_;
  Symbol compliance_, inverse_;
  std::vector<std::size_t> nodes_; ///< with a spring, increasing
  std::vector<double> local_;      ///< 1/d of each of them [m/N]
  std::vector<double> of_ones_;    ///< the estimate of 1 [N/m]
  double sum_of_ones_ = 0.0;       ///< its sum
  std::vector<std::complex<double>> modes_;
  std::vector<double> scratch_, whole_, r_, z_, d_, cd_;
};

} // namespace asperity::fem
