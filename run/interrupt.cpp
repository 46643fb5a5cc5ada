#include "run/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace asperity::run {
namespace {

std::atomic<bool> interrupted = false;
// Safe in a signal handler.
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void raise_flag(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

} // namespace

void catch_interrupts() {
  std::signal(SIGINT, raise_flag);
  std::signal(SIGTERM, raise_flag);
}

bool is_interrupted() {
  return interrupted;
}

} // namespace asperity::run
