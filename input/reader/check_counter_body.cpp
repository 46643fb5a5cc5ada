// Checks [mesh.counter] against the rest of the case.
#include "base/require.hpp"
#include "input/reader/read_parts.hpp"
#include "mechanics/counter_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::cases {
namespace {

/// The length of the equal cells along a side at the contact surface [m]; 0 if
/// only gmsh and the author of a mesh file determine it.
double edge_of(const Case& read, const mechanics::FemSettings& fem,
               const mechanics::Scales& scales, const Grid& grid) {
  if (!fem.full.uses_case_mesh || read.mesh.kind != mechanics::MeshKind::gmsh) {
    const int cells = grid.points_x / degree_of(fem.block.element);
    return grid.length_x / cells;
  }
  const bool has_columns =
      (read.mesh.geometry == mechanics::MeshGeometry::block ||
       read.mesh.geometry == mechanics::MeshGeometry::layered);
  const double size = read.mesh.size_at_contact.in_si(scales);
  if (!has_columns || !(size > 0.0))
    return 0.0;
  constexpr double roundoff = 1e-9;
  return grid.length_x /
         std::max(1.0, std::ceil(grid.length_x / size - roundoff));
}

/// Where the number of a mistake is written, and how: a default and the radius
/// of a sphere have no key of the table.
void add_mistake(const Node& file, const mechanics::CounterMistake& mistake,
                 Mistakes& mistakes) {
  const Node& table = entry_of(file, "mesh", "counter");
  const Node* number = table.find(mistake.key);
  if (number == nullptr && mistake.key == "radius") {
    const Node& surface = *file.find("surface");
    number = surface.find(
        surface.find("form_radius") == nullptr ? "radius" : "form_radius");
  }
  if (number == nullptr)
    mistakes.add(table.place,
                 fmt::format("mesh.counter.{} is not given and is {} m by "
                             "default, but must be {}",
                             mistake.key, number_text(mistake.value),
                             mistake.rule));
  else
    mistakes.add(number->place,
                 fmt::format("{} = {}, which is {} m, but must be {}",
                             number->path, written(*number),
                             number_text(mistake.value), mistake.rule));
}

} // namespace

void check_counter_body(const Node& file, const Case& read,
                        const mechanics::FemSettings& fem, const Grid& grid,
                        Mistakes& mistakes) {
  if (!mistakes.empty())
    return;
  mechanics::Scales scales;
  scales.length = grid.length_x;
  scales.spacing = grid.spacing_x();
  const mechanics::OpposedBlock block{grid.length_x, grid.length_y,
                                      fem.full.sides,
                                      edge_of(read, fem, scales, grid)};
  const mechanics::CounterBody body =
      mechanics::counter_body_of(*read.mesh.counter, scales, block);
  auto mistake = mechanics::mistake_in(body);
  if (!mistake)
    mistake = mechanics::mistake_in(body, block);
  if (mistake)
    add_mistake(file, *mistake, mistakes);
}

} // namespace asperity::cases
