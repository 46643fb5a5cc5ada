#pragma once

// Geometric multigrid for a block whose mesh is a grid of boxes, and what
// pins and contact points do there.
// Include this header in .cpp files of fem/ only.

#include "base/ranks/value_exchange.hpp"
#include "fem/block/block_system.hpp"
#include "fem/linear/block_inverse.hpp"
#include "fem/multigrid/box_grid_multigrid.hpp"
#include "fem/multigrid/box_grid_slab.hpp"
#include "fem/multigrid/mesh_contact.hpp"

#include <deal.II/lac/trilinos_vector.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// The nodes of the unknowns on the cells of this rank. The number of a node's
/// component is its index in a vector of the whole grid of boxes (NodeLayout).
struct BoxGridNumbering {
  struct Pin {
    std::size_t node = 0;
    unsigned int component = 0;
  };

  /// Of each unknown that this rank owns, or SlabPlaces::nowhere if it is
  /// constrained.
  std::vector<std::size_t> nodes;
  /// Of each unconstrained u_z on the contact surface; periodic images count as
  /// their roots.
  std::map<dealii::types::global_dof_index, std::size_t> face;
  std::vector<Pin> pins; ///< unknowns held that the far boundary does not hold

  BoxGridNumbering(const BlockSystem& system, const BoxGrid& box_grid);

private:
  void add_cell(const BlockSystem& system, const BoxGrid& box_grid,
                const dealii::DoFHandler<3>::active_cell_iterator& cell);
  void take(const BlockSpace& space, const BoxGrid& box_grid,
            dealii::types::global_dof_index unknown, unsigned int component,
            std::size_t node);

  dealii::types::global_dof_index first_owned_ = 0;
  NodeLayout layout_;          ///< of the whole grid of boxes
  std::vector<double> depths_; ///< of the sides of the layers [m]
};

/// Values of unknowns that go from the rank that has them in deal.II's
/// numbering to the rank that has their node of a grid of boxes, and back. All
/// calls are collective.
class UnknownExchange {
public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;
  static constexpr auto nowhere = static_cast<std::size_t>(-1);

  /// @param ranks     null if there is only one
  /// @param numbers   of the node's component of each own unknown, or nowhere
  /// @param rank_of   the rank that has a number; null if each rank has all
  /// @param place_of  the place of a number in a vector of the rank that has it
  UnknownExchange(
      RankGroup* ranks, std::span<const std::size_t> numbers,
      const std::function<int(std::size_t number)>& rank_of,
      const std::function<std::size_t(std::size_t number)>& place_of);

  /// Writes the values to their places; others become zero.
  void send(const Vector& from, std::span<double> to) const;

  /// Sets the unknowns from their places; those that are nowhere become zero.
  void give_back(std::span<const double> from, Vector& to) const;

  std::size_t bytes() const {
    return (unknowns_.size() + places_.size()) * sizeof(std::uint32_t);
  }

private:
  // Both are below 2^32, because the numbers of unknowns are.
  std::vector<std::uint32_t> unknowns_; ///< in this rank's vector, by target
  std::vector<std::uint32_t> places_;   ///< of values received
  std::optional<ValueExchange> values_; ///< none on one rank
};

/// All calls are collective.
class BoxGridExchange {
public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// @param slab   the rows of this rank
  /// @param ranks  null if there is only one
  BoxGridExchange(const BlockSystem& system, const BoxGrid& box_grid,
                  const BoxGridSlab& slab, RankGroup* ranks,
                  const BoxGridNumbering& numbering);

  /// Sets the values on the grid of boxes, zero at images and constrained
  /// unknowns.
  void to_box_grid(const Vector& from, std::vector<double>& to) const;

  /// Sets the unknowns, zero if constrained.
  void from_box_grid(const std::vector<double>& from, Vector& to) const;

  /// The contact of the slab.
  /// @param springs, held  of the contact points of this rank
  MeshContact contact(std::span<const double> springs,
                      const std::vector<bool>& held, bool is_sticking) const;

  std::size_t bytes() const;

private:
  static UnknownExchange unknowns_of(const BoxGrid& box_grid,
                                     const BoxGridSlab& slab, RankGroup* ranks,
                                     const BoxGridNumbering& numbering);
  void number_points(const BlockSystem& system, const BoxGrid& box_grid,
                     const BoxGridSlab& slab,
                     const BoxGridNumbering& numbering);

  RankGroup* ranks_;
  RankGroup* sharing_; ///< the same, but null if each has all rows
  std::size_t size_;   ///< of a vector of the slab
  UnknownExchange unknowns_;
  std::vector<std::size_t> order_; ///< contact points of this rank by target
  SparseRows points_; ///< contact points received, by places on the slab
  std::unique_ptr<ValueExchange> point_values_; ///< null on one rank
};

/// The grid of boxes of a problem if its mesh consists of equal columns of
/// boxes numbered as by layered_mesh; none for other meshes and two bodies.
std::optional<BoxGrid> box_grid_of(const BlockProblem& problem);

/// The stiffness of the block and its inverse on the grid of boxes. On several
/// ranks, each solves for the nodes of its rows of cells (BoxGridSlab), or all
/// do the same if there are few rows; unknowns and contact are sent there and
/// back.
///
/// Pins (BlockSpace) that only prevent a rigid motion carry the sum of the
/// forces, and the motion is subtracted from the solution. A pin in z of a
/// block that contact supports as well is held.
class BoxGridBlock : public BlockInverse {
public:
  /// @param system  its mesh is that of the grid of boxes
  BoxGridBlock(const BlockSystem& system, const BoxGrid& box_grid);

  void vmult(Vector& to, const Vector& from) const override;
  void prepare(std::span<const double> springs, const std::vector<bool>& held,
               bool is_sticking) override;
  LinearSolution solve(Vector& unknowns, const Vector& forces, double tolerance,
                       int most_iterations) override;

  /// A decade costs one iteration. Under a pressure-loaded far boundary the
  /// response to the approach is a small difference, and without this factor it
  /// is too inaccurate for a stationary contact set.
  double tightness() const override { return 1e-3; }

  /// Contact is transferred to the same grids of boxes.
  int setups() const override { return 1; }

  std::string name() const override;
  std::size_t bytes() const override;

  std::size_t levels() const { return multigrid_.levels(); }

private:
  struct Pin {
    std::size_t node =
        0; ///< number of the node's component on the grid of boxes
    std::size_t place = 0; ///< in a vector of this rank, or nowhere
    unsigned int component = 0;
  };

  BoxGridBlock(const BlockSystem& system, const BoxGrid& box_grid,
               const BoxGridNumbering& numbering);
  void take_pins(const BoxGridNumbering& numbering);
  void find_modes();
  std::vector<double> at_pins(const std::vector<double>& right_sides,
                              bool is_transposed) const;
  void balance_forces();
  void remove_motions();

  RankGroup* ranks_; ///< null if there is only one
  BoxGridMultigrid multigrid_;
  BoxGridExchange exchange_;
  std::vector<Pin> pins_; ///< the same on all ranks
  bool has_contact_ = false;
  std::vector<Pin> loose_;             ///< pins that hold a rigid motion only
  std::vector<std::size_t> held_pins_; ///< places of the others
  std::vector<std::vector<double>> modes_; ///< as many rigid motions
  std::vector<double> at_loose_;           ///< each motion at each of these
  mutable std::vector<double> from_, to_;
};

} // namespace asperity::fem
