#include "run/child_run.hpp"

#include "input/input_error.hpp"
#include "run/interrupt.hpp"

#include <csignal>
#include <utility>

namespace asperity::run {
namespace {

std::string own_program() {
  return std::filesystem::read_symlink("/proc/self/exe").string();
}

ChildEnd run_to_end(const ChildCommand& command) {
  constexpr double seconds_between_looks = 0.1;
  ChildProcess child(command);
  bool is_asked = false;
  while (!child.has_ended(seconds_between_looks))
    if (is_interrupted() && !std::exchange(is_asked, true))
      child.ask_to_end();
  return child.end();
}

} // namespace

ChildEnd run_self(const std::vector<std::string>& words,
                  const std::filesystem::path& log) {
  ChildCommand command{{own_program()}, {}, log, environment_for_mpi()};
  command.words.insert(command.words.end(), words.begin(), words.end());
  return run_to_end(command);
}

ChildEnd run_self_on_ranks(int ranks, const std::vector<std::string>& words,
                           const std::filesystem::path& log) {
  const std::filesystem::path mpirun = program_on_path("mpirun");
  if (mpirun.empty())
    throw input::InputError("several ranks need the program mpirun; install "
                            "the Debian package mpi-default-bin");
  ChildCommand command{{mpirun.string(), "-np", std::to_string(ranks),
                        "--oversubscribe", own_program()},
                       {},
                       log,
                       environment_for_mpi()};
  command.words.insert(command.words.end(), words.begin(), words.end());
  // mpirun ends its ranks if it is asked to end, but not if it is killed.
  command.death_signal = SIGTERM;
  return run_to_end(command);
}

} // namespace asperity::run
