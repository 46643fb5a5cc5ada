#include "app/run/child_run.hpp"

#include "app/run/interrupt.hpp"

#include <utility>

namespace asperity::app {

ChildEnd run_self(const std::vector<std::string>& words,
                  const std::filesystem::path& log) {
  constexpr double seconds_between_looks = 0.1;
  ChildCommand command{
      {std::filesystem::read_symlink("/proc/self/exe").string()}, {}, log};
  command.words.insert(command.words.end(), words.begin(), words.end());
  ChildProcess child(command);
  bool is_asked = false;
  while (!child.has_ended(seconds_between_looks))
    if (is_interrupted() && !std::exchange(is_asked, true))
      child.ask_to_end();
  return child.end();
}

} // namespace asperity::app
