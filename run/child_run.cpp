#include "run/child_run.hpp"

#include "run/interrupt.hpp"

#include <algorithm>
#include <deque>
#include <fstream>
#include <utility>

namespace asperity::run {

ChildEnd run_self(const std::vector<std::string>& words,
                  const std::filesystem::path& log) {
  constexpr double seconds_between_looks = 0.1;
  ChildCommand command{
      {std::filesystem::read_symlink("/proc/self/exe").string()},
      {},
      log,
      environment_for_mpi()};
  command.words.insert(command.words.end(), words.begin(), words.end());
  ChildProcess child(command);
  bool is_asked = false;
  while (!child.has_ended(seconds_between_looks))
    if (is_interrupted() && !std::exchange(is_asked, true))
      child.ask_to_end();
  return child.end();
}

std::vector<std::string> words_of_run(const std::filesystem::path& case_file,
                                      const std::vector<std::string>& overrides,
                                      const methods::AskedMethods& methods) {
  std::vector<std::string> words{"run", case_file.string()};
  for (const std::string& entry : overrides)
    words.insert(words.end(), {"--set", entry});
  for (const std::string& method : methods.names)
    words.insert(words.end(), {"--methods", method});
  if (methods.is_exact)
    words.emplace_back("--exactly");
  return words;
}

std::string end_of_log(const std::filesystem::path& log) {
  std::ifstream stream(log);
  std::deque<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty())
      lines.push_back(line);
  constexpr std::size_t most_lines = 3;
  std::string text;
  for (std::size_t i = lines.size() - std::min(lines.size(), most_lines);
       i < lines.size(); ++i)
    text += (text.empty() ? "" : "; ") + lines[i].substr(0, 300);
  return text;
}

} // namespace asperity::run
