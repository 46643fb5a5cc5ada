#pragma once

// Inside base/ only: the system calls between vfork and exec.

#include "base/child_process.hpp"

namespace asperity {

/// Starts the command with its standard output and error going to `output`.
/// @throws std::system_error  naming the program: it cannot be started
pid_t start_process(const ChildCommand& command, int output);

/// To be called in a new child: it ends with its parent and keeps the limits.
/// Calls only what is safe after vfork.
/// @param parent  process number of the parent, seen before the start
/// @return  false: errno says what was refused, or the parent is gone
bool bind_to_parent(pid_t parent, int death_signal, const ChildLimits& limits);

} // namespace asperity
