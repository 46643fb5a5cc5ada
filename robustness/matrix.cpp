#include "robustness/matrix.hpp"

#include "robustness/axes.hpp"

#include <algorithm>
#include <numeric>

namespace asperity::robustness {
namespace {

constexpr std::size_t slowest_kept = 10;

std::string key(const std::string& axis, const std::string& label) {
  return axis + "=" + label;
}

} // namespace

int Counts::all() const {
  return std::accumulate(by_outcome.begin(), by_outcome.end(), 0);
}

int Counts::others() const {
  return all() - of(Outcome::verified) - of(Outcome::refused);
}

void Matrix::add(const InstanceResult& result) {
  const auto& [instance, report] = result;
  total_.add(report.outcome);
  seconds_ += report.seconds;
  std::vector<std::string> keys;
  const std::vector<std::string> labels = labels_of(instance);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (!labels[i].empty())
      keys.push_back(key(axes()[i].name, labels[i]));
  for (const std::string& first : keys)
    for (const std::string& second : keys)
      pairs_[{first, second}].add(report.outcome);
  if (report.outcome == Outcome::refused && instance.family != Family::flawed)
    ++sound_but_refused_;
  if (!is_good(report.outcome))
    others_.push_back(result);
  if (report.has_pair) {
    RelationCounts& pair = relations_[instance.relation];
    ++pair.pairs;
    pair.same_bits += report.has_same_bits ? 1 : 0;
    pair.largest_difference =
        std::max(pair.largest_difference, report.pair_difference);
  }
  keep_if_slow(result);
}

void Matrix::keep_if_slow(const InstanceResult& result) {
  if (result.report.outcome != Outcome::verified)
    return;
  const auto at = std::find_if(
      slowest_.begin(), slowest_.end(), [&](const InstanceResult& kept) {
        return kept.report.iterations < result.report.iterations;
      });
  slowest_.insert(at, result);
  if (slowest_.size() > slowest_kept)
    slowest_.pop_back();
}

Counts Matrix::of(const std::string& axis, const std::string& label) const {
  return of(axis, label, axis, label);
}

Counts Matrix::of(const std::string& axis, const std::string& label,
                  const std::string& other_axis,
                  const std::string& other_label) const {
  const auto found =
      pairs_.find({key(axis, label), key(other_axis, other_label)});
  return found == pairs_.end() ? Counts{} : found->second;
}

} // namespace asperity::robustness
