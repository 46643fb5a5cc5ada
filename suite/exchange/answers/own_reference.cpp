#include "suite/exchange/answers/own_reference.hpp"

#include "base/atomic_file.hpp"
#include "base/temporary_folder.hpp"
#include "suite/exchange/answers/imported_answer.hpp"
#include "suite/exchange/problem_folder.hpp"
#include "surfaces/formats/npy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::exchange {
namespace {

namespace fs = std::filesystem;

/// The reference is claimed to be as exact as it says it is, and no worse than
/// this, so that a nearly equal problem is not taken for the same.
constexpr double least_claimed_error = 1e-9; // [h_rms]

/// The error of the mean gap that the reference answers state [h_rms].
double claimed_error(const AnsweredProblem& answered) {
  double largest = least_claimed_error;
  for (const ProblemAnswer& answer : answered.answers)
    largest = std::fmax(largest, 2.0 * answer.mean_gap_error /
                                     answered.problem.rms_height);
  return std::min(largest, 1e-3);
}

/// Writes the reference as a submission.
void write_answer(const AnsweredProblem& answered, const fs::path& folder) {
  fs::create_directories(folder);
  const Grid& grid = answered.problem.grid;
  std::string text = fmt::format(
      "problem = \"{}\"\ncode = \"asperity\"\nversion = \"reference\"\n"
      "method = \"reference answer\"\naccuracy = \"best\"\n"
      "authors = [\"asperity\"]\nlicence = \"CC0-1.0\"\nclaimed_error = {}\n",
      answered.problem.name, claimed_error(answered));
  for (std::size_t i = 0; i < answered.answers.size(); ++i) {
    const ProblemAnswer& answer = answered.answers[i];
    const std::string file = fmt::format("pressure-{}.npy", i + 1);
    write_file_atomically(
        folder / file,
        surfaces::npy_bytes(answered.pressures[i],
                            static_cast<std::size_t>(grid.points_y),
                            static_cast<std::size_t>(grid.points_x)));
    text += fmt::format("[[load]]\npressure = \"{}\"\n", file);
    text += answered.problem.adhesion
                ? fmt::format("step = {}\nenergy = {}\n", i, answer.energy)
                : fmt::format("nominal_pressure = {}\nmean_gap = {}\n"
                              "contact_area_fraction = {}\n"
                              "elastic_energy = {}\n",
                              answer.nominal_pressure, answer.mean_gap,
                              answer.area_fraction, answer.elastic_energy);
  }
  write_file_atomically(folder / "submission.toml", text);
}

std::string broken_claims_of(const fs::path& answer, const Problem& problem,
                             const std::string& where) {
  const ImportedAnswer imported =
      import_answer(answer, problem, surface_of(problem));
  std::string broken;
  for (const ImportedLoad& load : imported.loads) {
    if (load.is_sound())
      continue;
    broken +=
        fmt::format("as {} states it, p_0 = {:g} Pa:\n{}", where,
                    load.field.nominal_pressure, broken_claims(load.field));
    for (const std::string& mistake : load.mistakes)
      broken += fmt::format("  {}\n", mistake);
  }
  return broken;
}

/// Whether what a README says is what problem.json says, which is certified.
bool is_same(const StatedBody& readme, const Problem& stated) {
  return readme.body.border == stated.body.border &&
         readme.body.contact_modulus == stated.body.contact_modulus &&
         readme.body.thickness == stated.body.thickness &&
         readme.body.layers.empty() && stated.body.layers.empty();
}

} // namespace

std::string broken_reference(const AnsweredProblem& answered,
                             const fs::path& folder) {
  const TemporaryFolder scratch("asperity-reference");
  write_answer(answered, scratch.path());
  Problem stated = read_problem(folder);
  std::string broken = broken_claims_of(scratch.path(), stated, "problem.json");
  if (const StatedBody body = stated_body(answered.problem);
      body.is_complete && !is_same(body, stated)) {
    stated.body = body.body;
    broken += broken_claims_of(scratch.path(), stated, "README.md");
  }
  return broken;
}

void write_certified_problem(const AnsweredProblem& answered,
                             const std::string& case_text,
                             const fs::path& folder, const ProblemMesh* mesh) {
  const auto write = [&](const fs::path& to) {
    write_problem(answered.problem, answered.answers, answered.continuum,
                  case_text, to, mesh);
  };
  {
    const TemporaryFolder scratch("asperity-problem");
    write(scratch.path());
    if (const std::string broken = broken_reference(answered, scratch.path());
        !broken.empty())
      throw std::logic_error(fmt::format(
          "{}: the reference answers another problem than the files would "
          "state, and nothing was written; please report this\n{}",
          answered.problem.name, broken));
  }
  write(folder);
}

} // namespace asperity::exchange
