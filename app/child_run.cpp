#include "app/child_run.hpp"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace asperity::app {
namespace {

double in_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) +
         1e-6 * static_cast<double>(time.tv_usec);
}

/// Where the child's words go; freed with it.
class Redirection {
public:
  explicit Redirection(const std::filesystem::path& log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }

  ~Redirection() { posix_spawn_file_actions_destroy(&actions_); }

  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;

  const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
  posix_spawn_file_actions_t actions_{};
};

pid_t start(const std::vector<std::string>& words,
            const std::filesystem::path& log) {
  const std::string program =
      std::filesystem::read_symlink("/proc/self/exe").string();
  std::vector<std::string> copies{program};
  copies.insert(copies.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : copies)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const Redirection redirection(log);
  pid_t child = 0;
  const int failure = posix_spawn(&child, program.c_str(), redirection.get(),
                                  nullptr, pointers.data(), environ);
  if (failure != 0)
    throw std::system_error(failure, std::generic_category(), program);
  return child;
}

} // namespace

ChildEnd run_self(const std::vector<std::string>& words,
                  const std::filesystem::path& log) {
  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = start(words, log);
  int status = 0;
  rusage used{};
  while (wait4(child, &status, 0, &used) < 0)
    if (errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "wait4");
  const std::chrono::duration<double> wall =
      std::chrono::steady_clock::now() - begin;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          wall.count(), in_seconds(used.ru_utime) + in_seconds(used.ru_stime),
          1024.0 * static_cast<double>(used.ru_maxrss)};
}

} // namespace asperity::app
