#pragma once

// Stress of a solved block in a plane section, at places that need not be mesh
// nodes. This file determines which cell provides the value at a place.
// Include this header in .cpp files of fem/ only.

#include "fem/solution/block_stress.hpp"

#include <vector>

namespace asperity::fem {

/// Implements FullBlock::section. This call is collective; every rank receives
/// all values.
std::vector<double> von_mises_in(const SectionPlane& plane,
                                 const BlockSpace& space, BlockStress& stress);

} // namespace asperity::fem
