#pragma once

// Multigrid without a matrix for second-order hexahedra of any shape: the block
// as plain data, and the correction by first-order functions on the same mesh.
// Include this header in .cpp files of fem/ only.

#include "fem/hexahedra/hexahedron_operator.hpp"
#include "fem/linear/mesh_block.hpp"

#include <deal.II/lac/trilinos_precondition.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// The block of first-order functions on the mesh of a second-order one, solved
/// approximately by Trilinos ML, and the transfer between the two.
///
/// A node of the contact surface is held if the second-order node at its place
/// is; springs are those of the second-order block on first-order functions
/// (Galerkin), those of contact pairs softened.
class FirstOrderCorrection final : public MeshCorrection {
public:
  /// @param fine      must outlive this object
  /// @param unknowns  those of `fine`
  FirstOrderCorrection(const BlockProblem& problem, const BlockSystem& fine,
                       const LocalUnknowns& unknowns);

  void prepare(std::span<const double> springs, const std::vector<bool>& held,
               bool is_sticking, const MeshContact& contact) override;
  void add(const std::vector<float>& residual, std::vector<float>& displacement,
           double unit) override;

  void check_efficiency(int iterations, double decades) override {
    age_.count(iterations, decades);
  }

  bool is_current() const override { return age_.is_new() || age_.is_stale(); }

  void renew() override { age_.expire(); }

  int setups() const override { return age_.setups(); }

  std::string name() const override { return "first order by Trilinos ML"; }

  std::size_t bytes() const override;

private:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;
  using Unknown = dealii::types::global_dof_index;

  void find_parents(const LocalUnknowns& unknowns);
  void find_points(const BlockSystem& fine, const LocalUnknowns& unknowns);
  void add_point(const dealii::Point<2>& place, FaceRow row);
  void find_rigid_modes();
  void refresh();

  BlockSystem coarse_;
  LocalUnknowns numbers_;          ///< of the first-order unknowns
  std::vector<std::size_t> nodes_; ///< first unknown of each own second-order
                                   ///< node
  SparseRows parents_; ///< first unknowns of vertices, a row per node
  /// The contact points of this rank by first-order unknowns, and their
  /// vertices, with global numbers.
  std::vector<FaceRow> points_;
  std::vector<std::optional<Unknown>> vertices_;
  std::vector<double> rigid_modes_; ///< of the own first-order unknowns, by
                                    ///< mode
  std::vector<double> springs_;
  std::vector<Unknown> held_; ///< own first-order unknowns, global numbers
  dealii::TrilinosWrappers::SparseMatrix matrix_;
  dealii::TrilinosWrappers::PreconditionAMG multigrid_;
  Vector force_, displacement_;
  std::vector<double> values_; ///< at numbers_
  HierarchyAge age_{3};
};

/// The cells of this rank.
HexahedronMesh hexahedron_mesh(const BlockSystem& system,
                               const LocalUnknowns& unknowns);

/// The stiffness of a block of second-order hexahedra and its inverse.
class HexahedronBlock : public MeshBlock {
public:
  /// @param system must outlive this object
  HexahedronBlock(const BlockProblem& problem, const BlockSystem& system);

  /// The same with another correction, which refers to the unknowns.
  /// @param mesh  hexahedron_mesh()
  HexahedronBlock(const BlockSystem& system,
                  const std::shared_ptr<LocalUnknowns>& unknowns,
                  const HexahedronMesh& mesh,
                  std::unique_ptr<MeshCorrection> correction);

  void set_tangents(std::span<const CellTangents> cells) override;

private:
  HexahedronBlock(const BlockProblem& problem, const BlockSystem& system,
                  const std::shared_ptr<LocalUnknowns>& unknowns);
};

/// Whether HexahedronBlock can solve the problem: one body of second-order
/// hexahedra, or two with meshes of their own. Between a block and its mirror
/// image, stiff springs on the whole surface leave the common motion of both to
/// the correction alone.
bool is_hexahedron_block(const BlockSystem& system);

} // namespace asperity::fem
