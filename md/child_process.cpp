#include "md/child_process.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <string_view>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace asperity::md {
namespace {

constexpr double seconds_to_end = 3.0; ///< granted to a child asked to stop

void check(int error, const std::string& what) {
  if (error != 0)
    throw std::system_error(error, std::generic_category(), what);
}

std::vector<std::string> environment() {
  std::vector<std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view variable = *entry;
    if (!variable.starts_with("OMPI_") && !variable.starts_with("PMIX_"))
      variables.emplace_back(variable);
  }
  variables.emplace_back("OMP_NUM_THREADS=1");
  if (::geteuid() == 0) {
    variables.emplace_back("OMPI_ALLOW_RUN_AS_ROOT=1");
    variables.emplace_back("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1");
  }
  return variables;
}

/// The array of C strings that exec wants; lives as long as `words`.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// What posix_spawn is told besides the command.
struct SpawnSettings {
  SpawnSettings(const std::filesystem::path& folder,
                const std::filesystem::path& output) {
    check(posix_spawn_file_actions_init(&actions), "posix_spawn");
    check(posix_spawnattr_init(&attributes), "posix_spawn");
    check(posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null",
                                           O_RDONLY, 0),
          "posix_spawn");
    check(posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO,
                                           output.c_str(),
                                           O_WRONLY | O_CREAT | O_TRUNC, 0666),
          "posix_spawn");
    check(posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO,
                                           STDERR_FILENO),
          "posix_spawn");
    check(posix_spawn_file_actions_addchdir_np(&actions, folder.c_str()),
          "posix_spawn");
    check(posix_spawnattr_setpgroup(&attributes, 0), "posix_spawn");
    check(posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP),
          "posix_spawn");
  }

  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }

  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
};

} // namespace

std::filesystem::path program_on_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path candidate =
        std::filesystem::absolute(std::filesystem::path(folder) / name);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(candidate, ignored) &&
        ::access(candidate.c_str(), X_OK) == 0)
      return candidate;
  }
  return {};
}

ChildProcess::ChildProcess(const std::vector<std::string>& command,
                           const std::filesystem::path& folder,
                           const std::filesystem::path& output) {
  const SpawnSettings settings(folder, std::filesystem::absolute(output));
  std::vector<std::string> words = command;
  std::vector<std::string> variables = environment();
  check(posix_spawn(&process_, command.front().c_str(), &settings.actions,
                    &settings.attributes, pointers_to(words).data(),
                    pointers_to(variables).data()),
        "cannot start " + command.front());
}

ChildProcess::~ChildProcess() {
  stop();
}

bool ChildProcess::has_ended(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (process_ != 0) {
    const pid_t ended = ::waitpid(process_, &status_, WNOHANG);
    if (ended == process_ || (ended < 0 && errno != EINTR)) {
      process_ = 0;
      break;
    }
    if (Clock::now() >= end)
      return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

std::string ChildProcess::failure() const {
  if (WIFSIGNALED(status_))
    return "signal " + std::to_string(WTERMSIG(status_));
  if (WEXITSTATUS(status_) != 0)
    return "exit code " + std::to_string(WEXITSTATUS(status_));
  return "";
}

void ChildProcess::stop() {
  if (has_ended(0.0))
    return;
  const pid_t group = process_;
  ::kill(-group, SIGTERM);
  if (!has_ended(seconds_to_end)) {
    ::kill(-group, SIGKILL);
    has_ended(seconds_to_end);
  }
}

} // namespace asperity::md
