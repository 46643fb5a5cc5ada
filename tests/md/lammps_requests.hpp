#pragma once

// Small requests for the engine lammps: the paper's atoms on waves of a few
// wavelengths.

#include "md/contact/atomic_contact.hpp"
#include "tests/md/small_interface.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <unistd.h>
#include <vector>

namespace asperity::md::problems {

/// Waves in four directions without a common symmetry, of the requested rms
/// slope.
inline std::vector<double> waves(const Grid& grid, double rms_slope) {
  struct Wave {
    int x;
    int y;
    double amplitude;
    double phase;
  };

  const std::vector<Wave> sum = {
      {1, 0, 1.0, 0.3}, {1, 2, 0.5, 1.1}, {2, -1, 0.4, 2.5}, {3, 1, 0.25, 4.0}};
  const double wavevector = 2.0 * std::numbers::pi / grid.length_x;
  double slope_square = 0.0;
  for (const Wave& wave : sum)
    slope_square += 0.5 * std::pow(wave.amplitude * wavevector, 2) *
                    (wave.x * wave.x + wave.y * wave.y);
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      for (const Wave& wave : sum)
        heights[grid.index(ix, iy)] +=
            rms_slope / std::sqrt(slope_square) * wave.amplitude *
            std::cos(wavevector * (wave.x * ix * grid.spacing_x() +
                                   wave.y * iy * grid.spacing_y()) +
                     wave.phase);
  return heights;
}

/// points^2 atoms in a layer, `cells` layers of cells, nu = 1/4, on a surface
/// of incommensurate atoms.
inline AtomRequest small_request(int points, int cells, double rms_slope) {
  const double length = points * layer_spacing;
  AtomRequest request;
  request.youngs_modulus = 77.2e9;
  request.poisson_ratio = 0.25;
  request.layer = lattice(points, length);
  request.substrate = lattice(mechanics::incommensurate_atoms(points), length);
  request.heights = waves(request.substrate, rms_slope);
  mechanics::MdSettings& settings = request.settings;
  settings.engine = mechanics::AtomEngine::lammps;
  settings.lattice = mechanics::AtomLattice::central;
  settings.interaction_energy = paper_atoms().energy;
  settings.interaction_distance = paper_atoms().distance;
  settings.cutoff = paper_atoms().cutoff;
  settings.contact_distance = contact_distance;
  settings.depth = {cells * layer_spacing, mechanics::ReferenceUnit::si};
  request.scratch = std::filesystem::temp_directory_path() /
                    ("asperity-lammps-" + std::to_string(::getpid()));
  return request;
}

} // namespace asperity::md::problems
