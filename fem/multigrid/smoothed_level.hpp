#pragma once

// One level of a multigrid cycle: the stiffness in single precision, contact,
// and the smoother before and after a correction by coarser functions.

#include "fem/multigrid/chebyshev.hpp"
#include "fem/multigrid/mesh_contact.hpp"
#include "fem/multigrid/mesh_operator.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace asperity::fem {

/// If no bound on the eigenvalues of D^-1 K is known.
inline constexpr double no_bound = std::numeric_limits<double>::infinity();

/// The smoother is a Chebyshev polynomial of the fourth kind, which needs an
/// upper bound on the eigenvalues of D^-1 K only. Springs add the sums of their
/// rows |S_ij| over that bound to the diagonal D of K, so that it holds for any
/// springs.
/// @see  J. Lottes, Numer. Linear Algebra Appl. 30, e2518 (2023)
///
/// Between smooth_before() and smooth_after(), vectors are those of the
/// relative variables of contact pairs. Coarser functions have no relative
/// displacement of a pair, which the springs leave to the smoother alone.
class SmoothedLevel : public SmoothedVectors {
public:
  /// @param stiffness  in units in which it fits into a float
  /// @param diagonal   of the stiffness, zero at constrained unknowns and those
  ///                   of other ranks
  /// @param bound      on the eigenvalues of D^-1 K, or no_bound; an estimate
  ///                   is taken if it is smaller
  SmoothedLevel(std::unique_ptr<MeshOperator<float>> stiffness,
                const std::vector<double>& diagonal, double bound);

  const UnknownLayout& layout() const { return stiffness_->layout(); }

  /// @param contact  springs in the unit of the stiffness
  void set_contact(MeshContact contact);

  /// An upper bound on the stiffness of an unknown against any displacement.
  double stiffness_bound(std::size_t unknown) const;

  /// Smooths from zero for the force in `residual`, which becomes the residual
  /// of the displacement, zero at unknowns that are not solved for.
  void smooth_before();

  /// Adds the correction that `correct` computes from the residual; neither
  /// contains the relative displacements of pairs.
  /// @param correct  adds to its second argument
  template <class Correct>
  void add_correction(const Correct& correct) {
    take_relative();
    correct(residual, direction);
    end_correction();
  }

  void smooth_after();

  /// Sets unknowns to zero that constraints or contact determine.
  template <class Number>
  void clear_held(std::vector<Number>& vector) const {
    layout().constraints->visit(
        [&](std::size_t unknown) { vector[unknown] = Number(0); });
    for (const std::size_t unknown : held_)
      vector[unknown] = Number(0);
  }

  std::size_t bytes() const;

private:
  void soften();
  void set_inverse(std::size_t unknown, float value);
  void add_common_stiffness(std::vector<double>& sums) const;
  void take_relative();
  void end_correction();
  void subtract();
  void subtract_with_pairs();

  std::unique_ptr<MeshOperator<float>> stiffness_;
  /// Of the diagonal times its largest eigenvalue and of what contact adds.
  std::vector<float> inverse_;
  /// The values without contact, by unknown, where they differ.
  std::unordered_map<std::size_t, float> without_contact_;
  MeshContact contact_;
  std::vector<std::size_t> held_; ///< all unknowns that contact holds
  std::vector<float> product_;    ///< only with pairs
  std::vector<float> relative_;   ///< values of the pairs' nodes, set aside
};

} // namespace asperity::fem
