#pragma once

// Transfer of fields between the grid and the contact points.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"

#include <span>
#include <vector>

namespace asperity::fem {

/// A periodic field between the nodes of its grid, by cubic convolution of 4 x
/// 4 nodes (R. G. Keys, IEEE Trans. Acoust. Speech Signal Process. 29, 1153
/// (1981), a = -1/2): the value of the grid at a node, exact for quadratic
/// functions, of third order elsewhere.
double interpolated(const Grid& grid, std::span<const double> field,
                    const dealii::Point<2>& place);

/// Transfers fields between the nodes of the grid, which every rank stores, and
/// the contact points, which only their own rank stores. See full_block.hpp for
/// the definition of a sample.
class FaceMaps {
public:
  /// @param system  must outlive this object
  /// @throws std::domain_error  a node of the grid is not on the contact
  ///                            surface
  explicit FaceMaps(const BlockSystem& system);

  const BlockSystem& system() const { return system_; }

  /// A field of the grid evaluated at this rank's points by interpolated().
  std::vector<double> at_points(std::span<const double> field) const;

  /// A field of the grid evaluated at places on the contact surface.
  std::vector<double> values_at(std::span<const double> field,
                                std::span<const dealii::Point<2>> places) const;

  /// The displacement w at the grid's nodes, on every rank [m]. This call is
  /// collective.
  std::vector<double>
  displacement(const dealii::TrilinosWrappers::MPI::Vector& unknowns) const;

  /// The field on the grid from the pressures at this rank's points [Pa]. This
  /// call is collective.
  std::vector<double> pressure(std::span<const double> at_points) const;

  /// Areas of the points over their mean; all ones if the fields are samples.
  std::vector<double> weights() const;

private:
  /// A node of the grid on one cell face of this rank.
  struct Sample {
    std::size_t node = 0;
    FaceRow row; ///< of u_z
  };

  void find_samples();
  void sample_face(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                   unsigned int f);
  void take_sample(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                   int ix, int iy);
  std::vector<double> summed(std::vector<double> field) const;

  const BlockSystem& system_;
  std::vector<Sample> samples_; ///< empty if the points are the grid's nodes
  std::vector<double> faces_a_node_;
  dealii::IndexSet needed_;
};

} // namespace asperity::fem
