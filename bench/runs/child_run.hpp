#pragma once

// The program run by itself as a child process.

#include "base/child_process.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::app {

/// Runs this program with these words and waits. Standard output and error go
/// to `log`. An interrupt is passed on, and the child ends in order.
/// @throws std::system_error  it could not be started
ChildEnd run_self(const std::vector<std::string>& words,
                  const std::filesystem::path& log);

} // namespace asperity::app
