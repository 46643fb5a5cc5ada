#include "suite/robustness/draft.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity::robustness {
namespace {

/// The counter of a random number: the FNV-1a hash of its name, which is part
/// of the meaning of a seed.
int counter_of(const std::string& name) {
  std::uint32_t hash = 2166136261U;
  for (const char c : name)
    hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return static_cast<int>(hash >> 1U);
}

} // namespace

Weighted equally(const std::vector<std::string>& words) {
  Weighted weighted;
  for (const std::string& word : words)
    weighted.emplace_back(word, 1.0);
  return weighted;
}

/// TOML requires a decimal point or an exponent in a float, which {} omits for
/// whole numbers.
std::string number(double value) {
  return fmt::format("{:.17e}", value);
}

std::string in_quotes(const std::string& word) {
  return '"' + word + '"';
}

std::string quantity(double value, const std::string& unit) {
  return fmt::format("\"{:.17g} {}\"", value, unit);
}

Draft::Draft(std::uint64_t seed, int index, const Base* base,
             const UnitRatios& units)
    : base_(base), units_(units) {
  instance_.seed = seed;
  instance_.index = index;
}

surfaces::UniformPair Draft::pair(const std::string& name) const {
  return surfaces::draw_mode(
      {instance_.seed, 0, surfaces::RandomStream::robustness_instances},
      instance_.index, counter_of(name));
}

double Draft::uniform(const std::string& name, double low, double high) const {
  return low + (high - low) * pair(name).first;
}

double Draft::log_uniform(const std::string& name, double low,
                          double high) const {
  return std::exp(uniform(name, std::log(low), std::log(high)));
}

bool Draft::coin(const std::string& name) const {
  return pair(name).second < 0.5;
}

std::string Draft::word(const std::string& axis, const Weighted& words) {
  double sum = 0.0;
  for (const auto& [word, weight] : words)
    sum += weight;
  double left = uniform(axis, 0.0, sum);
  const auto chosen = std::ranges::find_if(words, [&](const auto& weighted) {
    return (left -= weighted.second) < 0.0;
  });
  label(axis, chosen == words.end() ? words.front().first : chosen->first);
  return instance_.label(axis);
}

double Draft::number(const std::string& axis, double low, double high) {
  const double value = log_uniform(axis, low, high);
  label(axis, bin_of(axis, value));
  return value;
}

bool Draft::keeps(const std::string& axis) const {
  return base_ != nullptr && coin("base's " + axis);
}

void Draft::set(const std::string& key, const std::string& value) {
  const auto known =
      std::ranges::find(keys_, key, &decltype(keys_)::value_type::first);
  if (known == keys_.end())
    keys_.emplace_back(key, value);
  else
    known->second = value;
}

void Draft::set_map(surfaces::HeightMap map) {
  for (double& height : map.heights)
    height *= units_.length;
  instance_.map = std::move(map);
}

std::string Draft::length(double metres) const {
  return robustness::number(metres * units_.length);
}

std::string Draft::pressure(double pascals) const {
  return robustness::number(pascals * units_.pressure);
}

std::string Draft::energy(double per_area) const {
  return robustness::number(per_area * (units_.pressure * units_.length));
}

std::string Draft::stiffness(double per_area) const {
  return robustness::number(per_area * (units_.pressure / units_.length));
}

/// Of a base, the tables that depend on size and load are replaced as a whole.
Instance Draft::finished(const std::string& method) const {
  Instance instance = instance_;
  instance.method = method;
  if (base_ == nullptr) {
    instance.text = fmt::format("schema = 1\ntitle = \"problem instance {}\"\n",
                                instance.index);
    for (const auto& [key, value] : keys_)
      instance.text += key + " = " + value + "\n";
    return instance;
  }
  instance.text = base_->contact_case.text;
  instance.file = base_->contact_case.path;
  std::map<std::string, std::vector<std::string>> tables{
      {"surface", {}}, {"load", {}}, {"md", {}}};
  for (const auto& [key, value] : keys_) {
    const std::size_t dot = key.find('.');
    const auto table = tables.find(key.substr(0, dot));
    if (dot != std::string::npos && table != tables.end())
      table->second.push_back(key.substr(dot + 1) + " = " + value);
    else
      instance.overrides.push_back(key + "=" + value);
  }
  for (const auto& [table, entries] : tables)
    if (!entries.empty())
      instance.overrides.push_back(
          fmt::format("{}={{ {} }}", table, fmt::join(entries, ", ")));
  return instance;
}

} // namespace asperity::robustness
