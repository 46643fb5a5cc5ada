#pragma once

// The program run by itself as a child process, and what that took.

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::app {

struct ChildEnd {
  int exit_code = -1;       ///< 128 + signal if it was killed
  double wall_time = 0.0;   ///< [s]
  double cpu_time = 0.0;    ///< user and system, of the child alone [s]
  double peak_memory = 0.0; ///< largest resident set [B]
};

/// Runs this program with these words and waits. Standard output and error go
/// to `log`. A Ctrl-C reaches the child as it does the parent; both end in
/// order.
/// @throws std::system_error  it could not be started
ChildEnd run_self(const std::vector<std::string>& words,
                  const std::filesystem::path& log);

} // namespace asperity::app
