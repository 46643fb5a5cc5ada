#pragma once

// A block on a mesh without its matrix: the unknowns of deal.II and the contact
// points as plain data for MeshMultigrid, and the correction by coarser
// functions that its cycle uses.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/linear/block_solver.hpp"
#include "fem/linear/local_unknowns.hpp"
#include "fem/multigrid/mesh_multigrid.hpp"

#include <memory>
#include <span>
#include <string>
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
class MeshBlock : public MatrixFreeBlock {
public:
  /// @param system    must outlive this object
  /// @param unknowns  to which `stiffness` and `correction` refer; its cells
  ///                  are forgotten
  MeshBlock(const BlockSystem& system, std::shared_ptr<LocalUnknowns> unknowns,
            MeshStiffness stiffness,
            std::unique_ptr<MeshCorrection> correction);

  /// The cycle refers to this object.
  MeshBlock(const MeshBlock&) = delete;
  MeshBlock& operator=(const MeshBlock&) = delete;

  void vmult(Vector& to, const Vector& from) const override;
  void prepare(std::span<const double> springs, const std::vector<bool>& held,
               bool is_sticking) override;
  LinearSolution solve(Vector& unknowns, const Vector& forces, double tolerance,
                       int most_iterations) override;

  void forget() override { correction_->renew(); }

  int setups() const override { return correction_->setups(); }

  std::string name() const override {
    return "CG, multigrid without a matrix, " + correction_->name();
  }

  std::size_t bytes() const override;

protected:
  MeshOperator<double>& stiffness() { return multigrid_.stiffness(); }

private:
  std::vector<bool> soften_pairs(std::vector<double>& springs) const;
  void copy_owned(const Vector& from, std::vector<double>& to) const;

  const BlockSystem& system_;
  std::shared_ptr<LocalUnknowns> unknowns_;
  SparseRows points_;               ///< contact_rows()
  mutable MeshMultigrid multigrid_; ///< its force() is that of products, too
  std::unique_ptr<MeshCorrection> correction_;
  mutable std::vector<double> displacement_;
};

} // namespace asperity::fem
