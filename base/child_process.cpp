#include "base/child_process.hpp"

#include "base/child_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <limits>
#include <poll.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
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
