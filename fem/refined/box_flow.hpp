#pragma once

// First-order boxes whose material is not elastic.

#include "fem/hexahedra/cell_tangents.hpp"
#include "fem/refined/box_kernel.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace asperity::fem {

/// A box with tangents of its own, at 2^3 Gauss points.
struct FlowingBox {
  std::array<std::uint32_t, nodes_in_box> nodes{}; ///< as BoxProduct has them
  std::array<double, 3> edges{};
  /// Tangents less the moduli of the box, x fastest.
  std::array<PointTangent, nodes_in_box> change;
};

/// Adds `factor` times the force by the change of the tangents.
template <class Number>
void add_flow(const FlowingBox& box, const Number* displacement, Number* force,
              double factor);

extern template void add_flow(const FlowingBox&, const float*, float*, double);
extern template void add_flow(const FlowingBox&, const double*, double*,
                              double);

} // namespace asperity::fem
