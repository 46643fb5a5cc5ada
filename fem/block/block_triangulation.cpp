#include "fem/block/block_triangulation.hpp"

#include "base/require.hpp"
#include "fem/parallel/ranks.hpp"

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace asperity::fem {
namespace {

using dealii::CellData;
using dealii::Point;
using dealii::SubCellData;

/// The arguments of create_triangulation.
struct CoarseMesh {
  std::vector<Point<3>> vertices;
  std::vector<CellData<3>> cells;
  SubCellData boundary;
};

/// Appends the mesh or its mirror image about z = 0. For the mirror image the
/// vertices of a cell are reordered so that the cell remains right-handed.
void append(const meshes::BlockMesh& mesh, bool is_mirrored,
            CoarseMesh& coarse) {
  const bool is_hexahedral = mesh.shape == meshes::CellShape::hexahedron;
  const std::array<unsigned int, 8> mirrored =
      is_hexahedral ? std::array<unsigned int, 8>{4, 5, 6, 7, 0, 1, 2, 3}
                    : std::array<unsigned int, 8>{0, 2, 1, 3, 4, 5, 6, 7};
  const auto first = static_cast<unsigned int>(coarse.vertices.size());
  for (const meshes::Place& place : mesh.vertices)
    coarse.vertices.emplace_back(place[0], place[1],
                                 is_mirrored ? -place[2] : place[2]);
  for (const auto& vertices : mesh.cells) {
    CellData<3> cell(is_hexahedral ? 8 : 4);
    for (unsigned int i = 0; i < cell.vertices.size(); ++i)
      cell.vertices[i] = first + vertices[is_mirrored ? mirrored[i] : i];
    coarse.cells.push_back(std::move(cell));
  }
  for (const meshes::BoundaryFace& face : mesh.faces) {
    CellData<2> side(is_hexahedral ? 4 : 3);
    for (unsigned int i = 0; i < side.vertices.size(); ++i)
      side.vertices[i] = first + face.vertices[i];
    side.boundary_id = boundary_of(face.group);
    coarse.boundary.boundary_quads.push_back(std::move(side));
  }
}

/// @param is_first_only  whether the cells of negative z stay as they are
void refine(dealii::Triangulation<3>& triangulation,
            const std::vector<double>& refine_below, bool is_first_only) {
  for (const double depth : refine_below) {
    for (const auto& cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && std::abs(cell->center()[2]) < depth &&
          !(is_first_only && cell->center()[2] < 0.0))
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
  }
}

} // namespace

std::unique_ptr<dealii::parallel::TriangulationBase<3>>
make_triangulation(const meshes::BlockMesh& mesh, bool has_counter,
                   const std::optional<meshes::BlockMesh>& counter,
                   bool is_fixed) {
  if (mesh.cells.empty())
    refuse_argument("number of cells", 0.0, "at least 1");
  const bool is_hexahedral = mesh.shape == meshes::CellShape::hexahedron;
  if (!is_hexahedral && !mesh.refine_below.empty())
    refuse_argument("number of refinements of tetrahedra",
                    static_cast<double>(mesh.refine_below.size()), "0");
  if (counter && counter->shape != mesh.shape)
    throw std::domain_error(
        "a counter-body of its own mesh consists of hexahedra, and so must the "
        "block: choose cells = \"hexahedra\"");
  CoarseMesh coarse;
  append(mesh, false, coarse);
  if (has_counter)
    append(counter ? *counter : mesh, !counter, coarse);

  std::unique_ptr<dealii::parallel::TriangulationBase<3>> triangulation;
  if (is_hexahedral)
    dealii::GridTools::consistently_order_cells(coarse.cells);
  const bool is_whole = is_fixed && n_ranks() == 1 && mesh.refine_below.empty();
  if (is_hexahedral && !is_whole) {
    // p4est limits the difference at vertices in any case. With this smoothing,
    // the flags of cells say beforehand what p4est is going to do.
    triangulation =
        std::make_unique<dealii::parallel::distributed::Triangulation<3>>(
            MPI_COMM_WORLD,
            dealii::Triangulation<3>::limit_level_difference_at_vertices);
  } else {
    triangulation =
        std::make_unique<dealii::parallel::shared::Triangulation<3>>(
            MPI_COMM_WORLD);
  }
  triangulation->create_triangulation(coarse.vertices, coarse.cells,
                                      coarse.boundary);
  refine(*triangulation, mesh.refine_below, counter.has_value());
  return triangulation;
}

} // namespace asperity::fem
