#pragma once

// Runs the program itself as a child process.

#include "base/child_process.hpp"
#include "run/methods/chosen.hpp"

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

/// Returns the arguments that run some methods of a case with overrides.
std::vector<std::string> words_of_run(const std::filesystem::path& case_file,
                                      const std::vector<std::string>& overrides,
                                      const methods::AskedMethods& methods);

/// Returns the last lines of the output of a child in one line, for messages.
std::string end_of_log(const std::filesystem::path& log);

} // namespace asperity::run
