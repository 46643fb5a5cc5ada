#pragma once

// This file runs the program itself as a child process.

#include "base/child_process.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::app {

/// Runs this program with the given arguments and waits for it. Standard output
/// and error are written to `log`. An interrupt is passed on, and the child
/// terminates in an orderly way.
/// @throws std::system_error  the child could not be started
ChildEnd run_self(const std::vector<std::string>& words,
                  const std::filesystem::path& log);

} // namespace asperity::app
