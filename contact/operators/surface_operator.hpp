#pragma once

// The interface between the contact solvers and the elastic models: a pressure
// on a surface gives the displacement of that surface. Finite elements and
// half-space each implement it.

#include "base/grid.hpp"
#include "base/ranks/workers.hpp"
#include "contact/operators/tiles.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

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

/// What the solvers know of a surface operator C besides its applications.
struct SurfaceTraits {
  /// The grid, and the rows of it that this process holds. If ranks share them,
  /// all fields have the nodes of these rows only, and the calls that transform
  /// fields are collective.
  SharedRows rows;
  /// C at half the Nyquist wavevector [m/Pa]: the local compliance of a node
  /// for pressures that vary on the scale of the grid.
  double short_wave_compliance = 0.0;
  /// Number of threads that each application uses, and the contact solver with
  /// it.
  int threads = 1;
  /// Whether the surface continues periodically; otherwise it is pressed inside
  /// the rectangle of the grid only, and its displacement vanishes at infinity.
  bool is_periodic = true;
  /// Whether it continues by mirror images instead: see MirroredOperator.
  bool is_mirrored = false;
  /// Whether a pressure that is shifted by nodes has the same displacement,
  /// shifted: one column then stands for all.
  bool is_shift_invariant = false;
  bool has_inverse = false; ///< whether pressure_of() is there
  /// Area of each node relative to the mean area; empty if all are equal. The
  /// memory is that of the operator.
  std::span<const double> nodal_weights = {};
  /// The grid of a periodic surface that contains one with free boundaries, for
  /// the preconditioner: its first columns and rows are the nodes of the grid.
  /// None: the grid itself.
  std::optional<Grid> wide_grid = std::nullopt;
};

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
/// An operator has its traits, do_clone() and do_displacement(); the rest has
/// defaults with which the solvers work, more slowly or not by all ways
/// (docs/extending.md). The public calls can measure their CPU time.
///
/// The methods are not const because operators own scratch memory: use one
/// instance per thread. clone() shares the immutable data and has its own
/// scratch memory.
class SurfaceOperator {
public:
  virtual ~SurfaceOperator() = default;

  std::unique_ptr<SurfaceOperator> clone() const { return timed(do_clone()); }

  const Grid& grid() const { return traits_.rows.grid(); }

  /// The rows that this process holds.
  const SharedRows& rows() const { return traits_.rows; }

  /// The same if several ranks share the grid; null if it holds all.
  const SharedRows* shared_rows() const {
    return traits_.rows.ranks() != nullptr ? &traits_.rows : nullptr;
  }

  /// Number of nodes that this process holds.
  std::size_t n_nodes() const { return traits_.rows.size(); }

  bool is_periodic() const { return traits_.is_periodic; }

  bool is_mirrored() const { return traits_.is_mirrored; }

  std::span<const double> nodal_weights() const {
    return traits_.nodal_weights;
  }

  double short_wave_compliance() const { return traits_.short_wave_compliance; }

  bool is_shift_invariant() const { return traits_.is_shift_invariant; }

  bool has_inverse() const { return traits_.has_inverse; }

  int threads() const { return traits_.threads; }

  /// See SurfaceTraits.
  const Grid& wide_grid() const {
    return traits_.wide_grid ? *traits_.wide_grid : grid();
  }

  /// Threads and ranks, for sums over the nodes.
  Workers workers() const { return {threads(), shared_rows()}; }

  /// Computes displacement = C pressure [m]; if it is periodic, without its
  /// mean.
  /// @param pressure     n_nodes() values [Pa]
  /// @param displacement n_nodes() values, overwritten
  /// @param lent         memory that the call may use in place of its own, as
  ///                     much as that of the displacement
  void displacement(std::span<const double> pressure,
                    std::span<double> displacement,
                    std::span<std::byte> lent = {});

  /// The same for a small change of pressure, in single precision: the error is
  /// about 1e-7 of the change. The memory that is lent may be that of the
  /// change, which is then lost.
  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change,
                           std::span<std::byte> lent = {});

  /// Computes pressure = (C + 1/penalty)^-1 gap [Pa] on the whole surface, for
  /// use as a preconditioner. It is exact up to single precision and up to the
  /// mean of the result, which may be any bounded value; the default has
  /// short_wave_compliance() in place of C.
  /// @param gap       n_nodes() values, or those of wide_grid(), on whose
  ///                  surface C is about the same between the nodes of grid()
  /// @param local_compliance  1/penalty [m/Pa] >= 0; 0 for hard contact
  /// @param pressure  as many values; may be `gap`
  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure);

  /// Computes pressure = C^-1 displacement [Pa], both without their means.
  /// @param displacement  n_nodes() values [m]; its mean is ignored
  /// @param pressure      n_nodes() values of mean 0, overwritten; the two
  ///                      fields may be one
  /// @throws std::logic_error  there is no inverse
  void pressure_of(std::span<const double> displacement,
                   std::span<double> pressure);

  /// If the surface is not periodic: a periodic one on twice as many points and
  /// lengths in both directions, which has an exact inverse. The first columns
  /// and rows are the nodes of grid(), where a pressure that is 0 elsewhere has
  /// the displacement of this operator up to a constant. Null if the surface is
  /// periodic.
  std::unique_ptr<SurfaceOperator> periodic_extension() const {
    return timed(do_periodic_extension());
  }

  /// The operator between fields that equal their mirror images about the
  /// middle lines of grid(), on quarter_of(grid()); null if there is none, or
  /// if ranks share the rows.
  std::unique_ptr<SurfaceOperator> mirrored() const {
    return timed(do_mirrored());
  }

  /// The operator of the same block on a coarse_grid(); null if there is none,
  /// or if ranks share the rows.
  std::unique_ptr<SurfaceOperator> coarsened() const {
    return timed(do_coarsened());
  }

  /// An approximation of the operator between the nodes of some tiles; null if
  /// there is none, or if ranks share the rows. Its grid has the tiles one
  /// below the other. The displacement has another mean.
  std::unique_ptr<SurfaceOperator> on_tiles(const Tiles& tiles) const {
    return timed(do_on_tiles(tiles));
  }

  /// Adds the CPU time [s] of all applications to a number, also that of the
  /// operators that are made from this one afterwards. The number belongs to
  /// one solver and its thread.
  void measure(std::shared_ptr<double> cpu_time) {
    cpu_time_ = std::move(cpu_time);
  }

protected:
  explicit SurfaceOperator(SurfaceTraits traits) : traits_(std::move(traits)) {}

  SurfaceOperator(const SurfaceOperator&) = default;
  SurfaceOperator(SurfaceOperator&&) = default;
  SurfaceOperator& operator=(const SurfaceOperator&) = default;
  SurfaceOperator& operator=(SurfaceOperator&&) = default;

  /// Memory that do_displacement() and do_displacement_change() may use.
  std::span<std::byte> lent() const { return lent_; }

  virtual std::unique_ptr<SurfaceOperator> do_clone() const = 0;
  virtual void do_displacement(std::span<const double> pressure,
                               std::span<double> displacement) = 0;
  /// In double precision, if nothing else is given.
  virtual void do_displacement_change(std::span<const float> pressure_change,
                                      std::span<float> displacement_change);
  virtual void do_pressure_estimate(std::span<const float> gap,
                                    double local_compliance,
                                    std::span<float> pressure);
  virtual void do_pressure_of(std::span<const double> displacement,
                              std::span<double> pressure);

  virtual std::unique_ptr<SurfaceOperator> do_periodic_extension() const {
    return nullptr;
  }

  virtual std::unique_ptr<SurfaceOperator> do_mirrored() const {
    return nullptr;
  }

  virtual std::unique_ptr<SurfaceOperator> do_coarsened() const {
    return nullptr;
  }

  virtual std::unique_ptr<SurfaceOperator>
  do_on_tiles(const Tiles& /*tiles*/) const {
    return nullptr;
  }

private:
  /// Another operator, which adds to the same number; null for null.
  std::unique_ptr<SurfaceOperator>
  timed(std::unique_ptr<SurfaceOperator> other) const {
    if (other && cpu_time_)
      other->measure(cpu_time_);
    return other;
  }

  /// Does some work, and measures it if that is wanted.
  template <class Work>
  void measured(const Work& work);

  SurfaceTraits traits_;
  std::shared_ptr<double> cpu_time_; ///< null: not measured
  std::span<std::byte> lent_;        ///< for the call that is made
};

} // namespace asperity::contact
