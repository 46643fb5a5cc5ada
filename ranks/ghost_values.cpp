#include "ranks/ghost_values.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>

namespace asperity {
namespace {

/// The number of the first item of each rank, and that of all.
std::vector<std::size_t> first_items(RankGroup& ranks, std::size_t owned) {
  const auto n = static_cast<std::size_t>(ranks.size());
  std::vector<std::size_t> counts(n);
  ranks.gather_to_all(std::as_bytes(std::span(&owned, 1)),
                      std::vector<std::size_t>(n, sizeof(std::size_t)),
                      std::as_writable_bytes(std::span(counts)));
  std::vector<std::size_t> first(n + 1, 0);
  std::inclusive_scan(counts.begin(), counts.end(), first.begin() + 1);
  return first;
}

} // namespace

GhostValues::GhostValues(RankGroup& ranks, std::size_t owned,
                         std::span<const std::size_t> ghosts, std::size_t width)
    : ranks_(ranks), owned_(owned), ghosts_(ghosts.size()), width_(width) {
  const std::vector<std::size_t> first = first_items(ranks, owned);
  const auto n = static_cast<std::size_t>(ranks.size());
  const auto own = static_cast<std::size_t>(ranks.rank());
  if (std::ranges::adjacent_find(ghosts, std::greater_equal<>()) !=
      ghosts.end())
    refuse_argument("a number of ghosts", 0.0, "increasing");
  received_.assign(n, 0);
  for (const std::size_t ghost : ghosts) {
    const auto owner = static_cast<std::size_t>(
        std::upper_bound(first.begin(), first.end(), ghost) - first.begin() -
        1);
    if (owner >= n || owner == own)
      refuse_argument("the number of a ghost", static_cast<double>(ghost),
                      "that of an item of another rank");
    ++received_[owner];
  }
  sent_.resize(n);
  const std::vector<std::size_t> one_number(n, sizeof(std::size_t));
  ranks.exchange(std::as_bytes(std::span(received_)), one_number,
                 std::as_writable_bytes(std::span(sent_)), one_number);
  items_.resize(std::accumulate(sent_.begin(), sent_.end(), std::size_t{0}));
  const auto bytes = [](std::vector<std::size_t> counts) {
    for (std::size_t& count : counts)
      count *= sizeof(std::size_t);
    return counts;
  };
  ranks.exchange(std::as_bytes(ghosts), bytes(received_),
                 std::as_writable_bytes(std::span(items_)), bytes(sent_));
  for (std::size_t& item : items_)
    item -= first[own];
}

/// Numbers of items as numbers of bytes, with numbers of `size` bytes.
std::vector<std::size_t>
GhostValues::bytes_of(const std::vector<std::size_t>& items,
                      std::size_t size) const {
  std::vector<std::size_t> bytes;
  bytes.reserve(items.size());
  for (const std::size_t count : items)
    bytes.push_back(count * width_ * size);
  return bytes;
}

template <class Number>
void GhostValues::fill_ghosts(Number* values) const {
  buffer_.resize(items_.size() * width_ * sizeof(Number));
  auto* to = reinterpret_cast<Number*>(buffer_.data());
  for (const std::size_t item : items_)
    to = std::copy_n(values + item * width_, width_, to);
  ranks_.exchange(buffer_, bytes_of(sent_, sizeof(Number)),
                  std::as_writable_bytes(
                      std::span(values + owned_ * width_, ghosts_ * width_)),
                  bytes_of(received_, sizeof(Number)));
}

template <class Number>
void GhostValues::add_to_owners(Number* values) const {
  buffer_.resize(items_.size() * width_ * sizeof(Number));
  const std::span ghosts(values + owned_ * width_, ghosts_ * width_);
  ranks_.exchange(std::as_bytes(ghosts), bytes_of(received_, sizeof(Number)),
                  buffer_, bytes_of(sent_, sizeof(Number)));
  const auto* from = reinterpret_cast<const Number*>(buffer_.data());
  for (const std::size_t item : items_)
    for (std::size_t i = 0; i < width_; ++i)
      values[item * width_ + i] += *from++;
  std::ranges::fill(ghosts, Number(0));
}

template void GhostValues::fill_ghosts(float*) const;
template void GhostValues::fill_ghosts(double*) const;
template void GhostValues::add_to_owners(float*) const;
template void GhostValues::add_to_owners(double*) const;

std::size_t GhostValues::bytes() const {
  return (received_.size() + sent_.size() + items_.size()) *
             sizeof(std::size_t) +
         buffer_.capacity();
}

} // namespace asperity
