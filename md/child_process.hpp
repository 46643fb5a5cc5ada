#pragma once

// One child process: started, asked, ended. Owns the process number.

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace asperity::md {

/// The executable of that name along PATH; empty if there is none.
std::filesystem::path program_on_path(const std::string& name);

/// Started by the constructor; the destructor ends what still runs.
///
/// The child leads a process group of its own, so it and what it starts end
/// together and an interrupt at the terminal is ours to pass on. It has our
/// environment without what an MPI started in this process left there, and as
/// root with the two variables OpenMPI then asks for.
class ChildProcess {
public:
  /// @param command  program with its path, then arguments
  /// @param folder   its working folder
  /// @param output   where its standard output and error go
  /// @throws std::system_error  it cannot be started
  ChildProcess(const std::vector<std::string>& command,
               const std::filesystem::path& folder,
               const std::filesystem::path& output);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for at most `seconds`.
  bool has_ended(double seconds);

  /// "" after a good end, else "exit code 3" or "signal 9".
  std::string failure() const;

  /// Asks for an end, waits a little, then insists.
  void stop();

private:
  pid_t process_ = 0; ///< 0 once it has ended
  int status_ = 0;
};

} // namespace asperity::md
