#include "base/ranks/root_work.hpp"

#include <exception>
#include <stdexcept>

namespace asperity {

void RootWork::act(const std::function<void()>& act) {
  std::exception_ptr failure;
  if (is_root())
    try {
      act();
    } catch (...) {
      failure = std::current_exception();
    }
  bool has_failed = failure != nullptr;
  if (ranks_ != nullptr)
    ranks_->from_rank_0(std::as_writable_bytes(std::span(&has_failed, 1)));
  if (failure)
    std::rethrow_exception(failure);
  if (has_failed)
    throw std::runtime_error("rank 0 failed");
}

} // namespace asperity
