// Tests of the bytes with which rank 0 lets the other ranks build a block.
#include "fem/request_bytes.hpp"
#include "meshes/layered_mesh.hpp"

#include <gtest/gtest.h>

namespace asperity::fem::request_bytes_test {

using mechanics::ReferenceUnit;

/// Every member differs from its default, and no number has a short binary
/// form.
FullRequest unusual_request() {
  FullRequest request;
  request.grid = {4, 6, 1.1e-6, 1.7e-6};
  request.block = {mechanics::Element::q1,
                   0.7,
                   1.3,
                   {0.9, ReferenceUnit::spacing},
                   mechanics::FarBoundary::pressure};
  request.full = {mechanics::BlockSides::free,
                  LinearSolver::multigrid,
                  mechanics::ContactPoints::gauss,
                  mechanics::HeightInterpolation::bilinear,
                  true,
                  2};
  request.material.contact_modulus = 2.3e9;
  request.material.poisson_ratio = 0.31;
  request.material.counter = {71e9, 0.17};
  request.material.layers = {{{0.1, ReferenceUnit::length}, {3e9, 0.1}},
                             {{1e-7, ReferenceUnit::si}, {7e9, -0.3}}};
  request.material.inclusion = {
      {0.2, ReferenceUnit::length}, {0.4, ReferenceUnit::length}, {9e9, 0.27}};
  request.material.variation = mechanics::MaterialVariation{
      mechanics::VariationKind::random,
      "1 + x",
      0.3,
      0xfedcba9876543210U,
      mechanics::Quantity{3.0, ReferenceUnit::spacing},
      "factors.txt"};
  request.mesh = {mechanics::MeshKind::gmsh,
                  7,
                  5,
                  1.7,
                  4,
                  mechanics::MeshGeometry::inclusion,
                  mechanics::MeshCells::tetrahedra,
                  {1.9, ReferenceUnit::length},
                  {0.3, ReferenceUnit::spacing},
                  {0.7, ReferenceUnit::rms_height},
                  "block.msh",
                  1e-3,
                  true};
  request.mesh.counter = {mechanics::CounterShape::cuboid,
                          {0.6, ReferenceUnit::length},
                          {},
                          mechanics::Quantity{0.01, ReferenceUnit::length},
                          {0.02, ReferenceUnit::length},
                          {},
                          {-0.03, ReferenceUnit::length},
                          {1e-7, ReferenceUnit::si}};
  request.scales = {2.3e9, 1.1e-6, 2.75e-7, 1e-9, 0.1};
  return request;
}

meshes::BlockMesh small_mesh() {
  return meshes::layered_mesh({2, 2, 1e-6, 1e-6},
                              std::vector<double>{3e-7, 7e-7});
}

// Verifies that every member is restored to the last bit.
TEST(RequestBytes, RestoreTheRequest) {
  const FullRequest sent = unusual_request();
  const FullRequest got =
      request_of_bytes(bytes_of(sent, small_mesh())).request;
  EXPECT_EQ(got.grid.points_y, 6);
  EXPECT_EQ(got.grid.length_y, 1.7e-6);
  EXPECT_EQ(got.block.element, mechanics::Element::q1);
  EXPECT_EQ(got.block.surface_cell_depth, 0.7);
  EXPECT_EQ(got.block.depth.reference, ReferenceUnit::spacing);
  EXPECT_EQ(got.block.far_boundary, mechanics::FarBoundary::pressure);
  EXPECT_EQ(got.full.sides, mechanics::BlockSides::free);
  EXPECT_EQ(got.full.linear_solver, LinearSolver::multigrid);
  EXPECT_EQ(got.full.height_interpolation,
            mechanics::HeightInterpolation::bilinear);
  EXPECT_TRUE(got.full.uses_case_mesh);
  EXPECT_EQ(got.full.bodies, 2);
  EXPECT_EQ(got.material.poisson_ratio, 0.31);
  ASSERT_TRUE(got.material.counter);
  EXPECT_EQ(got.material.counter->youngs_modulus, 71e9);
  ASSERT_EQ(got.material.layers.size(), 2U);
  EXPECT_EQ(got.material.layers[0].thickness.value, 0.1);
  EXPECT_EQ(got.material.layers[1].moduli.poisson_ratio, -0.3);
  ASSERT_TRUE(got.material.inclusion);
  EXPECT_EQ(got.material.inclusion->depth.value, 0.4);
  ASSERT_TRUE(got.material.variation);
  EXPECT_EQ(got.material.variation->seed, 0xfedcba9876543210U);
  EXPECT_EQ(got.material.variation->factor, "1 + x");
  EXPECT_EQ(got.mesh.cells, mechanics::MeshCells::tetrahedra);
  EXPECT_EQ(got.mesh.fine_radius.reference, ReferenceUnit::rms_height);
  EXPECT_EQ(got.mesh.file, "block.msh");
  EXPECT_EQ(got.mesh.file_unit, 1e-3);
  EXPECT_TRUE(got.mesh.allow_commands);
  ASSERT_TRUE(got.mesh.counter);
  EXPECT_EQ(got.mesh.counter->shape, mechanics::CounterShape::cuboid);
  EXPECT_FALSE(got.mesh.counter->height);
  ASSERT_TRUE(got.mesh.counter->size_at_contact);
  EXPECT_EQ(got.mesh.counter->size_at_contact->value, 0.01);
  EXPECT_EQ(got.mesh.counter->offset_x.value, -0.03);
  EXPECT_EQ(got.scales.rms_slope, 0.1);
  EXPECT_EQ(bytes_of(got, small_mesh()), bytes_of(sent, small_mesh()));
}

// Verifies that what is absent in a request is absent in the restored one.
TEST(RequestBytes, RestoreWhatIsAbsent) {
  const FullRequest got = request_of_bytes(bytes_of({}, small_mesh())).request;
  EXPECT_FALSE(got.material.poisson_ratio);
  EXPECT_FALSE(got.material.counter);
  EXPECT_TRUE(got.material.layers.empty());
  EXPECT_FALSE(got.material.inclusion);
  EXPECT_FALSE(got.material.variation);
}

// Verifies that the mesh is restored.
TEST(RequestBytes, RestoreTheMesh) {
  const meshes::BlockMesh sent = small_mesh();
  const meshes::BlockMesh got = request_of_bytes(bytes_of({}, sent)).mesh;
  EXPECT_EQ(got.vertices, sent.vertices);
  EXPECT_EQ(got.depth, sent.depth);
}

} // namespace asperity::fem::request_bytes_test
