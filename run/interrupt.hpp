#pragma once

// Handles Ctrl-C: the current load step is finished, then the run stops in an
// orderly way.

namespace asperity::run {

/// Installs handlers so that the first SIGINT or SIGTERM only sets a flag. A
/// second signal terminates the program.
void catch_interrupts();

bool is_interrupted();

} // namespace asperity::run
