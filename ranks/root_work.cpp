#include "ranks/root_work.hpp"

#include <exception>
#include <stdexcept>

namespace asperity {
namespace {

/// What rank 0 tells the others, besides the number of a shared function.
constexpr int has_ended = -1, has_failed = -2;

/// Passes values to a function that may fail on rank 0: the ranks then still
/// pass the rest, so that none waits for another.
void pass_all(const RootWork::Rows& rows, const RootWork::Take& take) {
  std::exception_ptr failure;
  rows([&](std::span<const double> values) {
    try {
      if (!failure)
        take(values);
    } catch (...) {
      failure = std::current_exception();
    }
  });
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace

void RootWork::tell(int word) {
  ranks_->from_rank_0(std::as_writable_bytes(std::span(&word, 1)));
}

RootWork::Rows RootWork::shared(Rows rows) {
  if (ranks_ == nullptr)
    return rows;
  const auto number = static_cast<int>(shared_.size());
  shared_.push_back(rows);
  return [this, number, rows = std::move(rows)](const Take& take) {
    tell(number);
    pass_all(rows, take);
  };
}

void RootWork::act(const std::function<void()>& act) {
  if (ranks_ == nullptr) {
    act();
    return;
  }
  const std::vector<Rows> shared = std::exchange(shared_, {});
  if (is_root()) {
    std::exception_ptr failure;
    try {
      act();
    } catch (...) {
      failure = std::current_exception();
    }
    tell(failure ? has_failed : has_ended);
    if (failure)
      std::rethrow_exception(failure);
    return;
  }
  int word = has_ended;
  const auto is_told = [&] {
    ranks_->from_rank_0(std::as_writable_bytes(std::span(&word, 1)));
    return word != has_ended;
  };
  while (is_told()) {
    if (word == has_failed)
      throw std::runtime_error("rank 0 failed");
    shared.at(static_cast<std::size_t>(word))({});
  }
}

} // namespace asperity
