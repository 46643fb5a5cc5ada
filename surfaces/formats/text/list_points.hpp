#pragma once

// This internal header of surfaces/formats reads lists x y z whose points are
// in any order by rows of their grid. A list is read point by point; only the
// distinct positions of its axes and one bit for each point of the grid are in
// memory besides the rows.

#include "surfaces/formats/row_file.hpp"
#include "surfaces/formats/text/xyz_list.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace asperity::surfaces {

/// A point of a list, in the units of its file.
struct ListPoint {
  double x = 0.0, y = 0.0, z = 0.0;
  int line = 0; ///< or row, from 1
  /// Errors of the printed positions x and y of the file up to here.
  std::array<double, 2> rounding = {};
};

/// Returns whether the next point is wanted.
using TakePoint = std::function<bool(const ListPoint&)>;

/// A list that can be read several times.
struct ListSource {
  std::string path;
  std::string name; ///< for messages: the path, or the dataset in it
  std::function<void(const TakePoint&)> each_point;
};

/// Positions along an axis of a list. Those that are close to each other become
/// an interval when there are too many.
class AxisPositions {
public:
  /// @param most  intervals; the axis of a list is found if it has fewer than a
  ///              quarter of them
  explicit AxisPositions(std::size_t most) : most_(most) {}

  void take(double position);

  /// Whether the gaps of the axis are known; else more intervals are needed.
  bool is_resolved() const;

  /// The axis that scan_of_list() finds.
  /// @param rounding  error of a printed position
  std::optional<ListAxis> axis(double rounding) const;

private:
  double largest_gap() const;
  void merge_close();

  using Intervals = std::map<double, double>; ///< least to largest

  std::size_t most_;
  Intervals intervals_;
  Intervals::iterator last_ = {}; ///< the interval that took the last position
  double merged_ = 0.0;           ///< no gap within an interval is wider
};

/// What a list contains, found without its heights.
struct ListIndex {
  std::size_t points = 0;       ///< in the file
  std::optional<ListGrid> grid; ///< if the positions are regular
  int repeated = 0;             ///< line of a point that is there again; or 0
  int first = 0;                ///< the first line of that point
  std::size_t missing = 0;      ///< points of the grid without a number
  double largest = 0.0;         ///< magnitude of the numbers z

  /// Whether is_regular_list() is true.
  bool is_list() const { return points >= 4 && grid && repeated == 0; }
};

ListIndex index_of_list(const ListSource& source);

/// The list by rows of its grid, with the bits and the messages of
/// scan_of_list().
/// @throws input::InputError  as scan_of_list()
RowFile list_row_file(const ListSource& source,
                      const std::shared_ptr<const ListIndex>& index,
                      const MapScale& scale);

/// The same of a matrix of three columns that is a list.
/// @param matrix  its numbers, with the unit 1
/// @return  nothing if it is no list because of its number of rows or columns
/// @throws input::InputError  as refuse_possible_list() and scan_of_list()
std::optional<RowFile> list_in_matrix(const std::string& path,
                                      const std::string& name,
                                      const RowFile& matrix,
                                      const MapScale& scale);

} // namespace asperity::surfaces
