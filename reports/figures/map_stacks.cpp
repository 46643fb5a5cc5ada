#include "reports/figures/map_stacks.hpp"

#include "reports/figures/map_image.hpp"

#include <cmath>

namespace asperity::reports {

MapStack stack_on(const Grid& grid) {
  MapStack stack;
  stack.right = grid.length_x * 1e6;
  stack.upper = grid.length_y * 1e6;
  return stack;
}

PackedMap add_map(MapStack& stack, const Grid& grid,
                  const results::MapView& map, double unit, int most) {
  PackedMap packed = add_reduced(stack, reduced(grid, map, most), unit);
  if (most > most_image_points) {
    const MapImage on_paper = map_image(grid, map, unit);
    packed.shown_low = on_paper.least;
    packed.shown_high = on_paper.largest;
  }
  return packed;
}

PackedMap add_reduced(MapStack& stack, ReducedMap small, double unit) {
  stack.columns = small.columns;
  stack.rows = small.rows;
  for (double& value : small.values)
    value /= unit;
  return packed_map(small.values, static_cast<std::size_t>(small.columns));
}

MapUnits map_units(std::span<const results::Fields> maps,
                   const FigureScales& scales) {
  const double stress = scales.contact_modulus * scales.rms_slope; // E* h'
  const double largest =
      results::extremes_of(maps.back().pressure_map()).largest;
  const double widest = results::extremes_of(maps.front().gap_map()).largest;
  ChartPanel axes{.x = pressure_axis("pressure p / (E* h')", "pressure p",
                                     stress, largest / stress),
                  .y =
                      length_axis("gap g / h_{rms}", "gap g", scales.rms_height,
                                  widest / scales.rms_height)};
  constexpr double least_shown = 1e-3;
  const double smallest =
      results::extremes_of(maps.back().pressure_map()).least;
  MapUnits units{.pressure = stress,
                 .gap = scales.rms_height,
                 .has_tension = smallest < -least_shown * std::abs(largest)};
  if (scales.is_physical) {
    units.pressure /= axes.x.other->factor;
    units.gap /= axes.y.other->factor;
    use_other_units(axes);
  }
  units.quantities = {
      {.label = axes.x.label,
       .colors = units.has_tension ? "height" : "pressure",
       .other = axes.x.other},
      {.label = "contact", .colors = "contact"},
      {.label = axes.y.label, .colors = "gap", .other = axes.y.other}};
  return units;
}

MapStack contact_stack(std::span<const results::Fields> maps,
                       const FigureScales& scales, const MapUnits& units,
                       const mechanics::ContactCriterion& criterion) {
  MapStack stack = stack_on(maps.front().grid);
  stack.quantities = units.quantities;
  const std::vector<std::size_t> chosen = stack_frames(maps.size());
  const int most = stack_side(chosen.size());
  for (const std::size_t i : chosen) {
    const results::Fields& fields = maps[i];
    if (fields.grid != maps.front().grid)
      continue;
    stack.frames.push_back(
        {load_text(scales, fields.nominal_pressure),
         {add_map(stack, fields.grid, fields.pressure_map(), units.pressure,
                  most),
          add_reduced(stack,
                      reduced_contact(fields.grid, fields.pressure_map(),
                                      fields.gap_map(), criterion, most),
                      1.0),
          add_map(stack, fields.grid, fields.gap_map(), units.gap, most)}});
  }
  return stack;
}

MapStack height_stack(const Grid& grid, const results::MapView& heights) {
  MapStack stack = stack_on(grid);
  stack.quantities = {{.label = "height [nm]", .colors = "height"}};
  const PackedMap map = add_map(stack, grid, heights, 1e-9, stack_side(1));
  stack.frames.push_back({"", {map}});
  return stack;
}

} // namespace asperity::reports
