#pragma once

// What rank 0 does alone in a program that all ranks run: reading and writing
// files, and decisions that follow from what only it knows.

#include "base/ranks/rank_group.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace asperity {

/// Ranks that run one program.
class ProgramRanks : public RankGroup {
public:
  /// Gives the bytes of rank 0 to every rank; the others wait for them without
  /// using a core. Collective.
  virtual void from_rank_0(std::span<std::byte> bytes) = 0;
};

/// Lets rank 0 act while the other ranks wait without using a core. If rank 0
/// fails, all ranks throw, so that none waits for another. All calls are
/// collective, except those of is_root() and ranks(); they may not be nested.
class RootWork {
public:
  /// @param ranks  must outlive this object; null: this process alone
  explicit RootWork(ProgramRanks* ranks = nullptr) : ranks_(ranks) {}

  ProgramRanks* ranks() const { return ranks_; }

  bool is_root() const { return ranks_ == nullptr || ranks_->rank() == 0; }

  /// Calls act() on rank 0 alone.
  /// @throws what act() throws on rank 0, std::runtime_error on the others
  void act(const std::function<void()>& act);

  /// The result of find() on rank 0, for all ranks.
  /// @return  a trivially copyable value, or a vector or string of such values
  template <class Find>
  auto value(const Find& find) {
    std::invoke_result_t<Find> found{};
    act([&] { found = find(); });
    if (ranks_ == nullptr)
      return found;
    if constexpr (std::is_trivially_copyable_v<decltype(found)>) {
      ranks_->from_rank_0(std::as_writable_bytes(std::span(&found, 1)));
    } else {
      std::size_t size = found.size();
      ranks_->from_rank_0(std::as_writable_bytes(std::span(&size, 1)));
      found.resize(size);
      ranks_->from_rank_0(std::as_writable_bytes(std::span(found)));
    }
    return found;
  }

private:
  ProgramRanks* ranks_;
};

} // namespace asperity
