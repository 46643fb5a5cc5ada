#include "app/interrupt.hpp"

#include <csignal>

namespace asperity::app {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void raise_flag(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

} // namespace

void catch_interrupts() {
  std::signal(SIGINT, raise_flag);
  std::signal(SIGTERM, raise_flag);
}

bool is_interrupted() {
  return interrupted != 0;
}

} // namespace asperity::app
