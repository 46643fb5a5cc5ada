#pragma once

// Which parts of the contact surface need the finest cells: the contact
// boundary, penetration between nodes, and heights that a cell in contact
// cannot follow.
// Include this header in .cpp files of fem/ only.

#include "base/grid.hpp"

#include <limits>
#include <span>
#include <vector>

namespace asperity::fem {

/// A solution on the nodes of the grid.
struct SurfaceFields {
  Grid grid;
  int degree = 1;                   ///< nodes per side of a finest cell
  std::span<const double> pressure; ///< [Pa] >= 0
  std::span<const double> gap; ///< [m]; it does not include the penetration
                               ///< that a penalty permits
  /// Pressure per unit of gap over the edge of a cell [Pa]: a gap e between the
  /// nodes of a cell of edge H changes the pressure by about E* e / H.
  double modulus = 0.0;
  double pressure_tolerance = 0.0; ///< of that change [Pa]
  /// Of the gap at a node under pressure, in cells of any edge [m].
  double gap_tolerance = std::numeric_limits<double>::infinity();
};

/// A rectangle of finest cells: first <= i < last.
struct CellRange {
  int first_x = 0, last_x = 0;
  int first_y = 0, last_y = 0;
};

/// Marks on the finest cells of the contact surface, which are periodic.
///
/// A cell face of the mesh is examined at all nodes of the grid inside of it. A
/// finest cell in it is marked if some of its nodes are under pressure and
/// others are not, if a node without pressure penetrates, or if the gap at a
/// node under pressure exceeds gap_tolerance, or pressure_tolerance H / modulus
/// with H the edge of the face, in magnitude. A contact that the nodes of a
/// coarse cell miss thus shows as penetration between them, and inside of a
/// contact with smooth heights coarse cells remain.
class ContactMarks {
public:
  explicit ContactMarks(const SurfaceFields& fields);

  const Grid& cells() const { return cells_; } ///< one point per finest cell

  /// Examines a cell face of the mesh.
  void examine(const CellRange& face);

  /// One number for each finest cell: whether it is marked. Several ranks that
  /// examine different faces unite theirs.
  std::vector<char>& marks() { return marked_; }

  /// Whether a marked cell lies in the range or next to it.
  bool is_marked_near(const CellRange& range) const;

  /// Whether a node of the range carries pressure or penetrates.
  bool is_touched(const CellRange& range) const;

private:
  bool is_troubled(int ix, int iy, double tolerance) const;

  SurfaceFields fields_;
  Grid cells_;
  std::vector<char> marked_;
};

} // namespace asperity::fem
