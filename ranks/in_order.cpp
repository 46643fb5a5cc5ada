#include "ranks/in_order.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// Message of a failure; empty if there is none.
using Failure = std::array<char, 512>;

Failure failure_of(const std::function<void()>& go_on) {
  Failure failure{};
  try {
    go_on();
  } catch (const std::exception& error) {
    const std::string message = error.what();
    message.copy(failure.data(), failure.size() - 1);
    if (message.empty())
      failure[0] = '?';
  }
  return failure;
}

} // namespace

void bytes_in_order(const SharedRows* rows, std::span<std::byte> state,
                    const std::function<void()>& go_on) {
  if (rows == nullptr || rows->ranks() == nullptr) {
    go_on();
    return;
  }
  RankGroup& ranks = *rows->ranks();
  const auto n = static_cast<std::size_t>(ranks.size());
  std::vector<std::byte> passed(state.size() + sizeof(Failure));
  for (std::size_t r = 0; r < n; ++r) {
    std::vector<std::byte> own;
    if (r == static_cast<std::size_t>(ranks.rank())) {
      const Failure failure = failure_of(go_on);
      own.assign(state.begin(), state.end());
      const auto message = std::as_bytes(std::span(failure));
      own.insert(own.end(), message.begin(), message.end());
    }
    std::vector<std::size_t> counts(n, 0);
    counts[r] = passed.size();
    ranks.gather_to_all(own, counts, passed);
    std::copy_n(passed.begin(), state.size(), state.begin());
    Failure failure;
    std::memcpy(failure.data(), passed.data() + state.size(), failure.size());
    if (failure[0] != '\0')
      throw std::domain_error(failure.data());
  }
}

} // namespace asperity
