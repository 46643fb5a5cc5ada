#pragma once

// Runs the program itself as a child process.

#include "base/child_process.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::run {

/// Runs this program with the given arguments and waits for it. Standard output
/// and error are written to `log`. Under mpirun the child is a process of its
/// own, which takes no part in the MPI of this one. An interrupt is passed on,
/// and the child terminates in an orderly way.
/// @throws std::system_error  the child could not be started
ChildEnd run_self(const std::vector<std::string>& words,
                  const std::filesystem::path& log);

} // namespace asperity::run
