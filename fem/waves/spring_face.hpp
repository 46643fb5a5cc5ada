#pragma once

// Forces of springs on the contact surface of a uniform block. This file stores
// the compliance of the surface as a symbol over node classes.

#include "fem/waves/lattice_factors.hpp"
#include "fem/waves/spring_solve.hpp"

#include <complex>
#include <span>
#include <vector>

namespace asperity::fem {

/// Solves (L.4) with one force per node with a spring. If the far boundary lets
/// the block shift freely in z, the sum of the forces is prescribed, and (L.4)
/// holds up to a uniform displacement, the shift:
///
///     (D^-1 + C_0) q = u_0 + shift,   sum_i q_i = F.                   (L.5)
class SpringFace {
public:
  /// @param spectra         must outlive this object
  /// @param factors, share  must refer to the same rows; every rank gets the
  ///                        complete surface
  /// @param shifts_freely   whether the far boundary is free in z
  SpringFace(const NodeClassSpectra& spectra, const LatticeFactors& factors,
             const LatticeShare& share, bool shifts_freely, int threads);

  /// @param springs  spectra.grid().size() values [N/m], 0 to infinity
  void set_springs(std::span<const double> springs);

  bool is_empty() const { return nodes_.empty(); }

  std::size_t bytes() const; ///< of symbols and vectors

  /// @param free_displacement  u_0 [m], grid().size() values
  /// @param total_force        F [N]; read only if the block shifts freely
  /// @param tolerance          relative, as in LatticeSolver
  /// @param forces             q [N], overwritten; 0 without a spring
  /// @param shift              [m]; 0 unless the block shifts freely
  SpringSolve solve(std::span<const double> free_displacement,
                    double total_force, double tolerance,
                    std::span<double> forces, double& shift);

private:
  using Symbol = std::vector<SimdBatch>; ///< node_classes^2 packs per batch

  void invert(std::span<const double> local_compliance);
  void apply(const Symbol& symbol, std::span<const double> field,
             std::span<double> result);
  /// Computes (D^-1 + C_0) d on the nodes with springs and 0 elsewhere.
  void compliance(std::span<const double> d, std::span<double> result);
  /// Applies the preconditioner: restricted to the nodes with springs, and with
  /// sum 0 if the block shifts freely.
  void estimate(std::span<const double> residual, std::span<double> result);
  void remove_mean(std::span<double> field) const;
  double dot(std::span<const double> a, std::span<const double> b) const;

  const NodeClassSpectra& spectra_;
  bool shifts_freely_;
  int threads_;
  Symbol compliance_, inverse_;
  std::vector<std::size_t> nodes_; ///< nodes with a spring, increasing
  std::vector<double> local_;      ///< 1/d of each of them [m/N]
  std::vector<double> of_ones_;    ///< preconditioner applied to ones [N/m]
  double sum_of_ones_ = 0.0;       ///< its sum
  std::vector<std::complex<double>> modes_;
  std::vector<double> scratch_, whole_, r_, z_, d_, cd_;
};

} // namespace asperity::fem
