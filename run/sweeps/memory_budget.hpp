#pragma once

// Limits what runs beside each other to the available memory.

#include <condition_variable>
#include <mutex>

namespace asperity::run {

/// A budget that jobs of known size share. A job whose size is unknown (NaN) or
/// exceeds the budget runs alone.
class MemoryBudget {
public:
  /// @param total  [B] >= 0; may be infinite
  explicit MemoryBudget(double total) : total_(total) {}

  /// Waits until the job fits beside those that run, and reserves its size
  /// until the returned object is destroyed.
  class Share {
  public:
    /// @param bytes  predicted size of the job [B]
    Share(MemoryBudget& budget, double bytes);
    ~Share();
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;

  private:
    MemoryBudget& budget_;
    double bytes_;
  };

private:
  double total_;
  double used_ = 0.0;
  int running_ = 0;
  std::mutex mutex_;
  std::condition_variable freed_;
};

} // namespace asperity::run
