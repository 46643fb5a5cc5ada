// Checks [mesh.counter] against the rest of the case.
#include "base/require.hpp"
#include "cases/reader/read_parts.hpp"
#include "mechanics/counter_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace asperity::cases {
namespace {

/// The block of a method with the smallest edge of its cells, which only gmsh
/// and the author of a mesh file determine otherwise.
mechanics::OpposedBlock block_of(const Case& read,
                                 const mechanics::FemSettings& fem,
                                 const Grid& grid) {
  const bool is_divided =
      !fem.full.uses_case_mesh || read.mesh.kind != mechanics::MeshKind::gmsh;
  const int cells = grid.points_x / degree_of(fem.block.element);
  return {grid.length_x, grid.length_y, fem.full.sides,
          is_divided ? grid.length_x / cells : 0.0};
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
  const mechanics::OpposedBlock block = block_of(read, fem, grid);
  const mechanics::CounterBody body =
      mechanics::counter_body_of(*read.mesh.counter, scales, block);
  auto mistake = mechanics::mistake_in(body);
  if (!mistake)
    mistake = mechanics::mistake_in(body, block);
  if (mistake)
    add_mistake(file, *mistake, mistakes);
}

} // namespace asperity::cases
