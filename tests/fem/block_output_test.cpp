// Tests of the files of FullBlock::write, which an independent reader reads.
// They run on any number of ranks; each rank checks the files of all.
#include "fem/parallel/step_files.hpp"
#include "fem/solution/block_output.hpp"
#include "meshes/layered_mesh.hpp"
#include "tests/fem/bent_block.hpp"
#include "tests/fem/vtu_reader.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace asperity::fem::block_output_test {

using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::FarBoundary;
namespace mpi = dealii::Utilities::MPI;
namespace files = std::filesystem;

class BlockFiles : public OutputFiles {
protected:
  static constexpr double length_ = 1e-6; // m
  static constexpr double poisson_ = 0.3;
  const Grid grid_{4, 4, length_, length_};
  const std::vector<double> flat_ = std::vector<double>(16, 0.0);

  BlockProblem problem(int degree) const {
    const int cells = 4 / degree;
    return {.grid = grid_,
            .mesh = meshes::layered_mesh(
                {cells, cells, length_, length_},
                std::vector<double>(static_cast<std::size_t>(cells),
                                    length_ / cells)),
            .degree = degree,
            .moduli = ModuliField(moduli({soft_modulus, poisson_})),
            .far_boundary = FarBoundary::sliding,
            .linear_solver = LinearSolver::direct};
  }

  /// Full contact with a flat surface: uniaxial strain.
  void press(FullBlock& full, double pressure) const {
    const BlockSolution found = full.solve(
        flat_, {Control::nominal_pressure, pressure},
        {ContactLaw::penalty, 10.0 * soft_modulus / length_, 1e-8, 50});
    ASSERT_TRUE(found.converged) << found.note;
  }

  /// The parts of a load step, each checked for the fields of uniaxial strain.
  /// Tolerance: the files have single precision, 6e-8.
  void expect_squeezed(int step, double pressure, std::size_t n_points,
                       std::size_t n_cells) const {
    std::size_t points = 0, cells = 0;
    for (unsigned int rank = 0; rank < n_ranks(); ++rank) {
      const Vtu part =
          read_vtu(fmt::format("{}_{:04}.{:04}.vtu", stem(), step, rank));
      points += part.n_points;
      cells += part.n_cells;
      expect_squeezed(part, pressure, rank);
    }
    EXPECT_EQ(points, n_points);
    EXPECT_EQ(cells, n_cells);
  }

  static void expect_squeezed(const Vtu& part, double pressure,
                              unsigned int rank) {
    ASSERT_EQ(part.components.at("displacement"), 3);
    ASSERT_EQ(part.components.at("stress"), 9);
    ASSERT_EQ(part.fields.at("Points").size(), 3 * part.n_points);
    const double oedometer = soft_modulus * (1.0 - poisson_) /
                             ((1.0 + poisson_) * (1.0 - 2.0 * poisson_));
    const double size = pressure * length_ / oedometer;
    const double sideways = poisson_ / (1.0 - poisson_) * pressure;
    for (std::size_t i = 0; i < part.n_points; ++i) {
      const auto field = [&](const char* name, std::size_t component = 0) {
        const auto n = static_cast<std::size_t>(part.components.at(name));
        return part.fields.at(name)[i * n + component];
      };
      const double z = field("Points", 2);
      EXPECT_NEAR(field("displacement", 0), 0.0, 1e-7 * size);
      EXPECT_NEAR(field("displacement", 2), size * (1.0 - z / length_),
                  1e-7 * size);
      EXPECT_NEAR(field("stress", 8), -pressure, 1e-7 * pressure);
      EXPECT_NEAR(field("stress", 0), -sideways, 1e-7 * pressure);
      EXPECT_NEAR(field("stress", 1), 0.0, 1e-7 * pressure);
      EXPECT_NEAR(field("vertical_pressure"), pressure, 1e-7 * pressure);
      EXPECT_NEAR(field("von_mises"), pressure - sideways, 1e-7 * pressure);
      EXPECT_NEAR(field("youngs_modulus"), soft_modulus, 1e-7 * soft_modulus);
      EXPECT_EQ(field("subdomain"), rank);
    }
  }

  std::vector<std::pair<double, std::string>> steps() const {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_file((stem() + ".pvd").c_str()));
    std::vector<std::pair<double, std::string>> steps;
    for (const auto& one :
         document.child("VTKFile").child("Collection").children("DataSet"))
      steps.emplace_back(one.attribute("timestep").as_double(),
                         one.attribute("file").value());
    return steps;
  }
};

// Verifies that a cell of first order is written with the values at its own
// corners, one of second order as eight cells, and that the values are those of
// uniaxial strain.
TEST_F(BlockFiles, HoldTheSqueezedBlock) {
  for (const int degree : {1, 2}) {
    const std::size_t n_cells = degree == 1 ? 64 : 8;
    const auto full = make_full_block(problem(degree));
    press(*full, 2e6);

    full->write(stem());

    expect_squeezed(0, 2e6, n_cells * (degree == 1 ? 8 : 27),
                    n_cells * (degree == 1 ? 1 : 8));
  }
}

// Verifies that load steps are listed by pressure while it increases and by
// number after it has decreased, and that every listed file exists.
TEST_F(BlockFiles, AreListedStepByStep) {
  const auto full = make_full_block(problem(1));
  const auto write_at = [&](double pressure) {
    press(*full, pressure);
    full->write(stem());
  };

  write_at(1e6);
  write_at(3e6);
  const auto loading = steps();
  write_at(2e6);
  const auto unloading = steps();

  ASSERT_EQ(loading.size(), 2U);
  EXPECT_NEAR(loading[0].first / 1e6, 1.0, 1e-5); // printed to six digits
  EXPECT_NEAR(loading[1].first / 3e6, 1.0, 1e-5);
  ASSERT_EQ(unloading.size(), 3U);
  for (std::size_t step = 0; step < 3; ++step) {
    EXPECT_EQ(unloading[step].first, static_cast<double>(step));
    pugi::xml_document list;
    ASSERT_TRUE(list.load_file((folder_ / unloading[step].second).c_str()));
    std::size_t parts = 0;
    for (const auto& part :
         list.child("VTKFile").child("PUnstructuredGrid").children("Piece")) {
      ++parts;
      EXPECT_TRUE(files::exists(folder_ / part.attribute("Source").value()));
    }
    EXPECT_EQ(parts, n_ranks());
  }
  expect_squeezed(1, 3e6, 64 * 8, 64);
}

// Verifies that a stress that varies within each cell is written at its own
// points, also where the cell is written as eight: -sigma_zz of u_z = strain z
// (1 - z/L). Tolerance: the files have single precision, 6e-8.
TEST_F(BlockFiles, HoldTheStressOfEachPoint) {
  const double strain = 1e-3;
  BlockProblem bent = problem(2);
  bent.sides = mechanics::BlockSides::free;
  const BlockSystem system(bent);
  BlockStress stress(
      system, vertical_displacement(system.space(), [&](const auto& place) {
        return strain * place[2] * (1.0 - place[2] / length_);
      }));

  const FaceMaps maps(system);
  const BlockSolver solver(system, LinearSolver::direct);
  const ContactState state(system, solver);

  BlockOutput().write(stem(), system, stress,
                      SurfaceOutput(maps, state, stress.displacement(), {}),
                      1e6);

  const Moduli material = moduli({soft_modulus, poisson_});
  const double largest =
      (material.lame_modulus + 2.0 * material.shear_modulus) * strain;
  for (unsigned int rank = 0; rank < n_ranks(); ++rank) {
    const Vtu part = read_vtu(fmt::format("{}_0000.{:04}.vtu", stem(), rank));
    for (std::size_t i = 0; i < part.n_points; ++i)
      EXPECT_NEAR(part.fields.at("vertical_pressure")[i] / largest,
                  2.0 * part.fields.at("Points")[3 * i + 2] / length_ - 1.0,
                  2e-7);
  }
}

// Verifies that each file stem has its own count of steps, and that a step that
// could not be written is not counted.
TEST_F(BlockFiles, CountTheStepsOfEachStem) {
  const auto full = make_full_block(problem(1));
  const std::string other = (folder_ / "other").string();
  press(*full, 1e6);
  full->write(stem());
  full->write(other);
  EXPECT_THROW(full->write(stem() + ".pvd/block"), std::runtime_error);
  if (mpi::this_mpi_process(MPI_COMM_WORLD) == 0)
    files::remove(stem() + ".pvd");
  MPI_Barrier(MPI_COMM_WORLD);
  full->write(stem() + ".pvd/block");

  EXPECT_TRUE(files::exists(stem() + "_0000.pvtu"));
  EXPECT_TRUE(files::exists(other + "_0000.pvtu"));
  EXPECT_FALSE(files::exists(other + "_0001.pvtu"));
  EXPECT_TRUE(files::exists(stem() + ".pvd/block_0000.pvtu"));
  EXPECT_FALSE(files::exists(stem() + ".pvd/block_0001.pvtu"));
}

// Verifies that load steps are listed by number if two loads are equal.
TEST(BlockTimes, AreNumbersUnlessTheLoadGrows) {
  EXPECT_EQ(times_of({1e6, 2e6}), (std::vector<double>{1e6, 2e6}));
  EXPECT_EQ(times_of({1e6, 1e6}), (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(times_of({2e6, 1e6}), (std::vector<double>{0.0, 1.0}));
}

// Verifies that every rank reports a folder that cannot be made, that earlier
// steps remain, and that no incomplete file is left.
TEST_F(BlockFiles, AreCompleteOrAbsent) {
  const auto full = make_full_block(problem(1));
  press(*full, 1e6);
  full->write(stem());
  const std::string below_a_file = stem() + ".pvd/block";

  EXPECT_THROW(full->write(below_a_file), std::runtime_error);

  EXPECT_EQ(steps().size(), 1U);
  std::size_t n_files = 0;
  for (const auto& entry : files::directory_iterator(folder_)) {
    ++n_files;
    EXPECT_EQ(entry.path().filename().string().substr(0, 5), "block");
  }
  EXPECT_EQ(n_files, 2 * (n_ranks() + 2)); // of the block and its surface
}

} // namespace asperity::fem::block_output_test
