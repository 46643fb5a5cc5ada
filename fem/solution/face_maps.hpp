#pragma once

// Transfer of fields between the grid and the contact points.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/solution/height_interpolation.hpp"

#include <span>
#include <vector>

namespace asperity::fem {

/// Transfers fields between the nodes of the grid, which every rank stores, and
/// the contact points, which only their own rank stores. See full_block.hpp for
/// the definition of a sample.
class FaceMaps {
public:
  /// @param system   must outlive this object
  /// @param between  interpolation of heights between the nodes of the grid
  /// @throws std::domain_error  a node of the grid is not on the contact
  ///                            surface
  explicit FaceMaps(const BlockSystem& system,
                    mechanics::HeightInterpolation between =
                        mechanics::HeightInterpolation::bicubic);

  const BlockSystem& system() const { return system_; }

  /// A field of the grid evaluated at this rank's points, with bicubic
  /// interpolation.
  std::vector<double> at_points(std::span<const double> field) const;

  /// The heights of this rank's points [m].
  std::vector<double> heights_at_points(std::span<const double> heights) const;

  /// The heights of places on the contact surface [m].
  std::vector<double>
  heights_at(std::span<const double> heights,
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
    FaceRow row;             ///< of u_z
    std::size_t nearest = 0; ///< nearest Gauss point of the same face
  };

  void find_samples();
  void sample_face(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                   unsigned int f, std::size_t first_point);
  void take_sample(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                   int ix, int iy, std::size_t first_point);
  std::vector<double> summed(std::vector<double> field) const;
  std::vector<double> values_at(std::span<const double> field,
                                std::span<const dealii::Point<2>> places,
                                mechanics::HeightInterpolation between) const;
  std::vector<dealii::Point<2>> places_of_points() const;

  const BlockSystem& system_;
  mechanics::HeightInterpolation between_;
  std::vector<Sample> samples_; ///< empty if the points are the grid's nodes
  std::vector<double> faces_a_node_;
  dealii::IndexSet needed_;
};

} // namespace asperity::fem
