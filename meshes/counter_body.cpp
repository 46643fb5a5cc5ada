#include "meshes/counter_body.hpp"

#include "base/require.hpp"
#include "meshes/counter_places.hpp"
#include "meshes/facets.hpp"
#include "meshes/mesh_quality.hpp"
#include "meshes/valid_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace asperity::meshes {
namespace {

using mechanics::CounterShape;

/// Collects cells of nodes, each node once.
class BodyCells {
public:
  BodyCells(const CounterBody& body, BlockMesh& mesh)
      : body_(body), places_(body), mesh_(mesh) {}

  void add_all() {
    const int n = places_.across();
    for (int k = 0; k < places_.down(); ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          add({{{0, i, j, k},
                {0, i + 1, j, k},
                {0, i, j + 1, k},
                {0, i + 1, j + 1, k}}},
              {0, 0, 0, 1});
    const int n_shells = places_.n_fans() + places_.n_rings();
    for (int shell = 0; shell < n_shells; ++shell) {
      add_sides(shell);
      if (shell < places_.n_fans())
        add_bottom(shell);
    }
    mesh_.cell_group.assign(mesh_.cells.size(), 0);
  }

private:
  using Four = std::array<BodyNode, 4>;

  void add_sides(int shell) {
    const int n = places_.across();
    for (int k = 0; k < places_.down(); ++k)
      for (int i = 0; i < n; ++i)
        for (const int end : {0, n}) {
          add({{{shell, i, end, k},
                {shell, i + 1, end, k},
                {shell, i, end, k + 1},
                {shell, i + 1, end, k + 1}}},
              {1, 0, 0, 0});
          add({{{shell, end, i, k},
                {shell, end, i + 1, k},
                {shell, end, i, k + 1},
                {shell, end, i + 1, k + 1}}},
              {1, 0, 0, 0});
        }
  }

  void add_bottom(int shell) {
    const int n = places_.across();
    const int k = places_.down();
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        add({{{shell, i, j, k},
              {shell, i + 1, j, k},
              {shell, i, j + 1, k},
              {shell, i + 1, j + 1, k}}},
            {1, 0, 0, 0});
  }

  unsigned int number_of(const BodyNode& node) {
    const auto [entry, is_new] = numbers_.try_emplace(
        node, static_cast<unsigned int>(mesh_.vertices.size()));
    if (is_new) {
      const Place place = places_(node);
      mesh_.vertices.push_back(
          {place[0] + body_.centre_x, place[1] + body_.centre_y, place[2]});
    }
    return entry->second;
  }

  /// Adds the cell between four nodes and the same four moved by a step, with
  /// the vertices in a right-handed order.
  void add(const Four& four, const BodyNode& step) {
    std::array<unsigned int, 8> cell{};
    for (std::size_t v = 0; v < 4; ++v) {
      BodyNode moved = four[v];
      moved.shell += step.shell;
      moved.k += step.k;
      cell[v] = number_of(four[v]);
      cell[v + 4] = number_of(moved);
    }
    mesh_.cells.push_back(cell);
    if (cell_shape(mesh_, mesh_.cells.size() - 1) < 0.0)
      std::swap_ranges(mesh_.cells.back().begin(),
                       mesh_.cells.back().begin() + 4,
                       mesh_.cells.back().begin() + 4);
  }

  const CounterBody& body_;
  BodyPlaces places_;
  BlockMesh& mesh_;
  std::map<BodyNode, unsigned int> numbers_;
};

void add_faces(const CounterBody& body, BlockMesh& mesh) {
  const double tolerance = 1e-9 * body.height;
  for (const Facet& facet : boundary_facets(mesh)) {
    BoundaryFace face{facet.vertices, FaceGroup::sides};
    const auto all = [&](const auto& holds) {
      return std::ranges::all_of(facet.vertices, [&](unsigned int v) {
        return holds(mesh.vertices[v]);
      });
    };
    if (all([&](const Place& p) { return p[2] < -body.height + tolerance; }))
      face.group = FaceGroup::far_boundary;
    else if (all([&](const Place& p) {
               const double r =
                   std::hypot(p[0] - body.centre_x, p[1] - body.centre_y);
               if (body.shape != CounterShape::sphere)
                 return p[2] > -tolerance;
               return std::abs(std::hypot(r, p[2] + body.radius) -
                               body.radius) < tolerance;
             }))
      face.group = FaceGroup::contact;
    mesh.faces.push_back(face);
  }
}

void check_body(const CounterBody& body) {
  if (const auto mistake = mechanics::mistake_in(body))
    refuse_argument("mesh.counter." + mistake->key, mistake->value,
                    mistake->rule);
}

} // namespace

BlockMesh counter_body(const CounterBody& body) {
  check_body(body);
  BlockMesh mesh;
  mesh.length_x = mesh.length_y = 2.0 * mechanics::half_width(body);
  mesh.depth = body.height;
  mesh.group_names = {"counter"};
  BodyCells(body, mesh).add_all();
  require_positive_cells(mesh);
  add_faces(body, mesh);
  return mesh;
}

double counter_nodes(const CounterBody& body, int degree) {
  check_body(body);
  const BodyPlaces places(body);
  const double across = degree * places.across();
  const double down = degree * places.down();
  const double sides = 4.0 * across * (down + 1.0);
  const double bottom = (across - 1.0) * (across - 1.0);
  return (across + 1.0) * (across + 1.0) * (down + 1.0) +
         degree *
             (places.n_fans() * (sides + bottom) + places.n_rings() * sides);
}

} // namespace asperity::meshes
