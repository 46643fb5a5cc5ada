#include "suite/exchange/board/board.hpp"

#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/nearest.hpp"
#include "input/reader/read_case.hpp"
#include "run/methods/chosen.hpp"
#include "suite/exchange/answers/own_reference.hpp"
#include "suite/exchange/answers/reference_answers.hpp"
#include "suite/exchange/checksums.hpp"
#include "suite/exchange/problem_folder.hpp"
#include "suite/exchange/submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace asperity::exchange {
namespace {

namespace fs = std::filesystem;

/// Folders with a submission.toml, by problem, and links to folders, which are
/// refused one by one.
std::map<std::string, std::vector<fs::path>>
submission_folders(const fs::path& root) {
  std::map<std::string, std::vector<fs::path>> found;
  if (fs::is_directory(root))
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(root)) {
      const bool is_answer = entry.path().filename() == "submission.toml";
      if (!is_answer && !(entry.is_symlink() && entry.is_directory()))
        continue;
      const fs::path below = entry.path().lexically_relative(root);
      found[below.begin()->string()].push_back(
          is_answer ? entry.path().parent_path() : entry.path());
    }
  for (auto& [problem, folders] : found)
    std::ranges::sort(folders);
  return found;
}

/// Names of the sub-folders that state a problem.
std::vector<std::string> stated_problems(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (fs::exists(entry.path() / "problem.json") ||
        fs::exists(entry.path() / "case.toml"))
      names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

/// Copies the files of SHA256SUMS, and no others.
/// @throws input::InputError  there is none, or a file is not that of the sum
void copy_problem(const fs::path& home, const fs::path& copy) {
  std::vector<std::string> names = verified_files(home);
  if (names.empty())
    throw input::InputError(
        fmt::format("{}: is missing or empty; a problem is published with the "
                    "checksums of all its files, as asperity problem writes "
                    "them",
                    (home / checksum_file).string()));
  names.emplace_back(checksum_file);
  fs::create_directories(copy);
  for (const std::string& name : names)
    fs::copy_file(home / name, copy / name,
                  fs::copy_options::overwrite_existing);
  if (std::ranges::find(names, "reference.json") == names.end())
    fs::remove(copy / "reference.json"); // of an earlier site
}

/// The case of a problem, whose files are all in its folder.
cases::Case case_of_problem(const fs::path& home) {
  const fs::path file = home / "case.toml";
  cases::Case read = cases::read_case(file.string());
  std::vector<std::string> named{read.surface.file, read.mesh.file};
  if (read.material.variation)
    named.push_back(read.material.variation->file);
  for (const std::string& name : named)
    if (!name.empty())
      input::require_own_file(fs::absolute(home).lexically_normal(),
                              fs::absolute(name).lexically_normal());
  return read;
}

/// Reads a problem, or computes that of a case, and puts it into the site.
BoardProblem board_problem(const fs::path& folder, const std::string& name,
                           const fs::path& site) {
  const std::vector<std::string> names = stated_problems(folder);
  if (std::ranges::find(names, name) == names.end())
    throw input::InputError(
        fmt::format("{}: there are submissions to this problem, but no folder "
                    "{} with a problem.json or case.toml; nearest: {}",
                    (folder / "submissions" / name).string(),
                    (folder / name).string(), input::nearest(name, names)));
  const fs::path home = folder / name;
  const fs::path copy = site / "problems" / name;
  const bool is_stated = fs::exists(home / "problem.json");
  BoardProblem read;
  input::require_own_file(folder,
                          home / (is_stated ? "problem.json" : "case.toml"));
  if (is_stated) {
    copy_problem(home, copy);
  } else {
    read.contact_case = case_of_problem(home);
    const AnsweredProblem answered = answered_problem(*read.contact_case, "");
    write_certified_problem(answered, "", copy);
  }
  read.problem = read_problem(copy);
  if (read.problem.name != name)
    throw input::InputError(fmt::format(
        "{}: states the problem \"{}\", but its folder is {}: both must be the "
        "same",
        home.string(), read.problem.name, name));
  References references = read_references(copy);
  read.answers = std::move(references.discrete);
  read.continuum = std::move(references.continuum);
  return read;
}

double largest_error(const ImportedAnswer& answer,
                     double (*error)(const ImportedLoad&)) {
  double largest = 0.0;
  for (const ImportedLoad& load : answer.loads)
    largest = std::max(largest, error(load));
  return largest;
}

void add_numbers(const ImportedAnswer& answer, const Problem& problem,
                 BoardEntry& entry) {
  entry.loads = answer.loads.size();
  if (problem.adhesion) {
    entry.distance = largest_error(answer, [](const ImportedLoad& load) {
      return load.adhesive->distance / load.field.rms_height;
    });
    entry.energies.assign(problem.loads.size(), not_a_number);
    for (const ImportedLoad& load : answer.loads)
      entry.energies[static_cast<std::size_t>(load.field.step)] =
          load.adhesive->energy;
  } else {
    entry.gap_error = largest_error(answer, [](const ImportedLoad& load) {
      return load.field.error_of_field() / load.field.rms_height;
    });
    entry.pressure_error = largest_error(answer, [](const ImportedLoad& load) {
      return load.field.check.pressure_error;
    });
  }
  entry.cpu_time = entry.cpu_time_low = entry.cpu_time_high = 0.0;
  entry.peak_memory = 0.0;
  for (const ImportedLoad& load : answer.loads) {
    entry.cpu_time += load.answer.row.cpu_time;
    entry.cpu_time_low += load.cpu_time_low;
    entry.cpu_time_high += load.cpu_time_high;
    entry.peak_memory = std::fmax(entry.peak_memory, load.peak_memory);
    entry.iterations += load.answer.row.iterations;
    entry.mesh_error =
        std::fmax(entry.mesh_error, load.mesh_error / load.field.rms_height);
    for (const Claim& claim : load.field.claims)
      if (!claim.holds)
        entry.reasons.push_back(fmt::format(
            "{}: does not hold: {}",
            load.adhesive
                ? fmt::format("step {}", load.field.step)
                : fmt::format("{:.3g} Pa", load.field.nominal_pressure),
            claim.text));
    for (const std::string& mistake : load.mistakes)
      entry.reasons.push_back(fmt::format("{}: {}", load.file, mistake));
  }
  if (!(entry.cpu_time > 0.0))
    entry.cpu_time = not_a_number;
  if (!(entry.peak_memory > 0.0))
    entry.peak_memory = not_a_number;
  entry.missing_loads = problem.loads.size() - entry.loads;
}

/// The compliance of the mesh of a problem's [fem] with other elements; null:
/// it has none.
std::unique_ptr<contact::SurfaceOperator>
mesh_operator(const BoardProblem& board, const methods::SurfaceOfCase& surface,
              const std::string& element) {
  if (board.contact_case)
    for (cases::MethodSpec method : board.contact_case->methods)
      if (auto* fem = std::get_if<mechanics::FemSettings>(&method.settings);
          fem != nullptr && !methods::is_full_block(method)) {
        fem->block.element =
            element == "Q2" ? mechanics::Element::q2 : mechanics::Element::q1;
        return operator_of(*board.contact_case, method, surface);
      }
  return nullptr;
}

void add_continuum(const ImportedAnswer& answer, const BoardProblem& board,
                   BoardEntry& entry) {
  const double height = board.problem.rms_height;
  for (const ImportedLoad& load : answer.loads) {
    const auto step = static_cast<std::size_t>(load.field.step);
    if (step >= board.continuum.size())
      return;
    const ContinuumAnswer& limit = board.continuum[step];
    entry.continuum_error =
        std::fmax(entry.continuum_error,
                  std::abs(load.field.mean_gap - limit.mean_gap) / height);
    entry.continuum_uncertainty =
        std::fmax(entry.continuum_uncertainty, limit.mean_gap_error / height);
  }
}

/// @param root  that of all submissions, or the folder itself, if it is named
BoardEntry board_entry(const fs::path& folder, const fs::path& root,
                       const BoardProblem& board,
                       const methods::SurfaceOfCase& surface) {
  const Problem& problem = board.problem;
  BoardEntry entry;
  entry.is_named = folder == root;
  entry.folder = entry.is_named ? folder.string()
                                : folder.lexically_relative(root).string();
  entry.answer.problem = problem.name;
  // <problem>/<code>/<version>, until the submission has been read.
  const fs::path below = entry.folder;
  entry.answer.code = below.parent_path().filename().string();
  entry.answer.version = below.filename().string();
  try {
    if (!entry.is_named)
      input::require_own_file(root, folder);
    ImportedAnswer answer = import_answer(
        folder, problem, surface, [&](const std::string& element) {
          return mesh_operator(board, surface, element);
        });
    entry.answer = std::move(answer.submission);
    if (answer.loads.empty()) {
      entry.state = BoardEntry::State::as_submitted;
      return entry;
    }
    add_numbers(answer, problem, entry);
    add_continuum(answer, board, entry);
    entry.state = entry.reasons.empty() ? BoardEntry::State::certified
                                        : BoardEntry::State::failed;
  } catch (const std::exception& error) {
    entry.reasons.emplace_back(error.what());
  }
  return entry;
}

/// An answer and the folder below which none of its links is followed.
struct AnswerFolder {
  fs::path folder, root;
};

/// The answers of the board, and those that are named, by problem: of all
/// problems, or of those to which answers are named.
std::map<std::string, std::vector<AnswerFolder>>
answer_folders(const fs::path& folder, const std::vector<fs::path>& named) {
  const fs::path root = folder / "submissions";
  input::require_own_file(folder, root);
  std::map<std::string, std::vector<AnswerFolder>> found;
  for (const fs::path& answer : named)
    found[submitted_problem(answer)].push_back({answer, answer});
  for (const auto& [problem, folders] : submission_folders(root))
    if (named.empty() || found.contains(problem))
      for (const fs::path& answer : folders)
        found[problem].push_back({answer, root});
  if (found.empty())
    throw input::InputError(fmt::format(
        "{}: has no submission; expected <problem>/<code>/<version>/"
        "submission.toml",
        root.string()));
  if (named.empty())
    for (const std::string& problem : stated_problems(folder))
      found.try_emplace(problem);
  return found;
}

/// Energies that differ by less are the same [w].
constexpr double equal_energy = 1e-6;

/// Compares the energies of all entries, load by load.
void compare_energies(BoardProblem& board) {
  const double work = board.problem.adhesion->work_of_adhesion;
  for (std::size_t i = 0; i < board.problem.loads.size(); ++i) {
    const double reference =
        i < board.answers.size() ? board.answers[i].energy : not_a_number;
    double lowest = reference;
    for (const BoardEntry& entry : board.entries)
      if (entry.state == BoardEntry::State::certified &&
          entry.missing_loads == 0)
        lowest = std::fmin(lowest, entry.energies[i]);
    for (BoardEntry& entry : board.entries) {
      if (entry.energies.empty() || std::isnan(entry.energies[i]))
        continue;
      const double above = (entry.energies[i] - lowest) / work;
      entry.energy_above = std::fmax(entry.energy_above, 0.0) +
                           above / static_cast<double>(entry.loads);
      entry.lowest_loads += above <= equal_energy ? 1 : 0;
      entry.reference_loads +=
          std::abs(entry.energies[i] - reference) <= equal_energy * work ? 1
                                                                         : 0;
    }
  }
}

/// What entries are sorted by: errors, or energies that differ and then
/// distances from minima.
std::pair<double, double> merit(const BoardEntry& entry) {
  if (entry.energies.empty())
    return {entry.gap_error, 0.0};
  return {entry.energy_above <= equal_energy ? 0.0 : entry.energy_above,
          entry.distance};
}

std::string state_words(const BoardEntry& entry) {
  return entry.state == BoardEntry::State::certified
             ? entry.energies.empty()
                   ? fmt::format("certified, {:.1e} h_rms", entry.gap_error)
                   : fmt::format("certified, {:.1e} w above the lowest",
                                 entry.energy_above)
         : entry.state == BoardEntry::State::as_submitted
             ? "as submitted"
             : "failed: " + entry.reasons.front();
}

} // namespace

std::vector<BoardProblem> read_board(const fs::path& folder,
                                     const fs::path& site,
                                     const std::vector<fs::path>& named) {
  std::vector<BoardProblem> board;
  for (const auto& [name, answers] : answer_folders(folder, named)) {
    BoardProblem problem = board_problem(folder, name, site);
    const methods::SurfaceOfCase surface = surface_of(problem.problem);
    for (const AnswerFolder& answer : answers) {
      problem.entries.push_back(
          board_entry(answer.folder, answer.root, problem, surface));
    }
    if (problem.problem.adhesion)
      compare_energies(problem);
    for (const BoardEntry& entry : problem.entries)
      fmt::print("{:<60} {}\n", entry.folder, state_words(entry));
    std::ranges::stable_sort(
        problem.entries, [](const BoardEntry& a, const BoardEntry& b) {
          return std::tuple(a.state, a.missing_loads, merit(a)) <
                 std::tuple(b.state, b.missing_loads, merit(b));
        });
    board.push_back(std::move(problem));
  }
  return board;
}

} // namespace asperity::exchange
