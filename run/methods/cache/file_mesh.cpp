#include "run/methods/cache/file_mesh.hpp"

#include "fem/plugin.hpp"
#include "input/input_error.hpp"
#include "mechanics/counter_body.hpp"
#include "meshes/facets.hpp"
#include "meshes/mesh_quality.hpp"
#include "meshes/valid_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

namespace asperity::methods {
namespace {

using mechanics::MeshSpec;
using meshes::BlockMesh;

[[noreturn]] void refuse(const cases::Case& contact_case,
                         const std::string& what) {
  const cases::Node* const key = contact_case.file->at("mesh.file");
  input::throw_mistake(key == nullptr ? input::Place{contact_case.path, 0}
                                      : key->place,
                       "mesh.file: " + what);
}

void require_rectangle(const BlockMesh& mesh) {
  constexpr double roundoff = 1e-6;
  const double covered =
      meshes::contact_area(mesh) / (mesh.length_x * mesh.length_y);
  if (covered < 1.0 - roundoff)
    throw std::domain_error(fmt::format(
        "mesh: the contact surface covers {:.3g} % of the rectangle of {:.6g} "
        "by {:.6g} m around it, but the heights of [surface] cover all of it: "
        "the group contact must be a rectangle with its edges along x and y; "
        "cut the block to one, or turn it",
        100.0 * covered, mesh.length_x, mesh.length_y));
}

void require_size(const BlockMesh& mesh, const MeshSpec& spec,
                  const Grid& grid) {
  if (is_same_length(mesh.length_x, grid.length_x) &&
      is_same_length(mesh.length_y, grid.length_y))
    return;
  const double right_x = spec.file_unit * grid.length_x / mesh.length_x;
  const double right_y = spec.file_unit * grid.length_y / mesh.length_y;
  constexpr double roundoff = 1e-6;
  const std::string advice =
      std::abs(right_x - right_y) <= roundoff * right_x
          ? fmt::format("they are equal with file_unit = \"{:.6g} m\"", right_x)
          : std::string("no file_unit makes them equal");
  throw std::domain_error(fmt::format(
      "mesh: the contact surface is {:.6g} by {:.6g} in the file and {:.6g} by "
      "{:.6g} m with file_unit = \"{:.6g} m\", but [surface] is {:.6g} by "
      "{:.6g} m; {}",
      mesh.length_x / spec.file_unit, mesh.length_y / spec.file_unit,
      mesh.length_x, mesh.length_y, spec.file_unit, grid.length_x,
      grid.length_y, advice));
}

/// Requires what the settings of a method need of a mesh.
void require_use(const BlockMesh& mesh, const mechanics::FemSettings& fem,
                 const cases::Case& contact_case, const Grid& grid) {
  if (mesh.shape == meshes::CellShape::tetrahedron) {
    if (fem.block.element == mechanics::Element::q2)
      throw std::domain_error(
          "mesh: the cells are tetrahedra, whose vertices have no area with "
          "element = \"Q2\"; element must be \"Q1\"");
    if (fem.full.bodies == 2 && contact_case.mesh.counter)
      throw std::domain_error("mesh: the cells are tetrahedra, but those of "
                              "mesh.counter and of its block are hexahedra");
  }
  if (fem.block.far_boundary != mechanics::FarBoundary::clamped)
    meshes::require_flat_support(mesh);
  if (fem.full.bodies != 2 || !contact_case.mesh.counter)
    return;
  const mechanics::OpposedBlock block{
      mesh.length_x, mesh.length_y, fem.full.sides,
      meshes::mesh_quality(mesh).contact_edges.smallest};
  mechanics::Scales scales{.length = grid.length_x,
                           .spacing = grid.spacing_x()};
  const auto mistake = mechanics::mistake_in(
      mechanics::counter_body_of(*contact_case.mesh.counter, scales, block),
      block);
  if (mistake)
    throw std::domain_error(
        fmt::format("mesh: beside this mesh mesh.counter.{} = {:g}, but must "
                    "be {}",
                    mistake->key, mistake->value, mistake->rule));
}

/// The mesh of a file, and as blocks use it.
struct MadeMesh {
  fem::FileMesh file;
  std::map<mechanics::BlockSides, BlockMesh> with_sides = {};
};

/// Returns the mesh that this process has made of the file. The caller holds
/// the lock.
MadeMesh& made_mesh(const cases::Case& contact_case) {
  static std::map<std::pair<std::string, double>, MadeMesh> made;
  const MeshSpec& spec = contact_case.mesh;
  const std::pair asked(spec.file, spec.file_unit);
  auto found = made.find(asked);
  if (found == made.end())
    found = made.emplace(asked, MadeMesh{fem::load_fem_module().mesh_file(
                                    spec.file, spec.file_unit)})
                .first;
  return found->second;
}

/// Lets one thread at a time make a mesh, and refuses a mesh by the line of its
/// key.
template <typename Work>
auto with_made_mesh(const cases::Case& contact_case, const Work& work) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  try {
    return work(made_mesh(contact_case));
  } catch (const std::domain_error& error) {
    const std::string what = error.what();
    const std::string& file = contact_case.mesh.file;
    refuse(contact_case, what.starts_with(file) ? what : file + ": " + what);
  }
}

} // namespace

std::string hash_of_mesh(const cases::Case& contact_case) {
  return with_made_mesh(contact_case,
                        [](MadeMesh& made) { return made.file.hash; });
}

std::optional<BlockMesh> file_mesh(const cases::Case& contact_case,
                                   const cases::MethodSpec& method,
                                   const Grid& grid) {
  const auto* fem = method.as<mechanics::FemSettings>();
  if (fem == nullptr || fem->solver != mechanics::FemSolver::full ||
      !fem->full.uses_case_mesh || contact_case.mesh.file.empty())
    return std::nullopt;
  return with_made_mesh(contact_case, [&](MadeMesh& made) {
    auto found = made.with_sides.find(fem->full.sides);
    if (found == made.with_sides.end()) {
      BlockMesh mesh = made.file.mesh;
      meshes::fit_sides(mesh, fem->full.sides);
      require_rectangle(mesh);
      found = made.with_sides.emplace(fem->full.sides, std::move(mesh)).first;
    }
    require_size(found->second, contact_case.mesh, grid);
    require_use(found->second, *fem, contact_case, grid);
    return found->second;
  });
}

} // namespace asperity::methods
