// A full model of a case that all ranks solve, with a failure injected on one
// rank or on all; ranks_failures_test.py runs it under mpirun. It ends as the
// program does, with the message of the failure on standard error and its exit
// code.
//
//     ranks_failures case.toml none
//     ranks_failures case.toml build|solve|write before|after rank|all
#include "fem/block/mesh_file.hpp"
#include "fem/full_request.hpp"
#include "fem/parallel/ranks.hpp"
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "meshes/valid_mesh.hpp"

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace asperity;
using namespace asperity::fem;

/// Where to fail, and whether before or after the collective part.
struct Injection {
  std::string stage = "none", when = "before", rank = "all";

  void at(const std::string& here, const std::string& now) const {
    if (stage == here && when == now &&
        (rank == "all" || std::stoi(rank) == own_rank()))
      throw std::runtime_error("injected into " + stage + " on rank " +
                               std::to_string(own_rank()));
  }
};

class FailingBlock final : public FullBlock {
public:
  FailingBlock(const BlockProblem& problem, const Injection& injection)
      : own_(make_full_block(problem)), injection_(injection) {}

  const Grid& grid() const override { return own_->grid(); }

  std::size_t unknowns() const override { return own_->unknowns(); }

  std::span<const double> nodal_weights() const override {
    return own_->nodal_weights();
  }

  std::string report() const override { return own_->report(); }

  std::vector<double> displacement(std::span<const double> p) override {
    return own_->displacement(p);
  }

  BlockSolution solve(std::span<const double> heights,
                      const mechanics::LoadTarget& load,
                      const BlockContact& contact) override {
    injection_.at("solve", "before");
    BlockSolution found = own_->solve(heights, load, contact);
    injection_.at("solve", "after");
    return found;
  }

  ContactStiffness stiffness() override { return own_->stiffness(); }

  BlockConduction conduction() const override { return own_->conduction(); }

  StressPeak strongest_stress() const override {
    return own_->strongest_stress();
  }

  std::vector<double> section(const SectionPlane& plane) const override {
    return own_->section(plane);
  }

  void write(const std::string& folder_and_stem) override {
    injection_.at("write", "before");
    own_->write(folder_and_stem);
    injection_.at("write", "after");
  }

private:
  std::unique_ptr<FullBlock> own_;
  Injection injection_;
};

/// Returns whether the step has converged.
bool solve(const std::string& path, const Injection& injection) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  const Grid grid{8, 8, 1e-6, 1e-6};
  const cases::Case contact_case = cases::read_case_text(text.str(), path);
  const auto& settings =
      std::get<mechanics::FemSettings>(contact_case.methods.at(0).settings);
  FullRequest request{grid,
                      settings.block,
                      settings.full,
                      contact_case.material,
                      contact_case.mesh,
                      {2e9, 1e-6, 1.25e-7, 1e-9}};
  if (const auto& mesh = contact_case.mesh;
      !mesh.file.empty() && own_rank() == 0) {
    request.file_mesh = read_mesh_file(mesh.file, mesh.file_unit).mesh;
    meshes::fit_sides(*request.file_mesh, settings.full.sides);
  }
  injection.at("build", "before");
  FailingBlock block(problem_on_ranks(request), injection);
  injection.at("build", "after");
  std::vector<double> heights(grid.size(), 0.0);
  heights[9] = 1e-9;
  const BlockSolution found =
      block.solve(heights, {mechanics::Control::nominal_pressure, 1e6},
                  {mechanics::ContactLaw::penalty, 1e18, 1e-8, 50});
  block.write("files/block");
  return found.converged;
}

/// Rank 0 says why all ranks have failed.
int ended(const std::string& words, int exit_code) {
  if (own_rank() != 0)
    return 0;
  std::fprintf(stderr, "%s\n", words.c_str());
  return exit_code;
}

} // namespace

int main(int n_arguments, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + n_arguments);
  Injection injection;
  if (words.size() == 4)
    injection = {words[1], words[2], words[3]};
  try {
    bool has_converged = false;
    do_share([&] { has_converged = solve(words.at(0), injection); });
    if (own_rank() == 0)
      std::printf("done %d\n", has_converged);
    return 0;
  } catch (const input::InputError& error) {
    return ended(error.what(), 2);
  } catch (const std::domain_error& error) {
    return ended(error.what(), 2);
  } catch (const std::exception& error) {
    return ended(std::string("asperity: ") + error.what(), 4);
  }
}
