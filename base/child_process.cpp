#include "base/child_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <poll.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

namespace asperity {
namespace {

constexpr double seconds_to_end = 3.0; ///< for a child that was asked to stop
constexpr double longest_look = 0.05;  ///< interval of time limit checks [s]

void check(bool is_good, const std::string& what) {
  if (!is_good)
    throw std::system_error(errno, std::generic_category(), what);
}

double in_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) +
         1e-6 * static_cast<double>(time.tv_usec);
}

/// Opens the file that receives the child's standard output and error.
FileDescriptor open_output(const ChildCommand& command) {
  FileDescriptor file(command.output.empty()
                          ? memfd_create("output", MFD_CLOEXEC)
                          : open(command.output.c_str(),
                                 O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC,
                                 0666));
  check(file.get() >= 0, "cannot write " + command.output.string());
  return file;
}

std::string failure_of(int status, const ChildLimits& limits) {
  if (WIFEXITED(status))
    return WEXITSTATUS(status) == 0
               ? ""
               : fmt::format("exit code {}", WEXITSTATUS(status));
  const int number = WTERMSIG(status);
  if (number == SIGXCPU && limits.cpu_time > 0.0)
    return fmt::format("more than {:g} s of CPU time", limits.cpu_time);
  return fmt::format("signal {} ({})", number, sigdescr_np(number));
}

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

/// Binds a new child to the life of its parent and sets its limits. Must be
/// called in the child; uses only functions that are safe after vfork.
/// @param parent  process number of the parent, obtained before the start
/// @return  false on failure: errno holds the reason, or the parent has ended
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

/// Starts the command with its standard output and error redirected to
/// `output`.
/// @throws std::system_error  naming the program, if it cannot be started
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

} // namespace

std::filesystem::path program_on_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::filesystem::path candidate =
        std::filesystem::absolute(std::filesystem::path(folder) / name);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(candidate, ignored) &&
        ::access(candidate.c_str(), X_OK) == 0)
      return candidate;
  }
  return {};
}

std::vector<std::string> own_environment() {
  std::vector<std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry)
    variables.emplace_back(*entry);
  return variables;
}

std::vector<std::string> environment_for_mpi() {
  std::vector<std::string> variables = own_environment();
  std::erase_if(variables, [](const std::string& variable) {
    return variable.starts_with("OMPI_") || variable.starts_with("ORTE_") ||
           variable.starts_with("PMIX_") || variable.starts_with("PMI_");
  });
  variables.emplace_back("OMPI_MCA_mpi_yield_when_idle=1");
  if (::geteuid() == 0) {
    variables.emplace_back("OMPI_ALLOW_RUN_AS_ROOT=1");
    variables.emplace_back("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1");
  }
  return variables;
}

ChildProcess::ChildProcess(const ChildCommand& command)
    : limits_(command.limits) {
  captured_ = open_output(command);
  process_ = start_process(command, captured_.get());
  if (!command.output.empty())
    captured_.reset();
  started();
}

ChildProcess ChildProcess::forked(const std::function<void(int)>& work,
                                  const ChildLimits& limits) {
  ChildProcess child;
  child.limits_ = limits;
  int ends[2];
  check(pipe2(ends, O_CLOEXEC) == 0, "no pipe to a child process");
  child.pipe_ = FileDescriptor(ends[0]);
  const FileDescriptor write_end(ends[1]);
  const pid_t parent = getpid();
  child.process_ = fork();
  check(child.process_ >= 0, "no child process could be started");
  if (child.process_ == 0) {
    child.pipe_.reset();
    setpgid(0, 0);
    try {
      if (bind_to_parent(parent, SIGKILL, limits)) {
        work(write_end.get());
        _exit(0);
      }
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}\n", error.what());
    }
    _exit(1);
  }
  child.started();
  return child;
}

void ChildProcess::started() {
  setpgid(process_, process_); // the child does the same; the first call wins
  start_ = Clock::now();
  // The system call is made by number, because the header of glibc 2.36
  // declares the function for C only.
  watched_ =
      FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, process_, 0)));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept {
  *this = std::move(other);
}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(watched_, other.watched_);
  std::swap(captured_, other.captured_);
  std::swap(pipe_, other.pipe_);
  std::swap(limits_, other.limits_);
  std::swap(start_, other.start_);
  std::swap(is_overdue_, other.is_overdue_);
  std::swap(end_, other.end_);
  return *this;
}

ChildProcess::~ChildProcess() {
  stop();
}

/// Waits until the process ends or the time has passed. Without a file
/// descriptor for the process (older kernels) it returns early, and the caller
/// checks the state again.
void ChildProcess::wait_for_change(double seconds) const {
  if (watched_.get() < 0) {
    constexpr double look = 0.002;
    std::this_thread::sleep_for(
        std::chrono::duration<double>(std::min(seconds, look)));
    return;
  }
  pollfd watched{watched_.get(), POLLIN, 0};
  poll(&watched, 1, static_cast<int>(1e3 * seconds));
}

/// Collects the exit status if there is one. A status that is lost counts as a
/// failure.
bool ChildProcess::reap() {
  int status = 0;
  rusage used{};
  const pid_t ended = wait4(process_, &status, WNOHANG, &used);
  if (ended == 0 || (ended < 0 && errno == EINTR))
    return false;
  end_.wall_time = std::chrono::duration<double>(Clock::now() - start_).count();
  if (ended == process_) {
    end_.cpu_time = in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
    end_.exit_code =
        WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    end_.failure = is_overdue_
                       ? fmt::format("longer than {:g} s", limits_.wall_time)
                       : failure_of(status, limits_);
  } else {
    end_.failure = fmt::format("an unknown exit status: {}", strerror(errno));
  }
  process_ = 0;
  return true;
}

bool ChildProcess::has_ended(double seconds) {
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  while (process_ != 0 && !reap()) {
    const auto now = Clock::now();
    const double run_time = std::chrono::duration<double>(now - start_).count();
    if (limits_.wall_time > 0.0 && run_time > limits_.wall_time &&
        !std::exchange(is_overdue_, true))
      kill();
    if (now >= until)
      return false;
    const double left = std::chrono::duration<double>(until - now).count();
    wait_for_change(std::min(left, longest_look));
  }
  return true;
}

const ChildEnd& ChildProcess::wait() {
  constexpr double a_day = 86400.0;
  while (!has_ended(a_day)) {
  }
  return end_;
}

void ChildProcess::ask_to_end() {
  if (process_ > 0)
    ::kill(-process_, SIGTERM);
}

void ChildProcess::kill() {
  if (process_ > 0)
    ::kill(-process_, SIGKILL);
}

void ChildProcess::stop() {
  if (has_ended(0.0))
    return;
  ask_to_end();
  if (!has_ended(seconds_to_end)) {
    kill();
    has_ended(seconds_to_end);
  }
}

std::string ChildProcess::output() const {
  std::string text;
  char buffer[65536];
  for (;;) {
    const ssize_t n = pread(captured_.get(), buffer, sizeof buffer,
                            static_cast<off_t>(text.size()));
    if (n <= 0)
      return text;
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

double ChildProcess::cpu_time() const {
  clockid_t clock{};
  timespec time{};
  if (process_ == 0 || clock_getcpuclockid(process_, &clock) != 0 ||
      clock_gettime(clock, &time) != 0)
    return 0.0;
  return static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(time.tv_nsec);
}

ChildAnswer run_child(const ChildCommand& command) {
  ChildProcess child(command);
  child.wait();
  return {child.end(), child.output()};
}

} // namespace asperity
