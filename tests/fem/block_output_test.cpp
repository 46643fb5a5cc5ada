// Claims about the files of FullBlock::write, read back by another reader.
// Runs on any number of ranks; each checks the files of all.
#include "fem/block_output.hpp"
#include "fem/mpi_session.hpp"
#include "meshes/layered_mesh.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"
#include "tests/fem/vtu_reader.hpp"

namespace asperity::fem {
namespace {

using cases::ContactLaw;
using cases::Control;
using cases::TopFace;
namespace mpi = dealii::Utilities::MPI;
namespace files = std::filesystem;

class BlockFiles : public ::testing::Test {
protected:
  static constexpr double length_ = 1e-6;  // m
  static constexpr double poisson_ = 0.25; // lambda = mu
  const Grid grid_{4, 4, length_, length_};
  const std::vector<double> flat_ = std::vector<double>(16, 0.0);
  files::path folder_;

  void SetUp() override {
    start_mpi();
    folder_ = files::path(::testing::TempDir()) /
              fmt::format("asperity_block_files_of_{}_ranks", n_ranks());
    if (mpi::this_mpi_process(MPI_COMM_WORLD) == 0)
      files::remove_all(folder_);
    MPI_Barrier(MPI_COMM_WORLD);
  }

  void TearDown() override {
    MPI_Barrier(MPI_COMM_WORLD);
    if (mpi::this_mpi_process(MPI_COMM_WORLD) == 0)
      files::remove_all(folder_);
  }

  static unsigned int n_ranks() { return mpi::n_mpi_processes(MPI_COMM_WORLD); }

  std::string stem() const { return (folder_ / "block").string(); }

  BlockProblem problem(int degree) const {
    const int cells = 4 / degree;
    return {.grid = grid_,
            .mesh = meshes::layered_mesh(
                {cells, cells, length_, length_},
                std::vector<double>(static_cast<std::size_t>(cells),
                                    length_ / cells)),
            .degree = degree,
            .moduli = ModuliField(moduli({soft_modulus, poisson_})),
            .top = TopFace::sliding,
            .linear_solver = LinearSolver::direct};
  }

  /// Full contact with a flat wall: uniaxial strain.
  void press(FullBlock& whole, double pressure) const {
    const BlockSolution found = whole.solve(
        flat_, {Control::nominal_pressure, pressure},
        {ContactLaw::penalty, 10.0 * soft_modulus / length_, 1e-8, 50});
    ASSERT_TRUE(found.converged) << found.note;
  }

  /// The parts of a step, all checked for what a squeezed block holds.
  /// Tolerance: files have single precision, 6e-8.
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
    const double shear = soft_modulus / 2.5; // lambda = mu = E / 2.5
    const double size = pressure * length_ / (3.0 * shear);
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
      EXPECT_NEAR(field("stress", 0), -pressure / 3.0, 1e-7 * pressure);
      EXPECT_NEAR(field("stress", 1), 0.0, 1e-7 * pressure);
      EXPECT_NEAR(field("vertical_pressure"), pressure, 1e-7 * pressure);
      EXPECT_NEAR(field("von_mises"), pressure / 1.5, 1e-7 * pressure);
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

// Claim: a cell of either order is written with its corners' own values, one of
// second order as eight, and the numbers are those of uniaxial strain.
TEST_F(BlockFiles, HoldTheSqueezedBlock) {
  for (const int degree : {1, 2}) {
    const std::size_t n_cells = degree == 1 ? 64 : 8;
    const auto whole = make_full_block(problem(degree));
    press(*whole, 2e6);

    whole->write(stem());

    expect_squeezed(0, 2e6, n_cells * (degree == 1 ? 8 : 27),
                    n_cells * (degree == 1 ? 1 : 8));
  }
}

// Claim: tetrahedra of second order are written with their ten nodes.
TEST_F(BlockFiles, HoldTetrahedra) {
  BlockProblem block = problem(2);
  block.contact_at = cases::ContactPoints::gauss;
  block.mesh = tetrahedra_of(block.mesh);
  const std::size_t n_cells = block.mesh.cells.size();
  const auto whole = make_full_block(block);
  press(*whole, 2e6);

  whole->write(stem());

  expect_squeezed(0, 2e6, n_cells * 10, n_cells);
}

// Claim: the steps are listed by pressure while it grows, and by number once it
// has fallen; every file a list names is there.
TEST_F(BlockFiles, AreListedStepByStep) {
  const auto whole = make_full_block(problem(1));
  const auto write_at = [&](double pressure) {
    press(*whole, pressure);
    whole->write(stem());
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

// Claim: a folder that cannot be is said on every rank, earlier steps stay and
// no half file is left.
TEST_F(BlockFiles, AreWholeOrNotAtAll) {
  const auto whole = make_full_block(problem(1));
  press(*whole, 1e6);
  whole->write(stem());
  const std::string below_a_file = stem() + ".pvd/block";

  EXPECT_THROW(whole->write(below_a_file), std::runtime_error);

  EXPECT_EQ(steps().size(), 1U);
  std::size_t n_files = 0;
  for (const auto& entry : files::directory_iterator(folder_)) {
    ++n_files;
    EXPECT_EQ(entry.path().filename().string().substr(0, 5), "block");
  }
  EXPECT_EQ(n_files, n_ranks() + 2);
}

} // namespace
} // namespace asperity::fem
