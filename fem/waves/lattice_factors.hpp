#pragma once

// The factors of a laterally uniform block's stiffness, one small
// block-tridiagonal problem a lateral wavevector, four of them at a time.

#include "fem/waves/elastic_layers.hpp"
#include "fem/waves/kind_spectra.hpp"
#include "fem/waves/lattice_share.hpp"

#include <cstddef>
#include <memory>

namespace asperity::fem {

/// K(q) w = g by elimination from the top down to the contact face, with u_x =
/// i w_x, u_y = i w_y. Layer l has the planes b below it and g, all others up
/// to its top:
///
///     G_l = S_gg + T_(l+1) on its top plane = L D L^T,                 (L.1)
///     R_l = L^-1 S_gb,   T_l = S_bb - R_l^T D^-1 R_l,
///     down:  g_g <- L^-1 g_g,   g_b <- g_b - R_l^T D^-1 g_g,           (L.2)
///     up:    w_g = L^-T D^-1 (g_g - R_l w_b),                          (L.3)
///
/// which is (Q1.1) and (Q2.2) with the right-hand side. T is 0 above a free
/// top; held components of the top have rows of the identity. At q = 0 the
/// uniform modes of a top's free components have a spring: loads that balance
/// do not stretch it.
///
/// Values of a batch are rows (plane, kind, component) from the contact face
/// up, 3 kind + component within a plane, of wave_columns columns.
class LatticeFactors {
public:
  virtual ~LatticeFactors() = default;

  /// Memory of the factors [B].
  virtual std::size_t bytes() const = 0;

  /// (L.2) of all layers.
  virtual void go_down(const WaveBatch& batch, Pack* values) const = 0;
  /// w = T_0^-1 g of the contact face's rows alone.
  virtual void solve_face(const WaveBatch& batch, Pack* values) const = 0;
  /// (L.3) of all layers, the face's rows being w already.
  virtual void go_up(const WaveBatch& batch, Pack* values) const = 0;

  /// (T_0^-1)_zz over the kinds, full [m/N]; kinds^2 packs.
  virtual void face_compliance(const WaveBatch& batch, Pack* block) const = 0;
};

/// Whether the top holds component 0..2 of the displacement at 0.
inline bool holds(cases::TopFace top, std::size_t component) {
  return top == cases::TopFace::clamped ||
         (top == cases::TopFace::sliding && component == 2);
}

/// @param degree  1 or 2
/// @param rows    of |jy| whose batches there will be factors of
/// @param threads changes no bit
std::unique_ptr<const LatticeFactors>
make_lattice_factors(const KindSpectra& spectra, int degree,
                     const LayeredBlock& block, Range rows, int threads);

} // namespace asperity::fem
