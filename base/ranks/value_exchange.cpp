#include "base/ranks/value_exchange.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <numeric>

namespace asperity {
namespace {

std::vector<std::size_t> in_bytes(const std::vector<std::size_t>& counts,
                                  std::size_t value) {
  std::vector<std::size_t> bytes;
  bytes.reserve(counts.size());
  for (const std::size_t count : counts)
    bytes.push_back(count * value);
  return bytes;
}

} // namespace

ValueExchange::ValueExchange(RankGroup& ranks, std::span<const int> targets)
    : ranks_(&ranks),
      n_own_(targets.size()),
      sent_(static_cast<std::size_t>(ranks.size()), 0),
      received_(sent_) {
  if (!std::ranges::is_sorted(targets))
    refuse_argument("target of the first value", targets.front(),
                    "not above those that follow");
  for (const int target : targets)
    ++sent_[static_cast<std::size_t>(target)];
  const std::vector<std::size_t> one(sent_.size(), sizeof(std::size_t));
  ranks.exchange(std::as_bytes(std::span(sent_)), one,
                 std::as_writable_bytes(std::span(received_)), one);
  n_received_ =
      std::accumulate(received_.begin(), received_.end(), std::size_t{0});
}

ValueExchange::ValueExchange(RankGroup& ranks, std::size_t n_values)
    : ranks_(&ranks),
      n_own_(n_values),
      received_(static_cast<std::size_t>(ranks.size())) {
  const std::vector<std::size_t> one(received_.size(), sizeof(std::size_t));
  ranks.gather_to_all(std::as_bytes(std::span(&n_own_, 1)), one,
                      std::as_writable_bytes(std::span(received_)));
  n_received_ =
      std::accumulate(received_.begin(), received_.end(), std::size_t{0});
  first_ = std::accumulate(received_.begin(), received_.begin() + ranks.rank(),
                           std::size_t{0});
}

void ValueExchange::send(std::span<const std::byte> own, std::size_t size,
                         std::span<std::byte> received) const {
  if (sent_.empty())
    ranks_->gather_to_all(own, in_bytes(received_, size), received);
  else
    ranks_->exchange(own, in_bytes(sent_, size), received,
                     in_bytes(received_, size));
}

void ValueExchange::give_back(std::span<const std::byte> values,
                              std::size_t size,
                              std::span<std::byte> own) const {
  if (sent_.empty())
    std::ranges::copy(values.subspan(first_ * size, n_own_ * size),
                      own.begin());
  else
    ranks_->exchange(values, in_bytes(received_, size), own,
                     in_bytes(sent_, size));
}

} // namespace asperity
