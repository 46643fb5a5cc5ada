#include "app/plan/block_size.hpp"

#include "base/special_numbers.hpp"
#include "meshes/counter_body.hpp"
#include "meshes/gmsh_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::app {
namespace {

using mechanics::MeshGeometry;

std::vector<double> interfaces_of(const cases::Case& contact_case,
                                  const mechanics::Scales& scales) {
  return meshes::interfaces_of(contact_case.material.layers, scales);
}

/// Returns the number of nodes of n_x by n_y by n_z hexahedra of that degree.
double nodes_of(double n_x, double n_y, double n_z, double degree) {
  return (degree * n_x + 1.0) * (degree * n_y + 1.0) * (degree * n_z + 1.0);
}

BlockSize boxes(double n_x, double n_y, double n_z, double degree) {
  return {n_x * n_y * n_z, 3.0 * nodes_of(n_x, n_y, n_z, degree),
          degree * std::sqrt(n_x * n_y)};
}

/// Counts a mesh with hanging nodes level by level; each cell is an eighth of
/// its parent. Between two levels the vertices of the coarser cells are nodes
/// of the finer ones. Elements of second order have additional nodes on the
/// edges and faces of the coarser level.
BlockSize hanging(const Grid& cells, double depth, int cells_a_level,
                  double degree) {
  const meshes::BlockMesh mesh =
      meshes::hanging_mesh(cells, depth, cells_a_level);
  const std::size_t n_levels = mesh.refine_below.size();
  const double coarsest = std::ldexp(1.0, static_cast<int>(n_levels));
  const double coarse_layers = static_cast<double>(mesh.cells.size()) /
                               static_cast<double>(cells.size()) * coarsest *
                               coarsest;
  BlockSize size;
  size.nodes_per_side = degree * std::sqrt(static_cast<double>(cells.size()));
  double top = 0.0;
  for (std::size_t level = 0; level <= n_levels; ++level) {
    const double edge = std::ldexp(1.0, static_cast<int>(level));
    const double bottom =
        level < n_levels ? mesh.refine_below[n_levels - 1 - level] : depth;
    const double n_x = cells.points_x / edge;
    const double n_y = cells.points_y / edge;
    const double n_z =
        std::round((bottom - top) / depth * coarse_layers * coarsest / edge);
    const double shared = level == 0 ? 0.0 : (n_x + 1.0) * (n_y + 1.0);
    size.cells += n_x * n_y * n_z;
    size.unknowns += 3.0 * (nodes_of(n_x, n_y, n_z, degree) - shared);
    top = bottom;
  }
  return size;
}

/// Cells at planes between layers, where two layers of cells on each side have
/// the size of which the plane is a boundary, and at the surface of an
/// inclusion (fem/adaptive/material_marks.hpp).
double cells_for_materials(const cases::Case& contact_case,
                           const mechanics::Scales& scales, const Grid& cells,
                           double depth) {
  constexpr double layers_of_cells = 4.0;
  const int halvings = contact_case.mesh.halvings;
  const double coarsest =
      std::ldexp(0.5 * (cells.spacing_x() + cells.spacing_y()), halvings);
  const double face = cells.length_x * cells.length_y;
  double count = 0.0;
  double above = 0.0;
  for (const double interface : interfaces_of(contact_case, scales)) {
    const double edge = std::clamp(interface - above,
                                   std::ldexp(coarsest, -halvings), coarsest);
    count += edge < coarsest ? layers_of_cells * face / (edge * edge) : 0.0;
    above = interface;
  }
  if (const auto& ball = contact_case.material.inclusion) {
    const double radius = ball->radius.in_si(scales);
    const double nearest = ball->depth.in_si(scales) - radius;
    const double edge = std::clamp(0.25 * std::min(radius, nearest),
                                   std::ldexp(coarsest, -halvings), coarsest);
    count += 8.0 * std::numbers::pi * std::pow(radius / edge, 2);
  }
  return std::min(count, face / (cells.spacing_x() * cells.spacing_y()) *
                             depth / cells.spacing_x());
}

/// Estimates the size of the last of the meshes that follow the contact. With 1
/// to 7 % of the surface in contact they had between a twelfth and two fifths
/// of the unknowns of the mesh with hanging nodes. A variation of the moduli
/// may need about all of these.
BlockSize adaptive(const cases::Case& contact_case,
                   const mechanics::Scales& scales, const Grid& cells,
                   double depth, double degree) {
  const double share = contact_case.material.variation ? 1.0 : 0.3;
  BlockSize size = hanging(cells, depth, 4, degree);
  const double more = cells_for_materials(contact_case, scales, cells, depth);
  size.cells = share * size.cells + more;
  size.unknowns = share * size.unknowns + 3.0 * std::pow(degree, 3) * more;
  return size;
}

/// Returns the number of cells along an edge whose cell size grows linearly
/// from one end to the other.
double cells_along(double length, double first, double last) {
  const double cells = std::abs(last - first) < 1e-9 * first
                           ? length / first
                           : length / (last - first) * std::log(last / first);
  return std::max(1.0, std::ceil(cells - 1e-9));
}

/// The mesh consists of a fine cube under the contact, five blocks that fan out
/// from it, and layers below.
BlockSize indentation(const mechanics::MeshSpec& mesh,
                      const mechanics::Scales& scales, const Grid& grid,
                      double depth, double degree) {
  const double fine = mesh.fine_radius.in_si(scales);
  const double near = mesh.size_at_contact.in_si(scales);
  const double far = mesh.size_far.in_si(scales);
  const double half = 0.5 * std::min(grid.length_x, grid.length_y);
  const double fan = depth <= 1.5 * half ? depth : half;
  const double across = cells_along(2.0 * fine, near, near);
  const double down = cells_along(fine, near, near);
  const double out = cells_along(std::min(half, fan) - fine, near, far);
  const double below = fan < depth ? cells_along(depth - fan, far, far) : 0.0;
  BlockSize size;
  size.cells =
      across * across * (down + out + below) + 4.0 * across * down * out;
  size.nodes_per_side = degree * (across + 2.0 * out);
  const double side = degree * across;
  size.unknowns = 3.0 * ((side + 1.0) * (side + 1.0) *
                             (degree * (down + out + below) + 1.0) +
                         4.0 * side * degree * out * degree * down);
  return size;
}

/// The mesh consists of columns and layers around a cubic box, which contains a
/// ball with a cube inside. Each block between them has as many cells across as
/// the box.
BlockSize inclusion(const cases::Case& contact_case,
                    const mechanics::Scales& scales, const Grid& grid,
                    double depth, double degree) {
  const double size = contact_case.mesh.size_at_contact.in_si(scales);
  const double far = contact_case.mesh.size_far.in_si(scales);
  const mechanics::MaterialInclusion& ball = *contact_case.material.inclusion;
  const double radius = ball.radius.in_si(scales);
  const double centre = ball.depth.in_si(scales);
  const double room = std::min(
      {0.5 * grid.length_x, 0.5 * grid.length_y, centre, depth - centre});
  const double half = std::min(1.5 * radius, 0.5 * (radius + room));
  const double across = cells_along(2.0 * half, size, size);
  const auto columns = [&](double length) {
    return across + 2.0 * cells_along(0.5 * length - half, size, size);
  };
  const double down = cells_along(centre - half, size, size) + across +
                      cells_along(depth - centre - half, size, far);
  BlockSize outer =
      boxes(columns(grid.length_x), columns(grid.length_y), down, degree);
  const double shells = cells_along(0.55 * radius, size, size) +
                        cells_along(half - radius, size, size);
  const double side = degree * across;
  outer.cells += 6.0 * across * across * shells;
  outer.unknowns += 3.0 * (6.0 * side * side + 2.0) * degree * shells;
  return outer;
}

/// Estimates the size of a tetrahedral mesh. The edge lengths scatter about the
/// prescribed size, which grows linearly with the depth. A regular tetrahedron
/// of edge s has the volume s^3/(6 sqrt 2), and there are six tetrahedra per
/// vertex.
BlockSize tetrahedra(const mechanics::MeshSpec& mesh,
                     const mechanics::Scales& scales, const Grid& grid,
                     double depth, double degree) {
  const double near = mesh.size_at_contact.in_si(scales);
  const double far = mesh.size_far.in_si(scales);
  double inverse_cube = 1.0 / (near * near * near); // mean of s^-3 over depth
  if (far > near)
    inverse_cube =
        0.5 * (1.0 / (near * near) - 1.0 / (far * far)) / (far - near);
  double volume = grid.length_x * grid.length_y * depth;
  if (mesh.geometry == MeshGeometry::indentation) {
    const double fine = mesh.fine_radius.in_si(scales);
    const double half_ball = 2.0 / 3.0 * std::numbers::pi * fine * fine * fine;
    volume = half_ball * 4.0; // the cells far from the contact are coarse and
                              // negligible
    inverse_cube = 1.0 / (near * near * near);
  }
  BlockSize size;
  size.cells = volume * inverse_cube * 6.0 * std::numbers::sqrt2;
  const double vertices = size.cells / 6.0;
  size.unknowns = 3.0 * vertices * (degree == 1.0 ? 1.0 : 8.0);
  size.nodes_per_side =
      degree * std::sqrt(grid.length_x * grid.length_y) / near;
  return size;
}

BlockSize by_gmsh(const cases::Case& contact_case,
                  const mechanics::Scales& scales, const Grid& grid,
                  double depth, double degree) {
  const mechanics::MeshSpec& mesh = contact_case.mesh;
  if (mesh.geometry == MeshGeometry::file)
    return {not_a_number, not_a_number, not_a_number};
  if (mesh.cells == mechanics::MeshCells::tetrahedra)
    return tetrahedra(mesh, scales, grid, depth, degree);
  if (mesh.geometry == MeshGeometry::indentation)
    return indentation(mesh, scales, grid, depth, degree);
  if (mesh.geometry == MeshGeometry::inclusion)
    return inclusion(contact_case, scales, grid, depth, degree);
  const double near = mesh.size_at_contact.in_si(scales);
  const double far = mesh.size_far.in_si(scales);
  std::vector<double> ends{0.0};
  if (mesh.geometry == MeshGeometry::layered)
    for (const double interface : interfaces_of(contact_case, scales))
      ends.push_back(interface);
  ends.push_back(depth);
  double layers = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    layers += cells_along(ends[i + 1] - ends[i],
                          std::lerp(near, far, ends[i] / depth),
                          std::lerp(near, far, ends[i + 1] / depth));
  return boxes(cells_along(grid.length_x, near, near),
               cells_along(grid.length_y, near, near), layers, degree);
}

/// Returns the number of cells of a counter-body, or 0 if it is refused.
double counter_cells(const mechanics::CounterMeshSpec& spec,
                     const mechanics::Scales& scales, const Grid& grid,
                     double degree) {
  const double size = spec.size_at_contact ? spec.size_at_contact->in_si(scales)
                                           : degree * grid.spacing_x();
  const double radius = spec.radius.in_si(scales);
  const double share =
      spec.shape == mechanics::CounterShape::sphere ? 0.25 : 1.0;
  try {
    return static_cast<double>(
        meshes::counter_body(
            {.shape = spec.shape,
             .radius = radius,
             .height = spec.height ? spec.height->in_si(scales) : radius,
             .size_at_contact = size,
             .size_far = std::max(size, spec.size_far.in_si(scales)),
             .fine_radius = spec.fine_radius ? spec.fine_radius->in_si(scales)
                                             : share * radius})
            .cells.size());
  } catch (const std::domain_error&) {
    return 0.0; // the run says what is wrong
  }
}

} // namespace

int n_layers(const cases::Case& contact_case,
             const mechanics::FemSettings& settings,
             const mechanics::Scales& scales, const Grid& grid) {
  return static_cast<int>(
      meshes::graded_layers_with_interfaces(
          settings.block.surface_cell_depth *
              degree_of(settings.block.element) * grid.spacing_x(),
          settings.block.growth, interfaces_of(contact_case, scales),
          settings.block.depth.in_si(scales))
          .size());
}

BlockSize block_size(const cases::Case& contact_case,
                     const mechanics::FemSettings& settings,
                     const mechanics::Scales& scales, const Grid& grid) {
  const double degree = degree_of(settings.block.element);
  const double depth = settings.block.depth.in_si(scales);
  const int step = static_cast<int>(degree);
  const Grid cells{grid.points_x / step, grid.points_y / step, grid.length_x,
                   grid.length_y};
  BlockSize size;
  if (settings.solver != mechanics::FemSolver::full ||
      !settings.full.uses_case_mesh ||
      contact_case.mesh.kind == mechanics::MeshKind::layers)
    size = boxes(cells.points_x, cells.points_y,
                 n_layers(contact_case, settings, scales, grid), degree);
  else if (contact_case.mesh.kind == mechanics::MeshKind::hanging)
    size = hanging(cells, depth, contact_case.mesh.cells_a_level, degree);
  else if (contact_case.mesh.kind == mechanics::MeshKind::adaptive)
    size = adaptive(contact_case, scales, cells, depth, degree);
  else
    size = by_gmsh(contact_case, scales, grid, depth, degree);
  if (settings.full.bodies == 2 && contact_case.mesh.counter) {
    const double n_cells =
        counter_cells(*contact_case.mesh.counter, scales, grid, degree);
    size.cells += n_cells;
    size.unknowns += 3.0 * degree * degree * degree * n_cells;
  } else {
    size.cells *= settings.full.bodies;
    size.unknowns *= settings.full.bodies;
  }
  return size;
}

} // namespace asperity::app
