#pragma once

// Which cells a solution lets refine, and which merge.
// Include this header in .cpp files of fem/ only.

#include "fem/adaptive/contact_marks.hpp"
#include "fem/adaptive/material_marks.hpp"
#include "fem/adaptive/mesh_change.hpp"
#include "fem/solution/meshed_block.hpp"

#include <limits>
#include <span>
#include <vector>

namespace asperity::fem {

/// A solution at the nodes of the grid; see SurfaceFields.
struct FoundContact {
  std::span<const double> pressure;                               ///< [Pa] >= 0
  std::span<const double> gap;                                    ///< [m]
  double gap_tolerance = std::numeric_limits<double>::infinity(); ///< [m]
};

/// The rule of adaptive_block.hpp for one solution.
class RefinementRule {
public:
  /// @param block             with this solution; must outlive this object
  /// @param contact_pressure  mean over the contact [Pa] >= 0
  RefinementRule(const BlockProblem& problem, const MeshedBlock& block,
                 const FoundContact& found, double contact_pressure);

  /// What is to become of each active cell.
  /// @param may_coarsen  whether cells far from any contact may merge
  std::vector<CellChange> changes(bool may_coarsen) const;

private:
  using Cell = dealii::Triangulation<3>::active_cell_iterator;

  std::optional<CellRange> contact_face(const Cell& cell) const;
  void find_reference();
  CellChange change_of(const Cell& cell, bool may_coarsen) const;

  const BlockSystem& system_;
  int finest_level_;
  ContactMarks marks_;
  MaterialMarks materials_;
  std::vector<double> indicator_; ///< by active cell index
  double reference_ = 0.0;        ///< rms of the indicators of cells in contact
};

} // namespace asperity::fem
