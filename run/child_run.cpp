#include "run/child_run.hpp"

#include "run/interrupt.hpp"

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

} // namespace asperity::run
