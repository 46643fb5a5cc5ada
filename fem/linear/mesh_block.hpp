#pragma once

// A block on a mesh without its matrix: the unknowns of deal.II and the contact
// points as plain data for MeshMultigrid, and the correction by coarser
// functions that its cycle uses.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/linear/block_inverse.hpp"
#include "fem/multigrid/mesh_contact.hpp"
#include "fem/multigrid/mesh_multigrid.hpp"
#include "fem/multigrid/unknown_layout.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// Numbers the unknowns of hexahedra by node: those of this rank in the order
/// of their global numbers, then the ghosts, which are the nodes of its cells
/// that other ranks own, the masters of all these and what else is needed. On
/// one process the numbers are the global ones.
class LocalUnknowns {
public:
  using Unknown = dealii::types::global_dof_index;

  /// This call is collective.
  /// @param needed  further unknowns
  LocalUnknowns(const BlockSpace& space, const dealii::IndexSet& needed);

  /// With the constraints of the unknowns of cells.
  const UnknownLayout& layout() const { return layout_; }

  std::size_t size() const { return layout_.size; }

  std::size_t owned() const { return owned_.n_elements(); }

  std::size_t of(Unknown unknown) const;

  std::vector<Unknown> global() const; ///< number of each unknown

  /// As BlockSpace::cell_nodes(), in these numbers.
  const std::vector<std::uint32_t>& cell_nodes() const { return cell_nodes_; }

  void forget_cells() { cell_nodes_ = {}; } ///< frees their memory

  std::size_t bytes() const;

private:
  void find_ghosts(const BlockSpace& space, const dealii::IndexSet& needed);
  void take_constraints(const BlockSpace& space);

  dealii::IndexSet owned_;
  Unknown first_ = 0;
  std::vector<std::size_t> ghost_nodes_; ///< global numbers, increasing
  std::vector<std::uint32_t> cell_nodes_;
  UnknownLayout layout_;
};

/// The values of shape functions at the contact points, a row per point, by
/// these unknowns.
SparseRows contact_rows(const BlockSystem& system,
                        const LocalUnknowns& unknowns);

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
class MeshBlock : public BlockInverse {
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
