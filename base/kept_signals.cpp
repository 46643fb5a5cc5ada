#include "base/kept_signals.hpp"

namespace asperity {

KeptSignals::KeptSignals() {
  for (std::size_t number = 1; number < actions_.size(); ++number)
    if (sigaction(static_cast<int>(number), nullptr, &actions_[number]) != 0)
      actions_[number] = {}; // of the C library: SIG_DFL is not restored
}

KeptSignals::~KeptSignals() {
  for (std::size_t number = 1; number < actions_.size(); ++number)
    if (actions_[number].sa_handler != SIG_DFL)
      sigaction(static_cast<int>(number), &actions_[number], nullptr);
}

} // namespace asperity
