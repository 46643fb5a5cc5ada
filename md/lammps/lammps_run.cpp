#include "md/lammps/lammps_run.hpp"

#include "base/child_process.hpp"
#include "input/input_error.hpp"
#include "md/lammps/lammps_answer.hpp"

#include <fmt/format.h>

#include <utility>

namespace asperity::md {
namespace {

constexpr double seconds_between_looks = 0.25;

/// Builds the command. mpirun terminates its ranks if it is asked to terminate,
/// but not if it is killed.
ChildCommand lammps_command(std::vector<std::string> words,
                            const std::filesystem::path& folder,
                            const std::filesystem::path& output) {
  ChildCommand command{std::move(words), folder, output, environment_for_mpi()};
  command.environment.emplace_back("OMP_NUM_THREADS=1");
  command.death_signal = SIGTERM;
  return command;
}

/// Returns the version, e.g. "29 Sep 2021 - Update 2", which follows "Simulator
/// - " in the output of `lmp -h`.
std::string version_of(const std::filesystem::path& lmp,
                       const std::filesystem::path& folder) {
  const std::filesystem::path output = folder / "lammps-version.txt";
  ChildCommand command = lammps_command({lmp.string(), "-h"}, folder, output);
  command.limits.wall_time = 60.0;
  const ChildEnd end = run_child(command).end;
  const std::string text = file_text(output);
  const std::string before = "Simulator - ";
  const std::size_t found = text.find(before);
  if (!end.failure.empty() || found == std::string::npos)
    throw input::InputError(fmt::format("[md] engine = \"lammps\": {} -h does "
                                        "not print a LAMMPS version; see {}",
                                        lmp.string(), output.string()));
  const std::size_t begin = found + before.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos)
    return "no output";
  const std::size_t begin = text.rfind('\n', end);
  const std::size_t first = begin == std::string::npos ? 0 : begin + 1;
  return text.substr(first, end - first + 1);
}

} // namespace

LammpsProgram require_lammps(int ranks) {
  LammpsProgram program;
  program.ranks = ranks;
  program.lmp = program_on_path("lmp");
  if (program.lmp.empty())
    throw input::InputError("[md] engine = \"lammps\" needs the program lmp; "
                            "install the Debian package lammps");
  if (ranks > 1) {
    program.mpirun = program_on_path("mpirun");
    if (program.mpirun.empty())
      throw input::InputError("[md] ranks above 1 need the program mpirun; "
                              "install the Debian package mpi-default-bin");
  }
  return program;
}

LammpsProgram find_lammps(int ranks, const std::filesystem::path& folder) {
  LammpsProgram program = require_lammps(ranks);
  std::filesystem::create_directories(folder);
  program.version = version_of(program.lmp, folder);
  return program;
}

LammpsRun run_lammps(const LammpsProgram& program,
                     const std::filesystem::path& folder,
                     const std::string& input, const std::string& log,
                     const std::function<bool(const std::string&)>& go_on) {
  std::vector<std::string> command = {program.lmp.string(),
                                      "-in",
                                      input,
                                      "-log",
                                      log,
                                      "-screen",
                                      "none",
                                      "-nocite"};
  if (program.ranks > 1)
    command.insert(command.begin(), {program.mpirun.string(), "-np",
                                     std::to_string(program.ranks)});
  const std::filesystem::path log_path = folder / log;
  const std::filesystem::path output = folder / (log + ".out");
  std::filesystem::remove(log_path);
  ChildProcess child(lammps_command(std::move(command), folder, output));
  while (!child.has_ended(seconds_between_looks)) {
    if (go_on && !go_on(file_text(log_path))) {
      child.stop();
      return {false, "stopped while LAMMPS was running"};
    }
  }
  const std::string& failure = child.end().failure;
  if (failure.empty())
    return {true, ""};
  std::string words = error_in(file_text(log_path));
  if (words.empty())
    words = last_line(file_text(output));
  return {false, fmt::format("LAMMPS ended with {}: {} (see {})", failure,
                             words, log_path.string())};
}

} // namespace asperity::md
