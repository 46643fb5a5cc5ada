#pragma once

// Protects what signals do in this process from libraries that change it.

#include <array>
#include <csignal>

namespace asperity {

/// Remembers what every signal does, and restores it on destruction for each
/// signal that this program catches or ignores, or that was ignored when it
/// was started (as SIGHUP is by nohup). A library may keep handlers of its own
/// for signals that had their default.
class KeptSignals {
public:
  KeptSignals();
  KeptSignals(const KeptSignals&) = delete;
  KeptSignals& operator=(const KeptSignals&) = delete;
  ~KeptSignals();

private:
  std::array<struct sigaction, NSIG> actions_{};
};

} // namespace asperity
