#include "fem/linear/box_grid_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::fem {
namespace {

/// Number of equal leading vertices in one direction: how often `is_next`
/// holds from the first vertex on.
template <class IsNext>
std::size_t count_steps(std::size_t most, const IsNext& is_next) {
  std::size_t steps = 0;
  while (steps + 1 < most && is_next(steps + 1))
    ++steps;
  return steps;
}

/// The cells along each axis if the vertices are numbered x fastest, then y.
std::array<std::size_t, 3> cells_along(const meshes::BlockMesh& mesh) {
  const auto& vertices = mesh.vertices;
  const std::size_t x = count_steps(vertices.size(), [&](std::size_t i) {
    return vertices[i][0] > vertices[i - 1][0];
  });
  const std::size_t y =
      count_steps(vertices.size() / (x + 1), [&](std::size_t j) {
        return vertices[j * (x + 1)][1] > vertices[(j - 1) * (x + 1)][1];
      });
  return {x, y, vertices.size() / (x + 1) / (y + 1) - 1};
}

/// Whether every vertex and every cell is where layered_mesh puts it.
bool is_layered_mesh(const meshes::BlockMesh& mesh,
                     const std::array<std::size_t, 3>& cells) {
  const std::size_t n_x = cells[0], n_y = cells[1], n_z = cells[2];
  if (n_x * n_y * n_z == 0 || mesh.cells.size() != n_x * n_y * n_z ||
      mesh.vertices.size() != (n_x + 1) * (n_y + 1) * (n_z + 1))
    return false;
  const double width_x = mesh.length_x / static_cast<double>(n_x);
  const double width_y = mesh.length_y / static_cast<double>(n_y);
  const double rounding = 1e-9 * std::min(width_x, width_y);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const std::size_t plane = i / (n_x + 1) / (n_y + 1);
    const meshes::Place& first = mesh.vertices[plane * (n_x + 1) * (n_y + 1)];
    const meshes::Place& place = mesh.vertices[i];
    const auto x = static_cast<double>(i % (n_x + 1));
    const auto y = static_cast<double>(i / (n_x + 1) % (n_y + 1));
    if (std::abs(place[0] - x * width_x) > rounding ||
        std::abs(place[1] - y * width_y) > rounding || place[2] != first[2])
      return false;
  }
  const auto at = [&](std::size_t x, std::size_t y, std::size_t z) {
    return static_cast<unsigned int>(x + (n_x + 1) * (y + (n_y + 1) * z));
  };
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const std::size_t x = i % n_x, y = i / n_x % n_y, z = i / n_x / n_y;
    for (unsigned int v = 0; v < 8; ++v)
      if (mesh.cells[i][v] != at(x + v % 2, y + v / 2 % 2, z + v / 4))
        return false;
  }
  return true;
}

CellModuli cell_moduli(const Moduli& moduli) {
  return {moduli.lame_modulus, moduli.shear_modulus};
}

/// Keeps one pair of moduli per layer if no layer has two.
void join_equal_moduli(BoxGrid& box_grid) {
  std::vector<CellModuli> of_layer;
  const std::size_t cells = box_grid.moduli.size() / box_grid.thickness.size();
  for (std::size_t i = 0; i < box_grid.moduli.size(); ++i) {
    if (i % cells == 0)
      of_layer.push_back(box_grid.moduli[i]);
    if (!(box_grid.moduli[i] == of_layer.back()))
      return;
  }
  box_grid.moduli = of_layer;
}

} // namespace

std::optional<BoxGrid> box_grid_of(const BlockProblem& problem) {
  const meshes::BlockMesh& mesh = problem.mesh;
  if (problem.counter || !mesh.refine_below.empty() ||
      mesh.shape != meshes::CellShape::hexahedron || mesh.vertices.size() < 8)
    return {};
  const std::array<std::size_t, 3> cells = cells_along(mesh);
  if (!is_layered_mesh(mesh, cells))
    return {};
  BoxGrid box_grid;
  box_grid.degree = problem.degree;
  box_grid.cells_x = static_cast<int>(cells[0]);
  box_grid.cells_y = static_cast<int>(cells[1]);
  box_grid.length_x = mesh.length_x;
  box_grid.length_y = mesh.length_y;
  box_grid.is_periodic = problem.sides == mechanics::BlockSides::periodic;
  box_grid.holds_lateral =
      problem.far_boundary == mechanics::FarBoundary::clamped;
  box_grid.holds_normal =
      problem.far_boundary != mechanics::FarBoundary::pressure;
  const std::size_t plane = (cells[0] + 1) * (cells[1] + 1);
  for (std::size_t k = 0; k < cells[2]; ++k)
    box_grid.thickness.push_back(mesh.vertices[(k + 1) * plane][2] -
                                 mesh.vertices[k * plane][2]);
  for (const auto& vertices : mesh.cells) {
    meshes::Place centre{};
    for (const unsigned int vertex : vertices)
      for (std::size_t axis = 0; axis < 3; ++axis)
        centre[axis] += 0.125 * mesh.vertices[vertex][axis];
    box_grid.moduli.push_back(cell_moduli(problem.moduli.at(centre)));
  }
  join_equal_moduli(box_grid);
  return box_grid;
}

} // namespace asperity::fem
