#pragma once

// The case of a problem while it is drawn: random numbers, each by its name,
// and the keys of the case. Internal to the module.

#include "suite/robustness/instance.hpp"
#include "surfaces/maps/random_modes.hpp"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace asperity::robustness {

using Weighted = std::vector<std::pair<std::string, double>>;

Weighted equally(const std::vector<std::string>& words);

// Values as they are written in a case file.
std::string number(double value);
std::string in_quotes(const std::string& word);
std::string quantity(double value, const std::string& unit);

class Draft {
public:
  /// @param base  null: none; must outlive the draft
  Draft(std::uint64_t seed, int index, const Base* base,
        const UnitRatios& units);

  int index() const { return instance_.index; }

  const Base* base() const { return base_; }

  double uniform(const std::string& name, double low, double high) const;
  double log_uniform(const std::string& name, double low, double high) const;

  /// A fair coin, independent of the other numbers of this name.
  bool coin(const std::string& name) const;

  /// Draws a label of an axis with a probability proportional to its weight.
  std::string word(const std::string& axis, const Weighted& words);

  /// Draws a number of an axis, uniformly in its logarithm.
  double number(const std::string& axis, double low, double high);

  void label(const std::string& axis, const std::string& label) {
    instance_.labels[axis] = label;
  }

  bool has_label(const std::string& axis, const std::string& label) const {
    return instance_.label(axis) == label;
  }

  /// Whether the value of the base is kept on an axis.
  bool keeps(const std::string& axis) const;

  void set(const std::string& key, const std::string& value);

  /// Unless the value of the base is kept on this axis.
  void set(const std::string& axis, const std::string& key,
           const std::string& value) {
    if (!keeps(axis))
      set(key, value);
  }

  /// Removes a key from the base.
  void remove(const std::string& key) { set(key, ""); }

  /// @param map  in SI units
  void set_map(surfaces::HeightMap map);

  bool has_map() const { return !instance_.map.heights.empty(); }

  void set_threads(int threads) { instance_.threads = threads; }

  // Values in the units of the draft.
  std::string length(double metres) const;
  std::string pressure(double pascals) const;
  std::string energy(double per_area) const;
  std::string stiffness(double per_area) const;

  Instance finished(const std::string& method) const;

private:
  surfaces::UniformPair pair(const std::string& name) const;

  Instance instance_;
  const Base* base_;
  UnitRatios units_;
  std::vector<std::pair<std::string, std::string>> keys_;
};

} // namespace asperity::robustness
