#pragma once

// One random problem: a case, which the program reads like any other, its place
// on the axes by which problems are classified, and how it is run.

#include "input/types/case.hpp"
#include "surfaces/maps/height_map.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace asperity::robustness {

/// One axis and the labels of its bins in order.
struct Axis {
  std::string name;                ///< "penalty"
  std::vector<std::string> labels; ///< "1e-06..0.001", ...
  std::vector<double> edges = {};  ///< of bins of numbers, the lower ones
};

const std::vector<Axis>& axes();

/// Returns the bin of a number on an axis of numbers.
std::string bin_of(const std::string& axis, double value);

/// One random problem.
struct Instance {
  std::uint64_t seed = 0;
  int index = 0; ///< >= 0
  /// The label on each axis that applies to the problem.
  std::map<std::string, std::string> labels = {};
  std::string text = {};                   ///< of the case file
  std::vector<std::string> overrides = {}; ///< as for --set
  std::string file = {};   ///< of the case; empty: one beside the map
  std::string method = {}; ///< the one of the case that is run
  /// Heights of map.txt [m]; none if the case names no such map.
  surfaces::HeightMap map = {};
  int threads = 3; ///< of the second run and of the program

  /// Returns the label on an axis; "" if it does not apply.
  std::string label(const std::string& axis) const;
};

/// Ratios by which a problem is drawn in other units.
struct UnitRatios {
  double length = 1.0;
  double pressure = 1.0;
};

/// A case whose settings are perturbed, and its method that is run.
struct Base {
  cases::Case contact_case;
  std::string method;
};

/// Returns one base for each method of a case but Winkler foundations, which
/// are solved exactly.
/// @throws input::InputError  a method has a hardness, or there is none
std::vector<Base> bases_of(const cases::Case& contact_case);

/// Draws instance `index` of a seed. Every number has its own counter, by its
/// name, so that the bits are the same on every machine and in any order, and
/// do not change when axes are added.
/// @param base  each axis keeps the value of this case with a probability of
///              one half; null: everything is drawn
/// @throws std::domain_error  index < 0
Instance draw_instance(std::uint64_t seed, int index,
                       const Base* base = nullptr,
                       const UnitRatios& units = {});

/// Returns the heights as a plain-text map that reads back bitwise equal.
std::string text_of_map(const surfaces::HeightMap& map);

/// Describes the instance: its labels and its case.
std::string text_of(const Instance& instance);

/// Selects instances: "slab" is a label of any axis, "penalty=1000..1e+06" is a
/// label of the given axis.
class InstanceFilter {
public:
  /// @param words  empty: all instances
  /// @throws std::domain_error  there is no axis or label of that name; the
  ///     message lists the existing ones
  explicit InstanceFilter(const std::string& words = {});

  bool takes(const Instance& instance) const;

private:
  std::string axis_; ///< empty: any axis
  std::string label_;
};

/// The first instances that match a filter, in the order of their indices. Each
/// is drawn when it, or a later one, is asked for.
class InstanceSequence {
public:
  /// @param draw   returns the instance of an index
  /// @param first  index of the first instance that is drawn
  /// @param most   length of the sequence; it ends earlier if fewer than one
  ///               instance in 10000 matches
  InstanceSequence(std::function<Instance(int)> draw, InstanceFilter filter,
                   int first, std::size_t most);

  /// The instance at a place of the sequence; null beyond the end.
  const Instance* at(std::size_t place);

  /// Frees the instances before a place, which are not asked for again.
  void release_before(std::size_t place);

private:
  std::function<Instance(int)> draw_;
  InstanceFilter filter_;
  int first_;
  int next_; ///< index that is drawn next
  std::size_t most_;
  std::size_t released_ = 0;
  std::deque<Instance> drawn_ = {}; ///< at stable addresses
};

} // namespace asperity::robustness
