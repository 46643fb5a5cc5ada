// Tests of the files of the contact surface that FullBlock::write makes, which
// an independent reader reads. They run on any number of ranks; each rank
// checks the files of all.
#include "fem/adaptive/adaptive_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"
#include "tests/fem/vtu_reader.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace asperity::fem::surface_output_test {

using mechanics::ContactLaw;
using mechanics::Control;
namespace mpi = dealii::Utilities::MPI;
namespace files = std::filesystem;

constexpr double length = 1e-6; // m
const Grid small_grid{8, 8, length, length};
const mechanics::BodyModuli body{soft_modulus, 0.3};

/// Rounding of single precision.
constexpr double single_precision = 1e-7;

/// The points of the surface of all ranks, face by face.
struct Surface {
  std::vector<double> x, y, gap, pressure, contact, level;
  std::size_t n_cells = 0;

  std::size_t size() const { return x.size(); }

  bool is_at(std::size_t point, double other_x, double other_y) const {
    return std::hypot(x[point] - other_x, y[point] - other_y) < 1e-6 * length;
  }
};

Surface read_surface(const std::string& stem, int step) {
  Surface surface;
  for (unsigned int rank = 0; rank < mpi::n_mpi_processes(MPI_COMM_WORLD);
       ++rank) {
    const Vtu part =
        read_vtu(fmt::format("{}_surface_{:04}.{:04}.vtu", stem, step, rank));
    surface.n_cells += part.n_cells;
    for (std::size_t i = 0; i < part.n_points; ++i) {
      surface.x.push_back(part.fields.at("Points")[3 * i]);
      surface.y.push_back(part.fields.at("Points")[3 * i + 1]);
      EXPECT_EQ(part.fields.at("Points")[3 * i + 2], 0.0);
      surface.gap.push_back(part.fields.at("gap")[i]);
      surface.pressure.push_back(part.fields.at("pressure")[i]);
      surface.contact.push_back(part.fields.at("contact")[i]);
      surface.level.push_back(part.fields.at("level")[i]);
    }
  }
  return surface;
}

/// The mean over all written points at each node of the grid, where each face
/// at the node has one point; NaN where none is written.
std::vector<double> at_grid(const Surface& surface,
                            const std::vector<double>& field,
                            const Grid& grid = small_grid) {
  std::vector<double> sum(grid.size(), 0.0), count(grid.size(), 0.0);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const long ix = std::lround(surface.x[i] / grid.spacing_x());
    const long iy = std::lround(surface.y[i] / grid.spacing_y());
    if (!surface.is_at(i, static_cast<double>(ix) * grid.spacing_x(),
                       static_cast<double>(iy) * grid.spacing_y()))
      continue;
    const std::size_t node = grid.index(static_cast<int>(ix) % grid.points_x,
                                        static_cast<int>(iy) % grid.points_y);
    sum[node] += field[i];
    count[node] += 1.0;
  }
  for (std::size_t node = 0; node < sum.size(); ++node)
    sum[node] /= count[node];
  return sum;
}

class SurfaceFiles : public OutputFiles {
protected:
  /// Heights of 4 nm in a smooth bump at one side, with roughness.
  static std::vector<double> heights(const Grid& grid) {
    std::vector<double> heights = random_field(grid.size(), 5);
    const std::vector<double> wave = wave_heights(grid, 3e-9);
    for (std::size_t i = 0; i < heights.size(); ++i)
      heights[i] = wave[i] + 1e-9 * heights[i];
    return heights;
  }

  BlockSolution write_step(FullBlock& block, ContactLaw law,
                           double pressure = 4e6) const {
    const BlockSolution found = block.solve(
        heights(block.grid()), {Control::nominal_pressure, pressure},
        {law, 300.0 * soft_modulus / length, 1e-10, 400});
    EXPECT_TRUE(found.converged) << found.note;
    block.write(stem());
    return found;
  }

  /// Compares a step with its solution: every node of the grid is written, with
  /// the gap and the pressure of the solution.
  static void expect_fields(const Surface& surface, const BlockSolution& found,
                            const std::string& name) {
    EXPECT_LT(largest_difference(at_grid(surface, surface.gap), found.gap),
              single_precision * largest_magnitude(found.gap))
        << name;
    EXPECT_LT(
        largest_difference(at_grid(surface, surface.pressure), found.pressure),
        single_precision * largest_magnitude(found.pressure))
        << name;
    std::set<double> statuses;
    for (std::size_t i = 0; i < surface.size(); ++i) {
      statuses.insert(surface.contact[i]);
      EXPECT_EQ(surface.contact[i] > 0.0, surface.pressure[i] > 0.0) << name;
    }
    EXPECT_EQ(statuses, (std::set<double>{0.0, 1.0})) << name;
  }
};

// Verifies all kinds of blocks: the files have the gap and the pressure of the
// solution, on periodic and free sides, on boxes and tetrahedra, of one body
// and of two.
TEST_F(SurfaceFiles, HoldTheSolution) {
  const auto compare = [&](const char* name, const BlockProblem& problem,
                           ContactLaw law, std::size_t n_cells) {
    SCOPED_TRACE(name);
    const BlockSolution found = write_step(*make_full_block(problem), law);

    const Surface surface = read_surface(stem(), 0);
    EXPECT_EQ(surface.n_cells, n_cells) << name;
    expect_fields(surface, found, name);
  };
  const BlockProblem boxes = boxes_problem(small_grid, 1, body, length);
  compare("boxes", boxes, ContactLaw::hard, 64);
  compare("second order", boxes_problem(small_grid, 2, body, length),
          ContactLaw::hard, 64);
  BlockProblem problem = boxes_problem(small_grid, 2, body, length);
  problem.sides = mechanics::BlockSides::free;
  compare("free sides", problem, ContactLaw::penalty, 64);
  problem = boxes;
  problem.mesh = tetrahedra_of(problem.mesh);
  compare("tetrahedra", problem, ContactLaw::penalty, 128);
  problem = boxes;
  problem.counter = mechanics::BodyModuli{2.0 * soft_modulus, 0.2};
  compare("two bodies", problem, ContactLaw::penalty, 64);
}

// Verifies from the files alone that hard contact is satisfied: a point in
// contact touches, and no other point penetrates, to the tolerance of 1e-10 of
// the rms height plus the rounding of the file.
TEST_F(SurfaceFiles, SatisfyHardContact) {
  write_step(*make_full_block(boxes_problem(small_grid, 2, body, length)),
             ContactLaw::hard);

  const Surface surface = read_surface(stem(), 0);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    EXPECT_GE(surface.gap[i], -1e-17);
    EXPECT_EQ(surface.contact[i], surface.gap[i] < 1e-17 ? 1.0 : 0.0);
  }
}

// Verifies that nothing is defined before the first solution.
TEST_F(SurfaceFiles, HoldNoNumbersBeforeTheFirstSolution) {
  make_full_block(boxes_problem(small_grid, 1, body, length))->write(stem());

  const Surface surface = read_surface(stem(), 0);
  ASSERT_EQ(surface.size(), 4U * 64U);
  for (std::size_t i = 0; i < surface.size(); ++i)
    EXPECT_TRUE(std::isnan(surface.gap[i]) && std::isnan(surface.pressure[i]) &&
                std::isnan(surface.contact[i]));
}

/// The lower corner and the width of the square that consecutive points span.
struct Square {
  double x, y, width;
};

Square square_of(const Surface& surface, std::size_t first,
                 std::size_t n_points) {
  const auto x = surface.x.begin() + static_cast<std::ptrdiff_t>(first);
  const auto y = surface.y.begin() + static_cast<std::ptrdiff_t>(first);
  const auto n = static_cast<std::ptrdiff_t>(n_points);
  const double low = *std::min_element(x, x + n);
  return {low, *std::min_element(y, y + n), *std::max_element(x, x + n) - low};
}

/// Whether a point lies on a face of second order of which it is no node.
bool is_hanging(const Surface& surface, std::size_t point) {
  const double slack = 1e-6 * length;
  for (std::size_t first = 0; first < surface.size(); first += 9) {
    const Square face = square_of(surface, first, 9);
    const double x = surface.x[point] - face.x;
    const double y = surface.y[point] - face.y;
    if (x < -slack || x > face.width + slack || y < -slack ||
        y > face.width + slack)
      continue;
    bool is_node = false;
    for (std::size_t i = first; i < first + 9; ++i)
      is_node |= surface.is_at(i, surface.x[point], surface.y[point]);
    if (!is_node)
      return true;
  }
  return false;
}

// Verifies a mesh that follows the contact, with periodic and free sides: the
// level of each cell tells its width, in the block and on its surface, the
// contact boundary has the finest level, and the contact status is undefined at
// hanging nodes and only there. Everywhere else the fields are those of the
// solution.
TEST_F(SurfaceFiles, TellLevelsAndHangingNodes) {
  const Grid grid{64, 64, length, length};
  constexpr int halvings = 3;
  constexpr double coarsest = length / 4.0;
  BlockProblem problem{.grid = grid,
                       .mesh =
                           meshes::equal_boxes({4, 4, length, length}, length),
                       .degree = 2,
                       .moduli = ModuliField(moduli(body)),
                       .adaptive = AdaptiveMesh{halvings}};
  for (const auto sides :
       {mechanics::BlockSides::periodic, mechanics::BlockSides::free}) {
    problem.sides = sides;
    const BlockSolution found =
        write_step(*make_adaptive_block(problem), ContactLaw::hard, 3e5);

    const Surface surface = read_surface(stem(), 0);
    std::set<double> levels;
    std::size_t n_hanging = 0;
    for (std::size_t first = 0; first < surface.size(); first += 9) {
      const double level = surface.level[first];
      bool is_touched = false, is_free = false;
      for (std::size_t i = first; i < first + 9; ++i) {
        n_hanging += std::isnan(surface.contact[i]) ? 1 : 0;
        EXPECT_EQ(std::isnan(surface.contact[i]), is_hanging(surface, i));
        is_touched |= surface.contact[i] == 1.0;
        is_free |= surface.contact[i] == 0.0;
      }
      EXPECT_NEAR(square_of(surface, first, 9).width * std::exp2(level),
                  coarsest, 1e-6 * length);
      if (is_touched && is_free) {
        EXPECT_EQ(level, halvings);
      }
      levels.insert(level);
    }
    EXPECT_GT(levels.size(), 1U);
    EXPECT_GT(n_hanging, 0U);
    // Not compared are the inside of coarse cells, which is not written, and
    // the sides, where a node of the grid stands for two of the mesh.
    const std::vector<double> gap = at_grid(surface, surface.gap, grid);
    for (int iy = 1; iy < grid.points_y; ++iy)
      for (int ix = 1; ix < grid.points_x; ++ix)
        if (const std::size_t i = grid.index(ix, iy); std::isfinite(gap[i])) {
          EXPECT_NEAR(gap[i], found.gap[i],
                      single_precision * largest_magnitude(found.gap));
        }

    const Vtu block = read_vtu(stem() + "_0000.0000.vtu");
    const auto& points = block.fields.at("Points");
    for (std::size_t first = 0; first < block.n_points; first += 27)
      EXPECT_NEAR((points[3 * (first + 26) + 2] - points[3 * first + 2]) *
                      std::exp2(block.fields.at("level")[first]),
                  coarsest, 1e-6 * length);
  }
}

// Verifies that the steps of the surface are listed with the times of those of
// the block, and that every listed file exists.
TEST_F(SurfaceFiles, AreListedLikeTheBlock) {
  const auto block =
      make_full_block(boxes_problem(small_grid, 1, body, length));
  write_step(*block, ContactLaw::hard, 2e6);
  write_step(*block, ContactLaw::hard, 4e6);

  pugi::xml_document list, expected;
  ASSERT_TRUE(list.load_file((stem() + "_surface.pvd").c_str()));
  ASSERT_TRUE(expected.load_file((stem() + ".pvd").c_str()));
  const auto steps = [](const pugi::xml_document& document) {
    return document.child("VTKFile").child("Collection").children("DataSet");
  };
  auto other = steps(expected).begin();
  for (const auto& step : steps(list)) {
    EXPECT_EQ(std::string(step.attribute("timestep").value()),
              (other++)->attribute("timestep").value());
    pugi::xml_document parts;
    ASSERT_TRUE(
        parts.load_file((folder_ / step.attribute("file").value()).c_str()));
    std::size_t n_parts = 0;
    for (const auto& part :
         parts.child("VTKFile").child("PUnstructuredGrid").children("Piece")) {
      ++n_parts;
      EXPECT_TRUE(files::exists(folder_ / part.attribute("Source").value()));
    }
    EXPECT_EQ(n_parts, mpi::n_mpi_processes(MPI_COMM_WORLD));
  }
  EXPECT_EQ(other, steps(expected).end());
}

} // namespace asperity::fem::surface_output_test
