#include "run/sweeps/memory_budget.hpp"

namespace asperity::run {

MemoryBudget::Share::Share(MemoryBudget& budget, double bytes)
    : budget_(budget), bytes_(bytes <= budget.total_ ? bytes : budget.total_) {
  std::unique_lock lock(budget_.mutex_);
  budget_.freed_.wait(lock, [&] {
    return budget_.running_ == 0 || budget_.used_ + bytes_ <= budget_.total_;
  });
  ++budget_.running_;
  budget_.used_ += bytes_;
}

MemoryBudget::Share::~Share() {
  {
    const std::lock_guard lock(budget_.mutex_);
    --budget_.running_;
    budget_.used_ = budget_.running_ == 0 ? 0.0 : budget_.used_ - bytes_;
  }
  budget_.freed_.notify_all();
}

} // namespace asperity::run
