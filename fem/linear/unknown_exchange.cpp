#include "fem/linear/unknown_exchange.hpp"

#include <algorithm>
#include <numeric>

namespace asperity::fem {

std::vector<std::size_t> order_by(const std::vector<int>& targets) {
  std::vector<std::size_t> order(targets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return targets[i]; });
  return order;
}

UnknownExchange::UnknownExchange(
    RankGroup* ranks, std::span<const std::size_t> numbers,
    const std::function<int(std::size_t number)>& rank_of,
    const std::function<std::size_t(std::size_t number)>& place_of) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] != nowhere)
      unknowns_.push_back(static_cast<std::uint32_t>(i));
  if (ranks != nullptr && rank_of) {
    std::vector<int> targets;
    targets.reserve(unknowns_.size());
    for (const std::uint32_t unknown : unknowns_)
      targets.push_back(rank_of(numbers[unknown]));
    std::vector<std::uint32_t> ordered;
    for (const std::size_t i : order_by(targets))
      ordered.push_back(unknowns_[i]);
    unknowns_ = std::move(ordered);
    std::ranges::sort(targets);
    values_.emplace(*ranks, targets);
  } else if (ranks != nullptr) {
    values_.emplace(*ranks, unknowns_.size());
  }
  std::vector<std::size_t> received;
  received.reserve(unknowns_.size());
  for (const std::uint32_t unknown : unknowns_)
    received.push_back(numbers[unknown]);
  if (values_)
    received = values_->sent(std::span<const std::size_t>(received));
  places_.reserve(received.size());
  for (const std::size_t number : received)
    places_.push_back(static_cast<std::uint32_t>(place_of(number)));
}

void UnknownExchange::send(const Vector& from, std::span<double> to) const {
  std::ranges::fill(to, 0.0);
  const double* const values = from.begin();
  if (!values_) {
    for (std::size_t i = 0; i < places_.size(); ++i)
      to[places_[i]] = values[unknowns_[i]];
    return;
  }
  std::vector<double> own;
  own.reserve(unknowns_.size());
  for (const std::uint32_t unknown : unknowns_)
    own.push_back(values[unknown]);
  const std::vector<double> all = values_->sent(std::span<const double>(own));
  for (std::size_t i = 0; i < places_.size(); ++i)
    to[places_[i]] = all[i];
}

void UnknownExchange::give_back(std::span<const double> from,
                                Vector& to) const {
  double* const values = to.begin();
  std::fill(to.begin(), to.end(), 0.0);
  if (!values_) {
    for (std::size_t i = 0; i < places_.size(); ++i)
      values[unknowns_[i]] = from[places_[i]];
    return;
  }
  std::vector<double> all;
  all.reserve(places_.size());
  for (const std::uint32_t place : places_)
    all.push_back(from[place]);
  const std::vector<double> own =
      values_->returned(std::span<const double>(all));
  for (std::size_t i = 0; i < own.size(); ++i)
    values[unknowns_[i]] = own[i];
}

} // namespace asperity::fem
