#pragma once

// Between the grid's maps and the points of the contact face.
// Include from .cpp files of fem/ only.

#include "fem/block/block_system.hpp"

#include <span>
#include <vector>

namespace asperity::fem {

/// Periodic bicubic convolution (R. G. Keys, IEEE Trans. Acoust. Speech Signal
/// Process. 29, 1153 (1981), a = -1/2): exact at nodes and for quadratics,
/// third order between.
/// @param field  grid.size() values
double bicubic(const Grid& grid, std::span<const double> field, double x,
               double y);

/// Carries fields between the grid's nodes, known to every rank, and the
/// points, known to their rank. See full_block.hpp for what a sample is.
class FaceMaps {
public:
  /// @param system must outlive this
  /// @throws std::domain_error  a node of the grid is not on the contact face
  explicit FaceMaps(const BlockSystem& system);

  /// A field of the grid at this rank's points.
  std::vector<double> at_points(std::span<const double> field) const;

  /// w [m] at the grid's nodes on every rank; collective.
  std::vector<double>
  displacement(const dealii::TrilinosWrappers::MPI::Vector& unknowns) const;

  /// Pressures [Pa] of this rank's points as the grid's map; collective.
  std::vector<double> pressure(std::span<const double> at_points) const;

  /// Areas of the points over their mean; ones where maps are samples.
  std::vector<double> weights() const;

private:
  /// A node of the grid on one face of this rank.
  struct Sample {
    std::size_t node = 0;
    FaceRow row;             ///< of u_z
    std::size_t nearest = 0; ///< point of the same face, for Gauss points
  };

  void find_samples();
  void sample_face(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                   unsigned int f, std::size_t first_point);
  void take_sample(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                   int ix, int iy, std::size_t first_point);
  std::vector<double> summed(std::vector<double> field) const;

  const BlockSystem& system_;
  std::vector<Sample> samples_; ///< empty where the points are the grid
  std::vector<double> faces_a_node_;
  dealii::IndexSet needed_;
};

} // namespace asperity::fem
