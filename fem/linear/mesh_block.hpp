#pragma once

// A block on a mesh without its matrix: the unknowns of deal.II and the contact
// points as plain data for MeshMultigrid, and the correction by coarser
// functions that its cycle uses.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/hexahedra/mesh_multigrid.hpp"
#include "fem/linear/block_solver.hpp"
#include "fem/linear/local_unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity::fem {

/// Solves for a residual approximately by coarser functions. Calls are
/// collective.
class MeshCorrection {
public:
  virtual ~MeshCorrection() = default;

  /// Takes the contact, of which `contact` is the form for the linear solver,
  /// in units of m and N.
  virtual void prepare(std::span<const double> springs,
                       const std::vector<bool>& held, bool is_sticking,
                       const MeshContact& contact) = 0;

  /// Adds the correction for a residual, both over the unknowns of the block.
  /// @param unit  of the residual over that of the correction [N/m]
  virtual void add(const std::vector<float>& residual,
                   std::vector<float>& displacement, double unit) = 0;

  /// Reports that a solution took `iterations` for `decades` of the residual.
  virtual void check_efficiency(int iterations, double decades) = 0;

  /// Whether the correction is, or will be at its next use, that of the present
  /// contact.
  virtual bool is_current() const = 0;

  virtual void renew() = 0; ///< for the present contact, at the next use

  virtual int setups() const = 0;

  virtual std::string name() const = 0;

  virtual std::size_t bytes() const = 0;
};

/// The stiffness of a block on a mesh and its inverse. Each rank sums over its
/// own cells; set-up, products and solutions are collective.
/// @tparam Operator  HexahedronOperator, or another with the same functions
template <template <class> class Operator>
class MeshBlock : public MatrixFreeBlock {
public:
  using Mesh = typename Operator<double>::Mesh;

  /// @param system    must outlive this object
  /// @param unknowns  to which `mesh` and `correction` refer; its cells are
  ///                  forgotten
  MeshBlock(const BlockSystem& system, std::shared_ptr<LocalUnknowns> unknowns,
            const Mesh& mesh, std::unique_ptr<MeshCorrection> correction)
      : system_(system),
        unknowns_(std::move(unknowns)),
        multigrid_(mesh),
        correction_(std::move(correction)) {
    unknowns_->forget_cells();
    vectors_.ranks = mesh.ranks();
    multigrid_.set_correction([this](const auto& residual, auto& displacement) {
      correction_->add(residual, displacement, multigrid_.unit());
    });
  }

  void vmult(Vector& to, const Vector& from) const override {
    copy_owned(from, vectors_.direction);
    multigrid_.apply(vectors_.direction, vectors_.product);
    std::copy_n(vectors_.product.begin(), unknowns_->owned(), to.begin());
  }

  void prepare(std::span<const double> springs, const std::vector<bool>& held,
               bool is_sticking) override {
    std::vector<double> softened(springs.begin(), springs.end());
    MeshContact contact = mesh_contact(system_, *unknowns_, springs, held,
                                       is_sticking, soften_pairs(softened));
    correction_->prepare(softened, held, is_sticking, contact);
    multigrid_.set_contact(std::move(contact));
  }

  LinearSolution solve(Vector& unknowns, const Vector& forces, double tolerance,
                       int most_iterations) override {
    copy_owned(forces, vectors_.residual);
    copy_owned(unknowns, displacement_);
    // A correction of another contact state may be useless for this one.
    constexpr int most_with_old = 50;
    const bool is_old = !correction_->is_current();
    LinearSolution solution = multigrid_.solve(
        displacement_, tolerance,
        is_old ? std::min(most_with_old, most_iterations) : most_iterations,
        vectors_);
    if (solution.has_converged || !is_old) {
      correction_->check_efficiency(
          solution.iterations,
          std::log10(solution.first_residual / solution.last_residual));
    } else {
      const int before = solution.iterations;
      correction_->renew();
      copy_owned(forces, vectors_.residual);
      solution =
          multigrid_.solve(displacement_, tolerance, most_iterations, vectors_);
      solution.iterations += before;
    }
    multigrid_.clear_held(displacement_);
    std::copy_n(displacement_.begin(), unknowns_->owned(), unknowns.begin());
    return solution;
  }

  int setups() const override { return correction_->setups(); }

  std::string name() const override {
    return "CG, multigrid without a matrix, " + correction_->name();
  }

  std::size_t bytes() const override {
    return unknowns_->bytes() + multigrid_.bytes() + correction_->bytes() +
           (displacement_.size() + vectors_.size()) * sizeof(double);
  }

protected:
  MeshMultigrid<Operator>& multigrid() { return multigrid_; }

private:
  /// Finds the points whose springs make a contact pair, those that are stiffer
  /// than the node of the first body, and softens them for the correction. Its
  /// functions have no relative displacement there: the node follows the face
  /// of the other body. Moving it by e from where the function would have it
  /// costs at most k e^2/2, with the bound k on the stiffness of the node, and
  /// a spring of this kind is what the correction has for that. With 3 k, the
  /// stiffness of the correction is at least 3/4 of that of its functions.
  /// @return  of each point, or empty if no points can be pairs
  std::vector<bool> soften_pairs(std::vector<double>& springs) const {
    constexpr double stiff = 2.0;
    constexpr double kept = 3.0;
    const ContactPoints& points = system_.contact();
    std::vector<bool> is_pair;
    if (!system_.has_counter() || !points.is_nodal())
      return is_pair;
    is_pair.resize(springs.size());
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const double own = multigrid_.stiffness_bound(
          unknowns_->of(points[i].row.front().first));
      is_pair[i] = springs[i] > stiff * own;
      if (is_pair[i])
        springs[i] = std::min(springs[i], kept * own);
    }
    return is_pair;
  }

  /// Copies the own unknowns; those of other ranks are zero.
  void copy_owned(const Vector& from, std::vector<double>& to) const {
    to.assign(from.begin(), from.end());
    to.resize(unknowns_->size(), 0.0);
  }

  const BlockSystem& system_;
  std::shared_ptr<LocalUnknowns> unknowns_;
  MeshMultigrid<Operator> multigrid_;
  std::unique_ptr<MeshCorrection> correction_;
  std::vector<double> displacement_;
  mutable GradientVectors vectors_; ///< also of products
};

} // namespace asperity::fem
