#pragma once

// The stress of a solved block in a plane through it, at places that need not
// be the mesh's. Owns which cell answers for a place.
// Include from .cpp files of fem/ only.

#include "fem/block/block_stress.hpp"

#include <vector>

namespace asperity::fem {

/// FullBlock::section. Collective; every rank gets all of it.
std::vector<double> von_mises_in(const SectionPlane& plane,
                                 const BlockSpace& space, BlockStress& stress);

} // namespace asperity::fem
