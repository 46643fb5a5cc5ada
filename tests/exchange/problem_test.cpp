// Tests of suite/exchange/problem.hpp and suite/exchange/problem_folder.hpp:
// what is written is read back, and damaged files are refused by name.
#include "base/content_hash.hpp"
#include "base/json.hpp"
#include "base/read_file.hpp"
#include "fem/plugin.hpp"
#include "input/input_error.hpp"
#include "meshes/valid_mesh.hpp"
#include "suite/exchange/pressure_file.hpp"
#include "suite/exchange/problem.hpp"
#include "suite/exchange/problem_folder.hpp"
#include "tests/message_of.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>

#include "problems.hpp"

namespace asperity::exchange::problem_test {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  return read_file(file, 100'000'000);
}

class ProblemFolder : public testing::Test {
protected:
  ProblemFolder() {
    fs::remove_all(folder);
    problem.body.layers = {{2e-6, 5e9, 0.25}};
    problem.body.thickness = 30e-6;
    problem.body.far_boundary = mechanics::FarBoundary::sliding;
    write();
  }

  ~ProblemFolder() override { fs::remove_all(folder); }

  void write() {
    const std::vector<ProblemAnswer> answers{problems::example_of(problem)};
    const std::vector<ContinuumAnswer> continuum{
        {2e6, 1e-6, 0.0, 0.1, not_a_number, "a source"}};
    write_problem(problem, answers, continuum, "schema = 1\n", folder);
  }

  /// The message of the reader after a text in problem.json was replaced.
  std::string message_with(const std::string& old_text,
                           const std::string& new_text) {
    fs::remove_all(folder); // which write() would refuse once it is changed
    write();
    fs::remove(folder / "SHA256SUMS"); // it knows the old text
    std::string json = text_of(folder / "problem.json");
    const std::size_t at = json.find(old_text);
    EXPECT_NE(at, std::string::npos) << old_text;
    json.replace(at, old_text.size(), new_text);
    std::ofstream(folder / "problem.json") << json;
    return tests::message_of<input::InputError>([&] { read_problem(folder); });
  }

  fs::path folder = fs::path(testing::TempDir()) / "asperity-problem-folder";
  Problem problem = problems::rough_problem();
};

TEST_F(ProblemFolder, HasTheMeshOfItsBlock) {
#ifdef __has_feature
#if __has_feature(address_sanitizer)
  GTEST_SKIP() << "gmsh runs within a limit of its address space, of which the "
                  "sanitizer needs 16 TB";
#endif
#endif
  const mechanics::BlockSettings settings{.element = mechanics::Element::q1};
  const ProblemMesh block = problem_mesh(problem, settings);
  write_problem(problem,
                std::vector<ProblemAnswer>{problems::example_of(problem)}, {},
                "", folder, &block);
  EXPECT_TRUE(read_problem(folder).grid == problem.grid);
  const auto json = json_of_text(text_of(folder / "problem.json")).at("mesh");
  EXPECT_EQ(json.at("cells_x"), 64);
  EXPECT_EQ(json.at("element"), "Q1");
  EXPECT_EQ(json.at("materials").size(), 2U);
  EXPECT_EQ(json.at("materials")[0].at("youngs_modulus [Pa]"), 5e9);
  EXPECT_NEAR(json.at("materials")[1].at("youngs_modulus [Pa]").get<double>(),
              0.91e9, 1.0);
  EXPECT_NE(text_of(folder / "README.md")
                .find("p[i, j] = F[i, j] / (dx dy),    dx dy = 1.000000e-06 m "
                      "x 1.000000e-06 m"),
            std::string::npos);
  // What is read back is the same mesh, with the same surfaces.
  meshes::BlockMesh read =
      fem::load_fem_module().mesh_file(folder / "mesh.msh", 1.0).mesh;
  meshes::fit_sides(read, mechanics::BlockSides::periodic);
  EXPECT_EQ(read.vertices.size(), block.mesh.vertices.size());
  EXPECT_EQ(read.cells.size(), block.mesh.cells.size());
  EXPECT_EQ(read.faces.size(), block.mesh.faces.size());
  EXPECT_EQ(read.group_names, (std::vector<std::string>{"layer_1", "block"}));
  EXPECT_EQ(std::ranges::count(read.cell_group, 0),
            std::ranges::count(block.mesh.cell_group, 0));
  EXPECT_NEAR(read.depth, 30e-6, 1e-17);
  EXPECT_NEAR(read.length_x, 64e-6, 1e-17);
}

TEST_F(ProblemFolder, HasTheMeshAsAbaqusInput) {
  const ProblemMesh block =
      problem_mesh(problem, {.element = mechanics::Element::q2});
  EXPECT_EQ(block.cells_x, 32);
  EXPECT_NE(mesh_readme(block, problem).find("solve M p = F"),
            std::string::npos);
  const std::string text = abaqus_text(block);
  std::istringstream lines(text);
  std::map<std::string, std::size_t> counts;
  std::string key;
  for (std::string line; std::getline(lines, line);) {
    if (line.front() == '*')
      key = line;
    else
      ++counts[key];
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, ',');)
      EXPECT_TRUE(line.front() == '*' || word.size() <= 20) << line;
  }
  EXPECT_EQ(counts["*NODE,NSET=all"], block.mesh.vertices.size());
  EXPECT_EQ(counts["*ELEMENT,TYPE=C3D8,ELSET=layer_1"] +
                counts["*ELEMENT,TYPE=C3D8,ELSET=block"],
            block.mesh.cells.size());
  EXPECT_EQ(counts["*SURFACE,NAME=contact,TYPE=ELEMENT"], 32U * 32U);
  // The first cell, around its face of contact and then the one below.
  const std::size_t a_plane = 33UL * 33UL;
  EXPECT_NE(text.find(fmt::format("\n1,1,2,35,34,{},{},{},{}\n", 1 + a_plane,
                                  2 + a_plane, 35 + a_plane, 34 + a_plane)),
            std::string::npos);
}

TEST_F(ProblemFolder, MeshesAHalfSpaceToOneLength) {
  Problem deep = problems::rough_problem();
  deep.body.poisson_ratio = 0.0; // not known
  const ProblemMesh block =
      problem_mesh(deep, {.element = mechanics::Element::q1});
  EXPECT_NEAR(block.mesh.depth, 64e-6, 1e-17);
  EXPECT_EQ(block.moduli[0].poisson_ratio, 0.3);
  EXPECT_NEAR(block.moduli[0].youngs_modulus, 0.91e9, 1.0);
}

TEST_F(ProblemFolder, RefusesMeshesThatNobodyCanUse) {
  problem.grid.points_x = 63;
  EXPECT_NE(tests::message_of<input::InputError>([&] {
              problem_mesh(problem, {.element = mechanics::Element::q2});
            }).find("63 by 64 points, but cells of Q2"),
            std::string::npos);
  problem.grid.points_x = problem.grid.points_y = 4096;
  EXPECT_NE(tests::message_of<input::InputError>([&] {
              problem_mesh(problem, {.element = mechanics::Element::q1});
            }).find("but at most 2e+06 are written"),
            std::string::npos);
}

TEST_F(ProblemFolder, IsReadAsWritten) {
  const Problem read = read_problem(folder);
  EXPECT_EQ(read.name, problem.name);
  EXPECT_EQ(read.title, problem.title);
  EXPECT_TRUE(read.grid == problem.grid);
  EXPECT_EQ(read.heights, problem.heights);
  EXPECT_EQ(read.loads, problem.loads);
  EXPECT_EQ(read.rms_height, problem.rms_height);
  EXPECT_EQ(read.body.contact_modulus, 1e9);
  EXPECT_EQ(read.body.poisson_ratio, 0.3);
  EXPECT_EQ(read.body.thickness, 30e-6);
  EXPECT_EQ(read.body.far_boundary, mechanics::FarBoundary::sliding);
  ASSERT_EQ(read.body.layers.size(), 1U);
  EXPECT_EQ(read.body.layers[0].thickness, 2e-6);
  EXPECT_EQ(read.body.layers[0].youngs_modulus, 5e9);
  EXPECT_EQ(read.body.layers[0].poisson_ratio, 0.25);

  problem = problems::rough_problem();
  problem.grid.length_y = 60e-6;
  problem.rms_slope =
      surfaces::statistics({problem.grid, problem.heights}).rms_slope;
  write();
  const Problem half_space = read_problem(folder);
  EXPECT_TRUE(std::isinf(half_space.body.thickness));
  EXPECT_TRUE(half_space.grid == problem.grid);
}

TEST_F(ProblemFolder, HasAdhesion) {
  EXPECT_FALSE(read_problem(folder).adhesion);
  problem = problems::sticky_problem();
  write();

  const Problem read = read_problem(folder);
  EXPECT_EQ(read.loads, problem.loads);
  ASSERT_TRUE(read.adhesion);
  EXPECT_EQ(read.adhesion->law, mechanics::ContactLaw::exponential);
  EXPECT_EQ(read.adhesion->work_of_adhesion, 0.05);
  EXPECT_EQ(read.adhesion->adhesion_range, 3.2e-7);
  const std::string readme = text_of(folder / "README.md");
  EXPECT_NE(readme.find("gamma = 0.05 J/m^2 and rho = 3.2e-07 m"),
            std::string::npos)
      << readme;
  EXPECT_NE(readme.find("path of 2 steps"), std::string::npos) << readme;

  const auto expect = [&](const char* old_text, const char* new_text,
                          const char* sentence) {
    const std::string message = message_with(old_text, new_text);
    EXPECT_NE(message.find(sentence), std::string::npos) << message;
  };
  expect("exponential attraction", "attraction",
         "/contact is \"frictionless, hard wall, attraction\", but must be "
         "\"frictionless, non-adhesive, hard\" or \"frictionless, hard wall, "
         "exponential attraction\"");
  expect("\"work_of_adhesion [J/m^2]\": 0.05",
         "\"work_of_adhesion [J/m^2]\": -1",
         "/adhesion/work_of_adhesion [J~1m^2] is -1, but must be a number > 0");
  expect("\"range [m]\": 3.2e-07", "\"range [m]\": 1e-9",
         "/adhesion/range [m] is 1e-09, but must be so long that the grid");
  expect("\"range [m]\"", "\"rang [m]\"",
         "/adhesion/range [m] is missing, but must be a number between 0 and "
         "1e+16");
  expect("mean_gap [m]", "nominal_pressure [Pa]",
         "/loads/0/mean_gap [m] is missing");
  expect("\"is_periodic\": true", "\"is_periodic\": false",
         "but must be \"frictionless, non-adhesive, hard\" without periodic");
}

// With free boundaries the body is a half-space, and the README states its
// kernel.
TEST_F(ProblemFolder, HasFreeBoundaries) {
  EXPECT_TRUE(read_problem(folder).is_periodic());
  problem = problems::rough_problem();
  problem.body.border = mechanics::Border::free;
  write();
  EXPECT_FALSE(read_problem(folder).is_periodic());
  const std::string readme = text_of(folder / "README.md");
  EXPECT_NE(readme.find("On a rectangle of 64"), std::string::npos);
  EXPECT_NE(readme.find("w vanishes at infinity"), std::string::npos);
}

// All height files hold the same numbers, bit for bit, including the text file.
TEST_F(ProblemFolder, HasTheSameHeightsInEachFile) {
  for (const char* name : {"heights.npy", "heights.h5", "heights.txt"}) {
    const surfaces::Matrix matrix = read_pressure_file(folder / name, 64 * 64);
    EXPECT_EQ(matrix.rows, 64U) << name;
    EXPECT_EQ(matrix.numbers, problem.heights) << name;
  }
  EXPECT_NE(tests::message_of<input::InputError>([&] {
              return read_pressure_file(folder / "heights.h5", 64 * 64 - 1);
            }).find("64 x 64 numbers, but may have at most 4095"),
            std::string::npos);
  const std::string gwy = text_of(folder / "heights.gwy");
  const std::string_view numbers(
      reinterpret_cast<const char*>(problem.heights.data()),
      problem.heights.size() * sizeof(double));
  EXPECT_NE(gwy.find(numbers), std::string::npos);
}

// The README describes the body, also a slab without layers.
TEST_F(ProblemFolder, DescribesTheBody) {
  EXPECT_NE(text_of(folder / "README.md")
                .find("a block 3e-05 m thick, of which 1 bonded layer(s)"),
            std::string::npos);
  problem.body.layers.clear();
  write();
  EXPECT_NE(text_of(folder / "README.md").find("a block 3e-05 m thick; `body`"),
            std::string::npos);
  problem.body.thickness = infinity;
  write();
  EXPECT_NE(text_of(folder / "README.md").find("an elastic half-space"),
            std::string::npos);
}

// SHA256SUMS names every other file with its hash.
TEST_F(ProblemFolder, HasChecksumsOfAllFiles) {
  std::istringstream sums(text_of(folder / "SHA256SUMS"));
  std::size_t listed = 0;
  for (std::string hash, name; sums >> hash >> name; ++listed)
    EXPECT_EQ(content_hash(text_of(folder / name)), hash) << name;
  const auto files =
      std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  EXPECT_EQ(listed + 1, static_cast<std::size_t>(files));
}

// The same problem has the same bytes a second later. By default HDF5 stores
// the times of its objects.
TEST_F(ProblemFolder, DoesNotDependOnTheTime) {
  const std::string before = text_of(folder / "SHA256SUMS");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  write();
  EXPECT_EQ(text_of(folder / "SHA256SUMS"), before);
}

TEST_F(ProblemFolder, RefusesAWrongMember) {
  const auto expect = [&](const char* old_text, const char* new_text,
                          const char* sentence) {
    const std::string message = message_with(old_text, new_text);
    EXPECT_NE(message.find(sentence), std::string::npos) << message;
    EXPECT_NE(message.find("problem.json"), std::string::npos) << message;
  };
  expect("asperity-problem", "recipe", "/format is \"recipe\", but must be");
  expect("\"format_version\": 1", "\"format_version\": 2",
         "/format_version is 2, but must be 1");
  expect("\"points_x\": 64", "\"points_x\": 1",
         "/grid/points_x is 1, but must be a whole number between 2 and");
  expect("\"points_x\": 64", "\"points_x\": 64.5", "/grid/points_x is 64.5");
  expect("\"points_y\": 64", "\"points_z\": 64",
         "/grid/points_y is missing, but must be");
  expect("\"points_y\": 64", "\"points_y\": 32",
         "has 64 rows and 64 columns, but problem.json states 32 and 64");
  expect("\"length_x [m]\": 6.4e-05", "\"length_x [m]\": -1",
         "/grid/length_x [m] is -1, but must be a number > 0");
  expect("\"is_periodic\": true", "\"is_periodic\": 1",
         "/grid/is_periodic is 1, but must be true or false");
  expect("\"is_periodic\": true", "\"is_periodic\": false",
         "/body/thickness [m] is 3e-05, but must be null without periodic");
  expect("1000000000.0", "\"1 GPa\"",
         "/body/contact_modulus [Pa] is \"1 GPa\", but must be a number > 0");
  expect("\"poisson_ratio [1]\": 0.3", "\"poisson_ratio [1]\": 0.6",
         "is 0.6, but must be a number between -1 and 0.5");
  EXPECT_EQ(
      message_with("\"poisson_ratio [1]\": 0.3", "\"poisson_ratio [1]\": 0.5"),
      "accepted");
  expect("\"sliding\"", "\"glued\"",
         "/body/far_boundary is \"glued\", but must be clamped, sliding or");
  expect("\"youngs_modulus [Pa]\": 5000000000.0", "\"E\": 1",
         "/body/layers/0/youngs_modulus [Pa] is missing");
  expect("2000000.0", "null",
         "/loads/0/nominal_pressure [Pa] is null, but must be a number > 0");
  expect("\"format\"", "format", "problem.json:2: is not JSON");
}

// Another surface under the same name is refused by its checksum.
TEST_F(ProblemFolder, RefusesAnotherSurface) {
  problem.heights[7] += 1e-9;
  const std::string old_json = text_of(folder / "problem.json");
  write();
  std::ofstream(folder / "problem.json") << old_json;
  EXPECT_NE(tests::message_of<input::InputError>([&] {
              read_problem(folder);
            }).find("its SHA-256 is"),
            std::string::npos);
}

// No text of a few random bytes crashes the reader.
TEST_F(ProblemFolder, RefusesDamagedText) {
  const std::string json = text_of(folder / "problem.json");
  std::mt19937_64 random(3);
  for (int k = 0; k < 300; ++k) {
    std::string damaged = json;
    damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
    if (k % 3 == 0)
      damaged.resize(random() % damaged.size());
    std::ofstream(folder / "problem.json") << damaged;
    try {
      read_problem(folder);
    } catch (const input::InputError&) {
    }
  }
}

} // namespace asperity::exchange::problem_test
