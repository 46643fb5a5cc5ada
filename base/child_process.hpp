#pragma once

// A child process that is started under limits, monitored and terminated. No
// other module starts processes; a child never outlives its parent.

#include "base/file_descriptor.hpp"

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace asperity {

/// Path of the executable of that name along PATH; empty if there is none.
std::filesystem::path program_on_path(const std::string& name);

/// The environment of this process, "NAME=value" for each variable.
std::vector<std::string> own_environment();

/// The environment for a program that may start MPI itself: without the
/// variables by which mpirun and srun tell a process which rank it is, and
/// with those that Open MPI needs of the root user. Ranks that wait yield
/// their core, because other work may share it: a rank that spins takes a
/// whole time slice from the one that it waits for.
std::vector<std::string> environment_for_mpi();

/// Limits on a child; 0 means no limit.
struct ChildLimits {
  double wall_time = 0.0;       ///< time after which it is killed [s]
  double cpu_time = 0.0;        ///< in whole seconds, rounded up [s]
  std::uintmax_t memory = 0;    ///< size of its address space [B]
  std::uintmax_t file_size = 0; ///< of each file and of captured output [B]
};

struct ChildCommand {
  std::vector<std::string> words; ///< program (path, or name along PATH), then
                                  ///< its arguments; no shell is involved
  std::filesystem::path folder = {}; ///< working folder; empty: the parent's
  std::filesystem::path output = {}; ///< receives standard output and error;
                                     ///< empty: see ChildProcess::output()
  std::vector<std::string> environment = own_environment();
  ChildLimits limits = {};
  int death_signal = SIGKILL; ///< sent to the child when this process ends
};

/// How a child ended.
struct ChildEnd {
  int exit_code = -1;  ///< 128 + signal number if a signal ended it
  std::string failure; ///< "" after exit code 0, else "exit code 3", "signal 9
                       ///< (Killed)" or the limit that it exceeded
  double wall_time = 0.0; ///< [s]
  double cpu_time = 0.0;  ///< user and system [s]
};

/// A running child process. The constructor starts it; the destructor stops it
/// if it is still running.
///
/// The child leads its own process group: it and the processes that it starts
/// end together, and this process must forward an interrupt from the terminal.
/// Its standard input is empty, and it inherits no other open file. The kernel
/// ends it when the thread that started it ends, so that thread must wait for
/// it.
class ChildProcess {
public:
  /// @throws std::system_error  naming the program, if it cannot be started
  explicit ChildProcess(const ChildCommand& command);

  /// Starts a copy of this process, which must have a single thread. The copy
  /// calls `work` with the write end of output_pipe() and exits, with code 1 if
  /// `work` throws. No destructor of an object of the parent runs in it.
  /// @throws std::system_error  the copy cannot be started
  static ChildProcess forked(const std::function<void(int)>& work,
                             const ChildLimits& limits = {});

  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  /// Waits for at most `seconds` and returns true if the child has ended; kills
  /// a child that exceeds its wall time.
  bool has_ended(double seconds);

  /// Waits until the child has ended.
  const ChildEnd& wait();

  /// Asks the child to end, waits for a few seconds, then kills it.
  void stop();

  /// Asks the child to end (SIGTERM) and returns at once; kill() sends SIGKILL.
  void ask_to_end();
  void kill();

  /// Result of a child that has ended.
  const ChildEnd& end() const { return end_; }

  /// Standard output and error so far, if no file was given for them.
  std::string output() const;

  /// Read end of the pipe of a forked child, for poll() and read(); -1 for
  /// other children.
  int output_pipe() const { return pipe_.get(); }

  /// CPU time of the child so far, without that of its own children [s].
  double cpu_time() const;

private:
  using Clock = std::chrono::steady_clock;

  ChildProcess() = default;
  void started();
  void wait_for_change(double seconds) const;
  bool reap();

  pid_t process_ = 0;       ///< 0 once it has ended
  FileDescriptor watched_;  ///< becomes readable when the child ends
  FileDescriptor captured_; ///< captured output, in memory
  FileDescriptor pipe_;
  ChildLimits limits_;
  Clock::time_point start_;
  bool is_overdue_ = false;
  ChildEnd end_;
};

struct ChildAnswer {
  ChildEnd end;
  std::string output; ///< standard output and error, unless sent to a file
};

/// Runs a command until it ends.
/// @throws std::system_error  naming the program, if it cannot be started
ChildAnswer run_child(const ChildCommand& command);

} // namespace asperity
