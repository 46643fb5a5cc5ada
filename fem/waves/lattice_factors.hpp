#pragma once

// Factorisation of the stiffness of a laterally uniform block: one small
// block-tridiagonal problem per lateral wavevector, four wavevectors at a time.

#include "fem/waves/elastic_layers.hpp"
#include "fem/waves/kind_spectra.hpp"
#include "fem/waves/lattice_share.hpp"

#include <cstddef>
#include <memory>

namespace asperity::fem {

/// Solves K(q) w = g by elimination from the far boundary down to the contact
/// surface, with u_x = i w_x and u_y = i w_y. For layer l, b denotes the plane
/// below it and g all other planes up to its top:
///
///     G_l = S_gg + T_(l+1) on its top plane = L D L^T,                 (L.1)
///     R_l = L^-1 S_gb,   T_l = S_bb - R_l^T D^-1 R_l,
///     down:  g_g <- L^-1 g_g,   g_b <- g_b - R_l^T D^-1 g_g,           (L.2)
///     up:    w_g = L^-T D^-1 (g_g - R_l w_b),                          (L.3)
///
/// which is (Q1.1) and (Q2.2) with the right-hand side included. T is 0 above a
/// free far boundary; components held on the far boundary have rows of the
/// identity. At q = 0 the uniform modes of the free components of the far
/// boundary have a spring, which balanced loads do not stretch.
///
/// The values of a batch are rows (plane, kind, component) from the contact
/// surface upwards, with row 3 kind + component within a plane, of wave_columns
/// columns.
class LatticeFactors {
public:
  virtual ~LatticeFactors() = default;

  /// Memory of the factors [bytes].
  virtual std::size_t bytes() const = 0;

  /// Applies (L.2) to all layers.
  virtual void go_down(const WaveBatch& batch, SimdBatch* values) const = 0;
  /// Computes w = T_0^-1 g in the rows of the contact surface only.
  virtual void solve_face(const WaveBatch& batch, SimdBatch* values) const = 0;
  /// Applies (L.3) to all layers; the rows of the contact surface must already
  /// hold w.
  virtual void go_up(const WaveBatch& batch, SimdBatch* values) const = 0;

  /// Computes (T_0^-1)_zz over the node classes, all entries [m/N]; kinds^2
  /// packs.
  virtual void face_compliance(const WaveBatch& batch,
                               SimdBatch* block) const = 0;
};

/// Whether the far boundary fixes component 0..2 of the displacement to 0.
inline bool holds(mechanics::FarBoundary top, std::size_t component) {
  return top == mechanics::FarBoundary::clamped ||
         (top == mechanics::FarBoundary::sliding && component == 2);
}

/// @param degree   1 or 2
/// @param rows     rows of |jy| for whose batches factors are computed
/// @param threads  the result is bitwise independent of it
std::unique_ptr<const LatticeFactors>
make_lattice_factors(const KindSpectra& spectra, int degree,
                     const LayeredBlock& block, Range rows, int threads);

} // namespace asperity::fem
