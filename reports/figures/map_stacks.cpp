#include "reports/figures/map_stacks.hpp"

#include <fmt/format.h>

namespace asperity::reports {

MapStack stack_on(const Grid& grid) {
  MapStack stack;
  stack.right = grid.length_x * 1e6;
  stack.upper = grid.length_y * 1e6;
  return stack;
}

PackedMap add_map(MapStack& stack, const Grid& grid,
                  const results::MapView& map, double unit, int most) {
  return add_reduced(stack, reduced(grid, map, most), unit);
}

PackedMap add_reduced(MapStack& stack, ReducedMap small, double unit) {
  stack.columns = small.columns;
  stack.rows = small.rows;
  for (double& value : small.values)
    value /= unit;
  return packed_map(small.values, static_cast<std::size_t>(small.columns));
}

MapStack contact_stack(const std::vector<const results::Fields*>& maps,
                       const SurfaceScales& scales) {
  MapStack stack = stack_on(maps.front()->grid);
  stack.quantities = {{"pressure / (E* h')", "pressure", true},
                      {"gap / h_rms", "gap", false}};
  const std::vector<std::size_t> chosen = stack_frames(maps.size());
  const int most = stack_side(chosen.size());
  const double stress = scales.contact_modulus * scales.rms_slope; // E* h'
  for (const std::size_t i : chosen) {
    const results::Fields& fields = *maps[i];
    if (fields.grid != maps.front()->grid)
      continue;
    stack.frames.push_back(
        {fmt::format("p / E* = {:.3g}",
                     fields.nominal_pressure / scales.contact_modulus),
         {add_map(stack, fields.grid, fields.pressure_map(), stress, most),
          add_map(stack, fields.grid, fields.gap_map(), scales.rms_height,
                  most)}});
  }
  return stack;
}

MapStack height_stack(const Grid& grid, const results::MapView& heights) {
  MapStack stack = stack_on(grid);
  stack.quantities = {{"height [nm]", "height", false}};
  const PackedMap map = add_map(stack, grid, heights, 1e-9, stack_side(1));
  stack.frames.push_back({"", {map}});
  return stack;
}

} // namespace asperity::reports
