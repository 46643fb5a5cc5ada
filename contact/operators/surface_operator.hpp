#pragma once

// The interface between the contact solvers and the elastic models: a pressure
// on a surface gives the displacement of that surface. Finite elements,
// half-space and atomic lattice each implement it.

#include "base/grid.hpp"
#include "contact/operators/tiles.hpp"
#include "ranks/workers.hpp"

#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace asperity::contact {

/// Every second node of a grid in both directions, for a coarse-to-fine initial
/// guess; none if a number of points is odd or less than 64.
inline std::optional<Grid> coarse_grid(const Grid& fine) {
  if (fine.points_x % 2 != 0 || fine.points_y % 2 != 0 || fine.points_x < 64 ||
      fine.points_y < 64)
    return std::nullopt;
  return Grid{fine.points_x / 2, fine.points_y / 2, fine.length_x,
              fine.length_y};
}

/// A linear, symmetric surface compliance, positive definite on fields of zero
/// mean.
///
/// Sign and gauge: `pressure` >= 0 pushes the block away from the rigid
/// counter-surface; `displacement` is positive in the same direction. On a
/// periodic surface the mean of the displacement, weighted by nodal_weights(),
/// is removed, so that the mean gap equals the separation of the mean planes.
/// On a surface with free boundaries the displacement vanishes at infinity, and
/// only loads by pressure can be prescribed: a prescribed mean gap would not be
/// the minimum of an energy.
/// Symmetry means: sum_i weight_i p_i (C q)_i = sum_i weight_i (C p)_i q_i.
///
/// The methods are not const because operators own scratch memory: use one
/// instance per thread. clone() shares the immutable data and has its own
/// scratch memory.
class SurfaceOperator {
public:
  virtual ~SurfaceOperator() = default;
  virtual std::unique_ptr<SurfaceOperator> clone() const = 0;

  virtual const Grid& grid() const = 0;

  /// The rows of the grid that this process holds, if several ranks share them;
  /// null if it holds all. All fields have the nodes of these rows only, and
  /// the calls that transform fields are collective.
  virtual const SharedRows* shared_rows() const { return nullptr; }

  /// The rows that this process holds.
  SharedRows rows() const {
    return shared_rows() != nullptr ? *shared_rows() : SharedRows(grid());
  }

  /// Number of nodes that this process holds.
  std::size_t n_nodes() const {
    return shared_rows() != nullptr ? shared_rows()->size() : grid().size();
  }

  /// Whether the surface continues periodically; otherwise it is pressed inside
  /// the rectangle of the grid only, and its displacement vanishes at infinity.
  virtual bool is_periodic() const { return true; }

  /// Area of each node relative to the mean area; empty if all are equal.
  virtual std::span<const double> nodal_weights() const = 0;

  /// Computes displacement = C pressure [m]; if it is periodic, without its
  /// mean.
  /// @param pressure     n_nodes() values [Pa]
  /// @param displacement n_nodes() values, overwritten
  virtual void displacement(std::span<const double> pressure,
                            std::span<double> displacement) = 0;

  /// The same for a small change of pressure, in single precision: the error is
  /// about 1e-7 of the change.
  virtual void displacement_change(std::span<const float> pressure_change,
                                   std::span<float> displacement_change) = 0;

  /// Computes pressure = (C + 1/penalty)^-1 gap [Pa] on the whole surface, for
  /// use as a preconditioner. It is exact up to single precision and up to the
  /// mean of the result, which may be any bounded value.
  /// @param local_compliance  1/penalty [m/Pa] >= 0; 0 for hard contact
  virtual void pressure_estimate(std::span<const float> gap,
                                 double local_compliance,
                                 std::span<float> pressure) = 0;

  /// Whether pressure_of() is there: C has an exact inverse.
  virtual bool has_inverse() const { return false; }

  /// Computes pressure = C^-1 displacement [Pa], both without their means.
  /// @param displacement  n_nodes() values [m]; its mean is ignored
  /// @param pressure      n_nodes() values of mean 0, overwritten; the two
  ///                      fields may be one
  /// @throws std::logic_error  there is no inverse
  virtual void pressure_of(std::span<const double> displacement,
                           std::span<double> pressure);

  /// The grid of a periodic surface that contains this one, for the
  /// preconditioner: grid() if it is periodic itself, otherwise a grid of more
  /// points, whose first columns and rows are the nodes of grid().
  virtual const Grid& wide_grid() const { return grid(); }

  /// As pressure_estimate(), on the surface of wide_grid(), whose C is about
  /// the same between the nodes of grid(). The two fields may be one.
  virtual void wide_pressure_estimate(std::span<const float> gap,
                                      double local_compliance,
                                      std::span<float> pressure) {
    pressure_estimate(gap, local_compliance, pressure);
  }

  /// C at half the Nyquist wavevector [m/Pa]: the local compliance of a node
  /// for pressures that vary on the scale of the grid.
  virtual double short_wave_compliance() const = 0;

  /// Whether a pressure that is shifted by nodes has the same displacement,
  /// shifted: one column then stands for all.
  virtual bool is_shift_invariant() const { return false; }

  /// Number of threads that each application uses, and the contact solver with
  /// it.
  virtual int threads() const { return 1; }

  /// Threads and ranks, for sums over the nodes.
  Workers workers() const { return {threads(), shared_rows()}; }

  /// If the surface is not periodic: a periodic one on twice as many points and
  /// lengths in both directions, which has an exact inverse. The first columns
  /// and rows are the nodes of grid(), where a pressure that is 0 elsewhere has
  /// the displacement of this operator up to a constant. Null if the surface is
  /// periodic.
  virtual std::unique_ptr<SurfaceOperator> periodic_extension() const {
    return nullptr;
  }

  /// The operator of the same block on a coarse_grid(); null if there is none,
  /// or if ranks share the rows.
  virtual std::unique_ptr<SurfaceOperator> coarsened() const { return nullptr; }

  /// An approximation of the operator between the nodes of some tiles; null if
  /// there is none, or if ranks share the rows. Its grid has the tiles one
  /// below the other. The displacement has another mean.
  virtual std::unique_ptr<SurfaceOperator>
  on_tiles(const Tiles& /*tiles*/) const {
    return nullptr;
  }
};

inline void SurfaceOperator::pressure_of(std::span<const double>,
                                         std::span<double>) {
  throw std::logic_error("this surface operator has no exact inverse");
}

} // namespace asperity::contact
