#pragma once

// Factorisation of the stiffness of a laterally uniform block: one small
// block-tridiagonal problem per lateral wavevector, four wavevectors at a time.

#include "fem/waves/elastic_layers.hpp"
#include "fem/waves/lattice_share.hpp"
#include "fem/waves/node_class_spectra.hpp"

#include <cstddef>
#include <memory>

namespace asperity::fem {

/// Solves K(q) w = g, with u_x = i w_x and u_y = i w_y, by the factors of
/// LayerElimination:
///
///     down:  g_g <- L^-1 g_g,   g_b <- g_b - R_l^T D^-1 g_g,           (L.2)
///     up:    w_g = L^-T D^-1 (g_g - R_l w_b).                          (L.3)
///
/// At q = 0 the uniform modes of the free components of the far boundary have a
/// spring, which balanced loads do not stretch.
///
/// The values of a batch are rows (plane, node class, component) from the
/// contact surface upwards, with row 3 node_class + component within a plane,
/// of wave_columns columns.
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

  /// Computes (T_0^-1)_zz over the node classes, all entries [m/N];
  /// node_classes^2 packs.
  virtual void face_compliance(const WaveBatch& batch,
                               SimdBatch* block) const = 0;
};

/// @param degree   1 or 2
/// @param rows     rows of |jy| for whose batches factors are computed
/// @param threads  the result is bitwise independent of it
std::unique_ptr<const LatticeFactors>
make_lattice_factors(const NodeClassSpectra& spectra, int degree,
                     const LayeredBlock& block, Range rows, int threads);

} // namespace asperity::fem
