#include "base/thread_team.hpp"

#include <atomic>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <pthread.h>
#include <thread>
#include <vector>

namespace asperity {
namespace {

/// Number of times a thread polls a state that is about to change before it
/// sleeps, about 50 us: waking takes as long, and the serial code between two
/// loops takes less.
constexpr int looks = 100;

/// A parked thread that executes one call at a time.
class Helper {
public:
  Helper() : thread_([this] { live(); }) {}

  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;

  ~Helper() {
    state_ = State::leaves;
    state_.notify_one();
    thread_.join();
  }

  void call(const std::function<void(int)>& work, int worker) {
    work_ = &work;
    worker_ = worker;
    state_ = State::called;
    state_.notify_one();
  }

  /// Withdraws the call if it has not begun, otherwise waits for its end.
  void release() {
    State seen = State::called;
    if (!state_.compare_exchange_strong(seen, State::parked))
      wait_while(State::works);
  }

private:
  enum class State : int { parked, called, works, leaves };

  State wait_while(State old) const {
    State seen = state_;
    for (int look = 0; seen == old && look < looks; ++look) {
      std::this_thread::yield();
      seen = state_;
    }
    while (seen == old) {
      state_.wait(old);
      seen = state_;
    }
    return seen;
  }

  void live() {
    while (wait_while(State::parked) != State::leaves) {
      State seen = State::called;
      if (!state_.compare_exchange_strong(seen, State::works))
        continue; // the call was withdrawn
      (*work_)(worker_);
      state_ = State::parked;
      state_.notify_one();
    }
  }

  std::atomic<State> state_ = State::parked;
  const std::function<void(int)>* work_ = nullptr;
  int worker_ = 0;
  std::thread thread_; // last, because it uses the other members
};

using Helpers = std::vector<std::unique_ptr<Helper>>;

/// The idle helper threads of the process.
class Park {
public:
  static Park& instance() {
    static Park park;
    return park;
  }

  Helpers take(std::size_t n_helpers) {
    Helpers taken;
    {
      const std::lock_guard lock(mutex_);
      while (taken.size() < n_helpers && !parked_.empty()) {
        taken.push_back(std::move(parked_.back()));
        parked_.pop_back();
      }
    }
    while (taken.size() < n_helpers)
      taken.push_back(std::make_unique<Helper>());
    return taken;
  }

  void put_back(Helpers helpers) {
    const std::lock_guard lock(mutex_);
    for (auto& helper : helpers)
      parked_.push_back(std::move(helper));
  }

private:
  Park() {
    pthread_atfork([] { instance().mutex_.lock(); },
                   [] { instance().mutex_.unlock(); },
                   [] { instance().begin_child(); });
  }

  /// Discards the helpers in a child process, which has this memory but none of
  /// the threads.
  void begin_child() {
    for (auto& helper : parked_)
      static_cast<void>(helper.release()); // the thread cannot be joined here
    parked_.clear();
    mutex_.unlock();
  }

  std::mutex mutex_;
  Helpers parked_;
};

} // namespace

void work_together(int threads, const std::function<void(int)>& work) {
  if (threads <= 1) {
    work(0);
    return;
  }
  Helpers helpers =
      Park::instance().take(static_cast<std::size_t>(threads - 1));
  std::exception_ptr failure;
  std::once_flag is_kept;
  const auto caught = [&](int worker) {
    try {
      work(worker);
    } catch (...) {
      std::call_once(is_kept, [&] { failure = std::current_exception(); });
    }
  };
  const std::function<void(int)> call = std::ref(caught);
  int worker = 0;
  for (const auto& helper : helpers)
    helper->call(call, ++worker);
  call(0);
  for (const auto& helper : helpers)
    helper->release();
  Park::instance().put_back(std::move(helpers));
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace asperity
