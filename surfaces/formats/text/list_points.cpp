#include "surfaces/formats/text/list_points.hpp"

#include "surfaces/formats/known_file.hpp"
#include "surfaces/maps/corrections.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace asperity::surfaces {
namespace {

/// Enough for an axis of 16384 points, some MB.
constexpr std::size_t first_intervals = std::size_t{1} << 16;

/// A position is looked for in this many intervals for each point of an axis.
constexpr std::size_t intervals_per_point = 5;

struct ListAxes {
  AxisPositions x, y;
  std::size_t points = 0;
  bool is_finite = true;
  std::array<double, 2> rounding = {};

  std::optional<ListAxis> axis_x() const { return x.axis(rounding[0]); }

  std::optional<ListAxis> axis_y() const { return y.axis(rounding[1]); }
};

ListAxes read_axes(const ListSource& source, std::size_t most_x,
                   std::size_t most_y) {
  ListAxes axes{AxisPositions(most_x), AxisPositions(most_y)};
  source.each_point([&](const ListPoint& point) {
    ++axes.points;
    axes.rounding = point.rounding;
    axes.is_finite =
        axes.is_finite && std::isfinite(point.x) && std::isfinite(point.y);
    if (axes.is_finite) {
      axes.x.take(point.x);
      axes.y.take(point.y);
    }
    return true; // to the end, for mistakes in later lines
  });
  return axes;
}

/// Intervals that find an axis which is not resolved, beside one that is: half
/// of the grid at least is in the list.
std::size_t intervals_beside(const std::optional<ListAxis>& other,
                             std::size_t n_points) {
  constexpr std::size_t most = std::size_t{1} << 20;
  return intervals_per_point *
         std::min(most, other ? 2 * n_points / other->points : 0);
}

std::optional<ListGrid> grid_of(const ListAxes& axes) {
  if (!axes.is_finite)
    return std::nullopt;
  return grid_of_axes(axes.axis_x(), axes.axis_y(), axes.points);
}

/// Reads the axes again if one of them has more points than expected. Two such
/// axes have more points than any file.
ListAxes axes_of(const ListSource& source) {
  ListAxes axes = read_axes(source, first_intervals, first_intervals);
  const bool is_x = axes.x.is_resolved(), is_y = axes.y.is_resolved();
  if (axes.is_finite && is_x != is_y) {
    const std::size_t more =
        intervals_beside(is_x ? axes.axis_x() : axes.axis_y(), axes.points);
    if (more > first_intervals)
      return read_axes(source, is_x ? first_intervals : more,
                       is_x ? more : first_intervals);
  }
  return axes;
}

std::size_t index_of(const ListGrid& grid, const ListPoint& point) {
  return grid.y.index_of(point.y) * grid.x.points + grid.x.index_of(point.x);
}

/// Takes the points of a list to its grid: which are there, how often, and how
/// many have a number.
void take_points(const ListSource& source, ListIndex& index) {
  const ListGrid& grid = *index.grid;
  std::vector<bool> is_there(grid.x.points * grid.y.points, false);
  std::size_t repeated = 0, numbers = 0;
  source.each_point([&](const ListPoint& point) {
    const std::size_t at = index_of(grid, point);
    if (is_there[at]) {
      index.repeated = point.line;
      repeated = at;
      return false;
    }
    is_there[at] = true;
    if (!std::isnan(point.z)) {
      ++numbers;
      index.largest = std::max(index.largest, std::abs(point.z));
    }
    return true;
  });
  index.missing = is_there.size() - numbers;
  if (index.repeated == 0)
    return;
  source.each_point([&](const ListPoint& point) {
    index.first = point.line;
    return index_of(grid, point) != repeated;
  });
}

/// A list, what is known of it, and the file as it was then.
struct KnownList {
  ListSource source;
  std::shared_ptr<const ListIndex> index;
  double height_unit; ///< [m]
  FileStamp stamp;

  /// Calls take(x, y, height [m]) for each point and checks that the file is
  /// still that of the index.
  template <class Take>
  void each_height(const Take& take) const {
    std::size_t n_points = 0;
    source.each_point([&](const ListPoint& point) {
      const ListGrid& grid = *index->grid;
      if (!grid.x.has(point.x) || !grid.y.has(point.y))
        FileStamp::refuse_changed(source.name);
      take(grid.x.index_of(point.x), grid.y.index_of(point.y),
           height_unit * point.z);
      return ++n_points <= index->points;
    });
    if (n_points != index->points)
      FileStamp::refuse_changed(source.name);
    stamp.require_unchanged(source.path);
  }
};

std::vector<double> rows_of_list(const KnownList& list, int first, int count) {
  const std::size_t width = list.index->grid->x.points;
  const auto begin = static_cast<std::size_t>(first);
  const auto n_rows = static_cast<std::size_t>(count);
  std::vector<double> heights(n_rows * width,
                              std::numeric_limits<double>::quiet_NaN());
  list.each_height([&](std::size_t x, std::size_t y, double height) {
    if (y >= begin && y < begin + n_rows)
      heights[(y - begin) * width + x] = height;
  });
  return heights;
}

std::size_t missing_in_window(const KnownList& list,
                              const PixelWindow& window) {
  const auto is_within = [](std::size_t at, int first, int count) {
    return at >= static_cast<std::size_t>(first) &&
           at < static_cast<std::size_t>(first) +
                    static_cast<std::size_t>(count);
  };
  std::size_t missing = window.grid.size();
  list.each_height([&](std::size_t x, std::size_t y, double height) {
    if (std::isfinite(height) &&
        is_within(x, window.first_x, window.grid.points_x) &&
        is_within(y, window.first_y, window.grid.points_y))
      --missing;
  });
  return missing;
}

} // namespace

void AxisPositions::take(double position) {
  const auto contains = [&](Intervals::iterator one) {
    return one != intervals_.end() && one->first <= position &&
           position <= one->second;
  };
  if (!intervals_.empty()) {
    // The next point of a list is often in the same column or the next one.
    if (contains(last_))
      return;
    last_ = std::next(last_);
    if (contains(last_))
      return;
    last_ = intervals_.upper_bound(position);
    if (last_ != intervals_.begin()) {
      --last_;
      if (contains(last_))
        return;
      if (position > last_->first && position - last_->second <= merged_) {
        last_->second = position;
        return;
      }
    }
  }
  last_ = intervals_.emplace(position, position).first;
  if (intervals_.size() > most_)
    merge_close();
}

void AxisPositions::merge_close() {
  const double extent =
      std::prev(intervals_.end())->second - intervals_.begin()->first;
  merged_ = std::max(merged_, 2.0 * extent / static_cast<double>(most_));
  for (auto one = intervals_.begin(); std::next(one) != intervals_.end();) {
    const auto next = std::next(one);
    if (next->first - one->second <= merged_) {
      one->second = std::max(one->second, next->second);
      intervals_.erase(next);
    } else {
      one = next;
    }
  }
  last_ = intervals_.begin();
}

double AxisPositions::largest_gap() const {
  double gap = 0.0;
  for (auto one = intervals_.begin(); one != intervals_.end(); ++one)
    if (const auto next = std::next(one); next != intervals_.end())
      gap = std::max(gap, next->first - one->second);
  return gap;
}

bool AxisPositions::is_resolved() const {
  return merged_ == 0.0 || merged_ <= 0.5 * largest_gap();
}

std::optional<ListAxis> AxisPositions::axis(double rounding) const {
  if (intervals_.empty() || !is_resolved())
    return std::nullopt;
  const double gap = largest_gap();
  std::vector<ListPositions> points;
  for (const auto& [least, largest] : intervals_)
    if (!points.empty() && least - points.back().largest <= 0.5 * gap)
      points.back().largest = std::max(points.back().largest, largest);
    else
      points.push_back({least, largest});
  return axis_of(points, rounding);
}

ListIndex index_of_list(const ListSource& source) {
  const ListAxes axes = axes_of(source);
  ListIndex index;
  index.points = axes.points;
  index.grid = grid_of(axes);
  if (index.grid)
    take_points(source, index);
  return index;
}

RowFile list_row_file(const ListSource& source,
                      const std::shared_ptr<const ListIndex>& index,
                      const MapScale& scale) {
  if (!index->grid)
    refuse_irregular_list(source.name);
  RowFile file{index->grid->scaled(source.name, scale), "", list_reader, {}};
  if (index->repeated != 0)
    refuse_repeated_point(source.name, index->repeated, index->first);
  file.numbers.unit = *scale.height_unit;
  const KnownList list{source, index, *scale.height_unit,
                       FileStamp(source.path)};
  file.rows = [list](int first, int count) {
    return rows_of_list(list, first, count);
  };
  file.missing_in = [list](const PixelWindow& window) {
    return missing_in_window(list, window);
  };
  if (std::isfinite(index->largest * list.height_unit))
    file.missing = index->missing;
  return file;
}

std::optional<RowFile> list_in_matrix(const std::string& path,
                                      const std::string& name,
                                      const RowFile& matrix,
                                      const MapScale& scale) {
  const auto columns = static_cast<std::size_t>(matrix.grid.points_x);
  const int n_rows = matrix.grid.points_y;
  if (columns != list_columns || n_rows < 4) {
    refuse_possible_list(name, columns, static_cast<std::size_t>(n_rows));
    return std::nullopt;
  }
  const ListSource source{
      path, name, [rows = matrix.rows, n_rows](const TakePoint& take) {
        constexpr int at_a_time = 1 << 18;
        for (int row = 0; row < n_rows; row += at_a_time) {
          const std::vector<double> numbers =
              rows(row, std::min(at_a_time, n_rows - row));
          for (std::size_t i = 0; i < numbers.size(); i += list_columns)
            if (!take({numbers[i],
                       numbers[i + 1],
                       numbers[i + 2],
                       row + 1 + static_cast<int>(i / list_columns),
                       {}}))
              return;
        }
      }};
  const auto index = known_of_file<ListIndex>(
      path, name, [&] { return index_of_list(source); });
  if (!index->is_list())
    refuse_possible_list(name, columns, static_cast<std::size_t>(n_rows));
  return list_row_file(source, index, scale);
}

} // namespace asperity::surfaces
