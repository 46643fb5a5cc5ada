#include "base/ranks/ghost_values.hpp"

#include "base/ranks/rank_sums.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace asperity {
namespace {

/// The number of the first item of this rank.
std::size_t first_item(RankGroup& ranks, std::size_t owned) {
  const std::vector<double> counts =
      of_ranks(&ranks, static_cast<double>(owned));
  return static_cast<std::size_t>(
      std::accumulate(counts.begin(), counts.begin() + ranks.rank(), 0.0));
}

/// The rank that owns each ghost. Collective.
std::vector<int> owners_of(RankGroup& ranks, std::size_t owned,
                           std::span<const std::size_t> ghosts) {
  if (std::ranges::adjacent_find(ghosts, std::greater_equal<>()) !=
      ghosts.end())
    refuse_argument("a number of ghosts", 0.0, "increasing");
  const std::vector<double> counts =
      of_ranks(&ranks, static_cast<double>(owned));
  std::vector<double> ends(counts.size());
  std::inclusive_scan(counts.begin(), counts.end(), ends.begin());
  std::vector<int> owners;
  for (const std::size_t ghost : ghosts) {
    const auto number = static_cast<double>(ghost);
    const auto owner =
        static_cast<int>(std::ranges::upper_bound(ends, number) - ends.begin());
    if (owner >= ranks.size() || owner == ranks.rank())
      refuse_argument("the number of a ghost", number,
                      "that of an item of another rank");
    owners.push_back(owner);
  }
  return owners;
}

} // namespace

GhostValues::GhostValues(RankGroup& ranks, std::size_t owned,
                         std::span<const std::size_t> ghosts, std::size_t width)
    : ranks_(ranks),
      owned_(owned),
      ghosts_(ghosts.size()),
      width_(width),
      to_owners_(ranks, owners_of(ranks, owned, ghosts)),
      items_(to_owners_.sent(ghosts)) {
  const std::size_t first = first_item(ranks, owned);
  for (std::size_t& item : items_)
    item -= first;
}

template <class Number>
void GhostValues::fill_ghosts(Number* values) const {
  buffer_.resize(items_.size() * width_ * sizeof(Number));
  auto* to = reinterpret_cast<Number*>(buffer_.data());
  for (const std::size_t item : items_)
    to = std::copy_n(values + item * width_, width_, to);
  to_owners_.give_back(buffer_, width_ * sizeof(Number),
                       std::as_writable_bytes(std::span(
                           values + owned_ * width_, ghosts_ * width_)));
}

template <class Number>
void GhostValues::add_to_owners(Number* values) const {
  buffer_.resize(items_.size() * width_ * sizeof(Number));
  const std::span ghosts(values + owned_ * width_, ghosts_ * width_);
  to_owners_.send(std::as_bytes(ghosts), width_ * sizeof(Number), buffer_);
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
  return to_owners_.bytes() + items_.size() * sizeof(std::size_t) +
         buffer_.capacity();
}

} // namespace asperity
