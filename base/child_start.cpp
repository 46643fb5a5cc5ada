#include "base/child_start.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace asperity {
namespace {

/// Data that the child needs between vfork and exec, where it shares the memory
/// of the parent and must not allocate.
struct Prepared {
  const char* program = nullptr;
  char* const* words = nullptr;
  char* const* environment = nullptr;
  const char* folder = nullptr;
  int input = -1;
  int output = -1;
  pid_t parent = 0;
  int death_signal = 0;
  const ChildLimits* limits = nullptr;
  sigset_t signals{}; ///< signal mask of this thread, restored in the child
};

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Limits a resource, to what this process may have if that is less: a limit
/// cannot be raised above that of the shell or of the scheduler.
bool limit(int resource, rlim_t soft, rlim_t hard) {
  const auto limited = static_cast<__rlimit_resource_t>(resource);
  rlimit present{};
  if (getrlimit(limited, &present) != 0)
    return false;
  const rlimit values{std::min(soft, present.rlim_max),
                      std::min(hard, present.rlim_max)};
  return setrlimit(limited, &values) == 0;
}

/// Resets the signal handlers: a handler that runs in the child would change
/// the memory of the parent.
void forget_signal_handlers() {
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action {};

    if (sigaction(number, nullptr, &action) == 0 &&
        action.sa_handler != SIG_IGN && action.sa_handler != SIG_DFL) {
      action = {};
      action.sa_handler = SIG_DFL;
      sigaction(number, &action, nullptr);
    }
  }
}

/// Executes the program. Returns only on failure; errno holds the reason.
void become(const Prepared& child) {
  forget_signal_handlers();
  if (setpgid(0, 0) != 0 ||
      !bind_to_parent(child.parent, child.death_signal, *child.limits) ||
      dup2(child.input, STDIN_FILENO) < 0 ||
      dup2(child.output, STDOUT_FILENO) < 0 ||
      dup2(child.output, STDERR_FILENO) < 0 ||
      (child.folder != nullptr && chdir(child.folder) != 0))
    return;
  constexpr unsigned first_inherited = 3;
  close_range(first_inherited, ~0U, 0); // no effect on older kernels
  sigprocmask(SIG_SETMASK, &child.signals, nullptr);
  execve(child.program, child.words, child.environment);
}

/// Starts the child and returns its error, 0 if it runs. With vfork the parent
/// waits until exec, and the start is as fast from a large process as from a
/// small one.
[[gnu::noinline]] int start(const Prepared& child, pid_t& process) {
  volatile int error = 0;
  const pid_t started = vfork();
  if (started < 0)
    return errno;
  if (started == 0) {
    become(child);
    error = errno;
    _exit(127);
  }
  process = started;
  return error;
}

} // namespace

bool bind_to_parent(pid_t parent, int death_signal, const ChildLimits& limits) {
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.cpu_time));
  if ((seconds > 0 && !limit(RLIMIT_CPU, seconds, seconds + 1)) ||
      (limits.memory > 0 && !limit(RLIMIT_AS, limits.memory, limits.memory)) ||
      (limits.file_size > 0 &&
       !limit(RLIMIT_FSIZE, limits.file_size, limits.file_size)) ||
      prctl(PR_SET_PDEATHSIG, death_signal) != 0)
    return false;
  errno = ESRCH;
  return getppid() == parent; // false if the parent has already ended
}

pid_t start_process(const ChildCommand& command, int output) {
  const std::string& name = command.words.at(0);
  const std::string program = name.find('/') == std::string::npos
                                  ? program_on_path(name).string()
                                  : name;
  const auto check = [&](int error) {
    if (error != 0)
      throw std::system_error(error, std::generic_category(),
                              name + " cannot be started");
  };
  check(program.empty() ? ENOENT : 0);
  const FileDescriptor input(open("/dev/null", O_RDONLY | O_CLOEXEC));
  check(input.get() < 0 ? errno : 0);
  std::vector<std::string> words = command.words;
  std::vector<std::string> environment = command.environment;
  const std::vector<char*> word_pointers = pointers_to(words);
  const std::vector<char*> variable_pointers = pointers_to(environment);
  Prepared child{program.c_str(),
                 word_pointers.data(),
                 variable_pointers.data(),
                 command.folder.empty() ? nullptr : command.folder.c_str(),
                 input.get(),
                 output,
                 getpid(),
                 command.death_signal,
                 &command.limits};
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &child.signals);
  pid_t process = 0;
  const int error = start(child, process);
  pthread_sigmask(SIG_SETMASK, &child.signals, nullptr);
  if (error != 0 && process > 0)
    waitpid(process, nullptr, 0);
  check(error);
  return process;
}

} // namespace asperity
