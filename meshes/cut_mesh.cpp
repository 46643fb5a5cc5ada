#include "meshes/cut_mesh.hpp"

#include "meshes/facets.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace asperity::meshes {
namespace {

/// Performs one pass, in which the mesh above one depth is cut once. Each of
/// the 3 x 3 x 3 (or 3 x 3) vertices of the children is the mean of the
/// parent's corners that agree with its place: the index 1 in a direction (the
/// middle) agrees with both ends.
class Cutter {
public:
  explicit Cutter(BlockMesh mesh) : mesh_(std::move(mesh)) {}

  void cut_above(double depth) {
    BlockMesh before = std::move(mesh_);
    mesh_ = before;
    mesh_.cells.clear();
    mesh_.cell_group.clear();
    mesh_.faces.clear();
    for (std::size_t cell = 0; cell < before.cells.size(); ++cell)
      if (centre_of_cell(before, cell)[2] < depth)
        cut_cell(before.cells[cell], before.cell_group[cell]);
      else
        keep_cell(before.cells[cell], before.cell_group[cell]);
    for (const BoundaryFace& face : before.faces)
      add_face(face);
  }

  BlockMesh take() { return std::move(mesh_); }

private:
  using Corners = std::array<unsigned int, 8>;
  static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

  /// The corners among the 2^n_directions that agree with a place, sorted.
  template <std::size_t size>
  static Corners agreeing(const std::array<unsigned int, size>& corners,
                          const std::array<unsigned int, 3>& place) {
    Corners found{};
    found.fill(none);
    std::size_t count = 0;
    for (std::size_t corner = 0; corner < size; ++corner) {
      bool agrees = true;
      for (std::size_t d = 0; (std::size_t{1} << d) < size; ++d)
        agrees =
            agrees && (place[d] == 1 || place[d] / 2 == (corner >> d & 1U));
      if (agrees)
        found[count++] = corners[corner];
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  unsigned int vertex_between(const Corners& corners) {
    if (corners[1] == none)
      return corners[0];
    const auto [found, is_new] = middles_.try_emplace(
        corners, static_cast<unsigned int>(mesh_.vertices.size()));
    if (is_new) {
      const auto count =
          std::find(corners.begin(), corners.end(), none) - corners.begin();
      Place mean{};
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        for (std::size_t d = 0; d < 3; ++d)
          mean[d] += mesh_.vertices[corners[i]][d] / static_cast<double>(count);
      mesh_.vertices.push_back(mean);
    }
    return found->second;
  }

  void cut_cell(const Corners& cell, int group) {
    for (unsigned int child = 0; child < 8; ++child) {
      Corners vertices{};
      for (unsigned int corner = 0; corner < 8; ++corner)
        vertices[corner] = vertex_between(
            agreeing(cell, {(child & 1U) + (corner & 1U),
                            (child >> 1 & 1U) + (corner >> 1 & 1U),
                            (child >> 2) + (corner >> 2)}));
      keep_cell(vertices, group);
    }
  }

  void keep_cell(const Corners& cell, int group) {
    mesh_.cells.push_back(cell);
    mesh_.cell_group.push_back(group);
  }

  /// Adds a boundary face. It belongs to one cell only, so it was cut if and
  /// only if there is a vertex at its middle.
  void add_face(const BoundaryFace& face) {
    if (!middles_.contains(agreeing(face.vertices, {1, 1, 0}))) {
      mesh_.faces.push_back(face);
      return;
    }
    for (unsigned int child = 0; child < 4; ++child) {
      BoundaryFace part{{}, face.group};
      for (unsigned int corner = 0; corner < 4; ++corner)
        part.vertices[corner] = vertex_between(
            agreeing(face.vertices, {(child & 1U) + (corner & 1U),
                                     (child >> 1) + (corner >> 1), 0}));
      mesh_.faces.push_back(part);
    }
  }

  BlockMesh mesh_;
  std::map<Corners, unsigned int> middles_; ///< by the corners around it
};

} // namespace

BlockMesh cut_mesh(const BlockMesh& mesh) {
  if (mesh.refine_below.empty())
    return mesh;
  if (mesh.shape != CellShape::hexahedron)
    throw std::domain_error("mesh: hanging nodes (refine_below) are supported "
                            "for hexahedra only, but the cells are tetrahedra");
  Cutter cutter(mesh);
  for (const double depth : mesh.refine_below)
    cutter.cut_above(depth);
  BlockMesh cut = cutter.take();
  cut.refine_below.clear();
  return cut;
}

} // namespace asperity::meshes
