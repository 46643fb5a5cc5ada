#pragma once

// The axes by which problem instances are classified: their names and the bin
// of each value. It owns the syntax of --only and the rows of the heat map.

#include "robustness/instance.hpp"

#include <string>
#include <vector>

namespace asperity::robustness {

/// One axis and the labels of its bins in order.
struct Axis {
  std::string name;                ///< "penalty"
  std::vector<std::string> labels; ///< "1e-6..1e-3", ...
};

const std::vector<Axis>& axes();

/// Returns the label on each axis, in the order of axes(); empty where the axis
/// does not apply to the family of the instance, as the penalty does not apply
/// to the theory.
std::vector<std::string> labels_of(const Instance& instance);

/// Selects instances: "slab" is a label of any axis, "penalty=1e3..1e9" is a
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

} // namespace asperity::robustness
