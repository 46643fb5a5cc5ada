#pragma once

// FFTW's own transforms over MPI behind base/ranks/slab_transforms.hpp.

#include "base/grid.hpp"
#include "base/ranks/slab_transforms.hpp"

#include <mpi.h>

#include <memory>

namespace asperity::fem {

/// @param rows  of each rank but the last ones
template <class Real>
std::shared_ptr<SlabTransforms<Real>> slab_transforms(const Grid& grid,
                                                      int rows, MPI_Comm ranks);

} // namespace asperity::fem
