#include "surfaces/formats/matrix_map.hpp"

#include "surfaces/formats/map_format.hpp"
#include "surfaces/formats/npy.hpp"
#include "surfaces/formats/text/xyz_list.hpp"

#include <numeric>
#include <utility>

namespace asperity::surfaces {

OpenMap map_of_matrix(OpenMap numbers, const std::string& name,
                      const std::string& what, mechanics::MapFormat format,
                      const MapScale& scale) {
  const Grid points = numbers.grid;
  if (format == mechanics::MapFormat::automatic && points.points_x <= 3) {
    NumberTable table;
    table.name = name;
    table.columns = static_cast<std::size_t>(points.points_x);
    table.numbers = numbers.rows(0, points.points_y);
    table.lines.resize(static_cast<std::size_t>(points.points_y));
    std::iota(table.lines.begin(), table.lines.end(), 1);
    if (is_regular_list(table)) {
      OpenMap list = map_of_list(table, scale);
      list.channel = numbers.channel;
      list.reader = numbers.reader;
      return list;
    }
    refuse_possible_list(name, table.columns, table.rows());
  }
  numbers.grid = grid_by_scale(points, name, what, scale);
  numbers.numbers.unit = *scale.height_unit;
  numbers.rows = [rows = std::move(numbers.rows),
                  unit = *scale.height_unit](int first, int count) {
    std::vector<double> heights = rows(first, count);
    for (double& height : heights)
      height *= unit;
    return heights;
  };
  return numbers;
}

OpenMap open_npy(const MapBytes& bytes, const ScanRequest& request) {
  const NpyLayout layout = npy_layout(bytes);
  require_sound_grid(bytes.name(), static_cast<std::int64_t>(layout.columns),
                     static_cast<std::int64_t>(layout.rows), 1.0,
                     layout.rows * layout.columns);
  const Grid points{static_cast<int>(layout.columns),
                    static_cast<int>(layout.rows), 0.0, 0.0};
  OpenMap map = map_of_matrix({points, "", "own reader of .npy",
                               [bytes, layout](int first, int count) {
                                 return npy_rows(bytes, layout, first, count);
                               }},
                              bytes.name(), "an .npy file", request.format,
                              request.scale);
  refuse_channel(request, "", bytes.name());
  return map;
}

std::vector<ChannelInfo> npy_channels(const MapBytes& bytes) {
  const NpyLayout layout = npy_layout(bytes);
  return {{"", "", static_cast<int>(layout.columns),
           static_cast<int>(layout.rows)}};
}

} // namespace asperity::surfaces
