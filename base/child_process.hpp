#pragma once

// One child process: started under limits, watched, ended. The only place in
// the tree that starts a process; a child never outlives the one that did.

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

/// The executable of that name along PATH; empty if there is none.
std::filesystem::path program_on_path(const std::string& name);

/// "NAME=value" of each variable of this process.
std::vector<std::string> own_environment();

/// What a child may take; 0 is no limit.
struct ChildLimits {
  double wall_time = 0.0;       ///< until it is killed [s]
  double cpu_time = 0.0;        ///< counted in whole seconds, rounded up [s]
  std::uintmax_t memory = 0;    ///< of its address space [B]
  std::uintmax_t file_size = 0; ///< of each file and of captured output [B]
};

struct ChildCommand {
  std::vector<std::string> words; ///< program (path, or name along PATH), then
                                  ///< its arguments; no shell reads them
  std::filesystem::path folder = {}; ///< its working folder; empty: ours
  std::filesystem::path output = {}; ///< gets standard output and error;
                                     ///< empty: ChildProcess::output() has them
  std::vector<std::string> environment = own_environment();
  ChildLimits limits = {};
  int death_signal = SIGKILL; ///< what the child gets when this process dies
};

/// How a child ended.
struct ChildEnd {
  int exit_code = -1;  ///< 128 + signal if one ended it
  std::string failure; ///< "" after exit code 0, else "exit code 3", "signal 9
                       ///< (Killed)" or the limit that it exceeded
  double wall_time = 0.0; ///< [s]
  double cpu_time = 0.0;  ///< user and system [s]
};

/// Started by the constructor; the destructor ends what still runs.
///
/// The child leads a process group of its own: it and what it starts end
/// together, and an interrupt at the terminal is ours to pass on. Its standard
/// input is empty, and no other open file of ours reaches it. The kernel ends
/// it when the thread that started it ends, so that thread must wait for it.
class ChildProcess {
public:
  /// @throws std::system_error  naming the program: it cannot be started
  explicit ChildProcess(const ChildCommand& command);

  /// A copy of this process, which has to have one thread: it calls `work` with
  /// the write end of output_pipe() and exits, with code 1 if `work` throws.
  /// No destructor of the parent's objects runs in it.
  /// @throws std::system_error  it cannot be started
  static ChildProcess forked(const std::function<void(int)>& work,
                             const ChildLimits& limits = {});

  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  /// Waits for at most `seconds`; kills what exceeds its wall time.
  bool has_ended(double seconds);

  /// Waits for the end.
  const ChildEnd& wait();

  /// Asks for an end, waits for some seconds, then insists.
  void stop();

  /// Asks for an end (SIGTERM) and returns at once; kill() does not ask.
  void ask_to_end();
  void kill();

  /// Of an ended child.
  const ChildEnd& end() const { return end_; }

  /// Standard output and error so far, where no file was named for them.
  std::string output() const;

  /// What a forked child writes to, for poll() and read(); -1 of others.
  int output_pipe() const { return pipe_.get(); }

  /// CPU time of the child so far, without its own children's [s].
  double cpu_time() const;

private:
  using Clock = std::chrono::steady_clock;

  ChildProcess() = default;
  void started();
  void wait_for_change(double seconds) const;
  bool reap();

  pid_t process_ = 0;       ///< 0 once it has ended
  FileDescriptor watched_;  ///< becomes readable at its end
  FileDescriptor captured_; ///< its output, in memory
  FileDescriptor pipe_;
  ChildLimits limits_;
  Clock::time_point start_;
  bool is_overdue_ = false;
  ChildEnd end_;
};

struct ChildAnswer {
  ChildEnd end;
  std::string output; ///< what it said, if no file was named for it
};

/// Runs a command to its end.
/// @throws std::system_error  naming the program: it cannot be started
ChildAnswer run_child(const ChildCommand& command);

} // namespace asperity
