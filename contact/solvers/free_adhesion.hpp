#pragma once

// Adhesive contact of a surface with free boundaries, as one of a periodic
// surface that has a counter-surface on a part of it.

#include "contact/solvers/adhesive.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asperity::contact {

/// Adhesive problems of one surface whose compliance A is not periodic. A is a
/// part of the periodic compliance C on the grid of
/// SurfaceOperator::periodic_extension(), for pressures that are 0 outside.
/// With K = C^-1, the elastic energy of a surface z inside is the least value
/// of <z, K z>/2 over the surface outside, where K z = 0 then. So the minima
/// over the gap inside and the surface outside are those of solve_adhesive() on
/// the wide grid, where the counter-surface outside lies so low that it neither
/// touches nor attracts. A load p_0 is one of p_0/4 there, and the uniform mode
/// has no stiffness in either problem.
///
/// Fields of a state have the nodes of the wide grid: the gap [m] inside, the
/// height of the surface [m] outside.
class FreeAdhesion {
public:
  /// @param elasticity  A, which must have a periodic_extension(); is used by
  ///                    solve() and must outlive this object
  /// @param heights     h [m], likewise
  /// @throws std::domain_error  there is no periodic_extension()
  FreeAdhesion(SurfaceOperator& elasticity, std::span<const double> heights,
               const mechanics::ContactInterface& law);

  /// The state of a pressure and the gap [m] that belongs to it.
  std::vector<double> state_of(std::span<const double> pressure,
                               std::span<const double> gap);

  /// A step by pressure from a state, which it replaces.
  /// @par Accuracy  as solve_adhesive(), on the wide grid, whose load_tolerance
  ///            also bounds the pressure that is left outside
  /// @throws std::domain_error  also for a prescribed mean gap, which is no
  ///         minimum of an energy here
  ContactSolution solve(const AdhesiveProblem& problem,
                        const mechanics::LoadTarget& target,
                        std::vector<double>& state);

  /// Nodes of the wide grid.
  std::size_t n_nodes() const { return extension_->n_nodes(); }

private:
  /// The height of the counter-surface outside [m] at a load.
  double level(double nominal_pressure) const;
  /// Calls of(i of the wide grid, i of the window).
  template <class Of>
  void each_inside(const Of& of) const;

  SurfaceOperator& elasticity_;
  std::unique_ptr<SurfaceOperator> extension_;
  std::span<const double> heights_;
  mechanics::ContactInterface law_;
  double lowest_ = 0.0, highest_ = 0.0; ///< heights [m]
  double softness_ = 0.0; ///< largest displacement of a uniform pressure [m/Pa]
  double scale_ = 0.0;    ///< k_c [Pa/m]
  std::vector<std::uint8_t> opposed_; ///< see AdhesiveProblem
};

} // namespace asperity::contact
