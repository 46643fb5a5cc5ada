#pragma once

// One level of a multigrid cycle on a mesh: the stiffness in single precision,
// contact, and the smoother before and after a correction by coarser functions.

#include "fem/hexahedra/contact_pairs.hpp"
#include "fem/hexahedra/hexahedron_operator.hpp"
#include "fem/multigrid/chebyshev.hpp"
#include "fem/multigrid/face_contact.hpp"
#include "fem/multigrid/sparse_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace asperity::fem {

/// Contact as the linear solver of a mesh sees it.
struct MeshContact {
  std::vector<std::size_t> unknowns; ///< u_z of the contact surface
  SparseRows springs; ///< symmetric matrix on these, or no rows; [N/m] or in
                      ///< the unit of a level's stiffness
  bool has_springs = false;      ///< on any rank
  ContactPairs pairs;            ///< whose springs are not among `springs`
  std::vector<std::size_t> held; ///< unknowns that are held
};

/// A level with the stiffness of Operator<float>, which has apply(),
/// add_own(), collect() and diagonal() as HexahedronOperator.
///
/// Between smooth_before() and smooth_after(), vectors are those of the
/// relative variables of contact pairs. Coarser functions have no relative
/// displacement of a pair, which the springs leave to the smoother alone.
template <template <class> class Operator>
class SmoothedLevel : public SmoothedVectors {
public:
  using Mesh = typename Operator<float>::Mesh;

  /// @param mesh  in units in which its stiffness fits into a float
  explicit SmoothedLevel(const Mesh& mesh)
      : stiffness_(mesh), constraints_(mesh.constraints) {
    inverse_ = stiffness_.diagonal(mesh);
    const auto eigenvalue = static_cast<float>(eigenvalue_estimate(
        inverse_, [&](float* from, float* to) { stiffness_.apply(from, to); },
        mesh.ranks()));
    for (float& value : inverse_)
      value = value > 0.0F ? 1.0F / (eigenvalue * value) : 0.0F;
    displacement.assign(mesh.unknowns, 0.0F);
    residual = direction = displacement;
  }

  /// @param contact  springs in the unit of the stiffness
  void set_contact(MeshContact contact) {
    for (const auto& [unknown, value] : without_contact_)
      inverse_[unknown] = value;
    without_contact_.clear();
    contact_ = std::move(contact);
    if (contact_.has_springs || contact_.pairs.exist)
      soften();
    for (const std::size_t unknown : contact_.held)
      set_inverse(unknown, 0.0F);
    relative_.resize(contact_.pairs.nodes.size());
    product_.resize(contact_.pairs.exist ? inverse_.size() : 0);
  }

  /// An upper bound on the stiffness of an unknown against any displacement.
  double stiffness_bound(std::size_t unknown) const {
    const auto changed = without_contact_.find(unknown);
    const float inverse =
        changed == without_contact_.end() ? inverse_[unknown] : changed->second;
    return inverse > 0.0F ? 1.0 / static_cast<double>(inverse) : 0.0;
  }

  const MeshContact& contact() const { return contact_; }

  /// Smooths from zero for the force in `residual`, which becomes the residual
  /// of the displacement, zero at unknowns that are not solved for.
  void smooth_before() {
    contact_.pairs.add_to_faces(residual.data());
    std::fill(displacement.begin(), displacement.end(), 0.0F);
    smooth_by_chebyshev(*this, inverse_, terms, false, [this] { subtract(); });
    clear_held(residual);
  }

  /// Adds the correction that `correct` computes from the residual; neither
  /// contains the relative displacements of pairs.
  /// @param correct  adds to its second argument
  template <class Correct>
  void add_correction(const Correct& correct) {
    const std::vector<std::size_t>& nodes = contact_.pairs.nodes;
    for (std::size_t pair = 0; pair < nodes.size(); ++pair)
      relative_[pair] = std::exchange(residual[nodes[pair]], 0.0F);
    std::fill(direction.begin(), direction.end(), 0.0F);
    correct(residual, direction);
    for (std::size_t pair = 0; pair < nodes.size(); ++pair) {
      residual[nodes[pair]] = relative_[pair];
      direction[nodes[pair]] = 0.0F;
    }
    clear_held(direction);
    for (std::size_t i = 0; i < displacement.size(); ++i)
      displacement[i] += direction[i];
    subtract();
  }

  void smooth_after() {
    smooth_by_chebyshev(*this, inverse_, terms, true, [this] { subtract(); });
    clear_held(displacement);
    contact_.pairs.add_common(displacement.data());
  }

  /// Sets unknowns to zero that constraints or contact determine.
  template <class Number>
  void clear_held(std::vector<Number>& vector) const {
    constraints_->visit(
        [&](std::size_t unknown) { vector[unknown] = Number(0); });
    for (const std::size_t unknown : contact_.held)
      vector[unknown] = Number(0);
  }

  std::size_t bytes() const {
    return stiffness_.bytes() +
           (4 * inverse_.size() + product_.size() + relative_.size()) *
               sizeof(float) +
           contact_.springs.bytes() + contact_.pairs.bytes() +
           without_contact_.size() * sizeof(*without_contact_.begin()) +
           (contact_.unknowns.size() + contact_.held.size()) *
               sizeof(std::size_t);
  }

private:
  /// Terms of the polynomial before and after the correction.
  static constexpr int terms = 4;

  /// Adds the sum of the magnitudes in each row of the springs to the diagonal.
  void soften() {
    std::vector<double> sums(inverse_.size(), 0.0);
    const SparseRows& springs = contact_.springs;
    for (std::size_t row = 0; row < springs.rows(); ++row)
      for (std::size_t i = springs.start[row]; i < springs.start[row + 1]; ++i)
        sums[contact_.unknowns[row]] += std::abs(springs.weight[i]);
    add_common_stiffness(sums);
    stiffness_.collect(sums.data());
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (sums[i] > 0.0)
        set_inverse(i,
                    static_cast<float>(1.0 / (stiffness_bound(i) + sums[i])));
  }

  void set_inverse(std::size_t unknown, float value) {
    without_contact_.emplace(unknown, inverse_[unknown]);
    inverse_[unknown] = value;
  }

  /// Adds what makes the diagonal an upper bound on K in relative variables
  /// and on the springs: with K <= D and any a > 0,
  ///
  ///     D (r + N m)^2 <= (1 + a) D r^2 + (1 + 1/a) D (sum |N|) (sum |N| m^2).
  void add_common_stiffness(std::vector<double>& sums) const {
    constexpr double a = 2.0;
    const ContactPairs& pairs = contact_.pairs;
    for (std::size_t pair = 0; pair < pairs.nodes.size(); ++pair) {
      const std::size_t node = pairs.nodes[pair];
      const double own = stiffness_bound(node);
      sums[node] += a * own + pairs.springs[pair];
      double shares = 0.0;
      for (std::size_t i = pairs.faces.start[pair];
           i < pairs.faces.start[pair + 1]; ++i)
        shares += std::abs(pairs.faces.weight[i]);
      for (std::size_t i = pairs.faces.start[pair];
           i < pairs.faces.start[pair + 1]; ++i)
        sums[pairs.faces.column[i]] +=
            (1.0 + 1.0 / a) * own * shares * std::abs(pairs.faces.weight[i]);
    }
  }

  /// Subtracts (K + S) direction from the residual.
  void subtract() {
    if (contact_.pairs.exist) {
      subtract_with_pairs();
      return;
    }
    stiffness_.add_own(direction.data(), residual.data(), -1.0F);
    if (!contact_.springs.is_empty())
      add_spring_force(contact_.springs, contact_.unknowns, direction.data(),
                       residual.data(), -1.0);
    stiffness_.collect(residual.data());
  }

  /// The same in relative variables, of which the residual has the forces.
  void subtract_with_pairs() {
    const ContactPairs& pairs = contact_.pairs;
    for (std::size_t pair = 0; pair < pairs.nodes.size(); ++pair)
      relative_[pair] = direction[pairs.nodes[pair]];
    pairs.add_common(direction.data());
    stiffness_.apply_own(direction.data(), product_.data());
    if (!contact_.springs.is_empty())
      add_spring_force(contact_.springs, contact_.unknowns, direction.data(),
                       product_.data());
    stiffness_.collect(product_.data());
    pairs.add_to_faces(product_.data());
    for (std::size_t pair = 0; pair < pairs.nodes.size(); ++pair) {
      direction[pairs.nodes[pair]] = relative_[pair];
      product_[pairs.nodes[pair]] +=
          static_cast<float>(pairs.springs[pair] * relative_[pair]);
    }
    for (std::size_t i = 0; i < product_.size(); ++i)
      residual[i] -= product_[i];
  }

  Operator<float> stiffness_;
  SharedConstraints constraints_;
  /// Of the diagonal times its largest eigenvalue and of what contact adds.
  std::vector<float> inverse_;
  /// The values without contact, by unknown, where they differ.
  std::unordered_map<std::size_t, float> without_contact_;
  MeshContact contact_;
  std::vector<float> product_;  ///< only with pairs
  std::vector<float> relative_; ///< values of the pairs' nodes, set aside
};

} // namespace asperity::fem
