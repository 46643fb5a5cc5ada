#pragma once

// The system calls between vfork and exec, for use inside base/ only.

#include "base/child_process.hpp"

namespace asperity {

/// Starts the command with its standard output and error redirected to
/// `output`.
/// @throws std::system_error  naming the program, if it cannot be started
pid_t start_process(const ChildCommand& command, int output);

/// Binds a new child to the life of its parent and sets its limits. Must be
/// called in the child; uses only functions that are safe after vfork.
/// @param parent  process number of the parent, obtained before the start
/// @return  false on failure: errno holds the reason, or the parent has ended
bool bind_to_parent(pid_t parent, int death_signal, const ChildLimits& limits);

} // namespace asperity
