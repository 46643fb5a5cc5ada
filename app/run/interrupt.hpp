#pragma once

// Ctrl-C: the step in progress is finished, then the run stops in order.

namespace asperity::app {

/// From here on SIGINT and SIGTERM only raise a flag; a second one kills.
void catch_interrupts();

bool is_interrupted();

} // namespace asperity::app
