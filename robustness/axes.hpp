#pragma once

// The axes a scene is sorted by: names, and the bin of each value. Owns what
// --only understands and what the heat map's rows are.

#include <string>
#include <vector>

#include "robustness/scene.hpp"

namespace asperity::robustness {

/// One axis and the labels of its bins in their order.
struct Axis {
  std::string name;                ///< "penalty"
  std::vector<std::string> labels; ///< "1e-6..1e-3", ...
};

const std::vector<Axis>& axes();

/// The label on each axis, in the order of axes(); empty where the axis means
/// nothing to the scene's family: a theory has no penalty.
std::vector<std::string> labels_of(const Scene& scene);

/// Which scenes are wanted: "slab" is any axis' label, "penalty=1e3..1e9" the
/// label of that axis.
class SceneFilter {
public:
  /// @param words  empty: all scenes
  /// @throws std::domain_error  no axis or label of that name; says which there
  ///                            are
  explicit SceneFilter(const std::string& words = {});

  bool takes(const Scene& scene) const;

private:
  std::string axis_; ///< empty: any
  std::string label_;
};

} // namespace asperity::robustness
