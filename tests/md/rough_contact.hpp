#pragma once

// A small rough contact for the tests of complete systems: a few long waves
// under a block of the paper's atoms.

#include "md/contact/explicit_system.hpp"
#include "tests/md/small_interface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::md::problems {

constexpr double atom_mass = 197.0 * 1.66053906660e-27; // kg

inline Crystal paper_crystal() {
  return {mechanics::AtomLattice::isotropic, layer_spacing, 77.2e9, 0.42};
}

struct RoughContact {
  int atoms = 16; ///< per side
  int levels = 1;
  int layers = 6;
  double rms_height = 1.0 * angstrom;
  unsigned seed = 11;
  int threads = 1;

  Grid layer() const { return lattice(atoms, atoms * layer_spacing); }

  Grid substrate() const {
    return lattice(mechanics::incommensurate_atoms(atoms),
                   atoms * layer_spacing);
  }

  /// Waves of wavenumber 1 and 2 in both directions, with random phases and
  /// mean 0.
  std::vector<double> heights() const {
    const Grid grid = substrate();
    const std::vector<double> phases =
        random_numbers(8, 0.0, 2.0 * std::numbers::pi, seed);
    std::vector<double> heights(grid.size());
    double sum = 0.0;
    for (int iy = 0; iy < grid.points_y; ++iy)
      for (int ix = 0; ix < grid.points_x; ++ix) {
        const double x = 2.0 * std::numbers::pi * ix / grid.points_x;
        const double y = 2.0 * std::numbers::pi * iy / grid.points_y;
        double height = 0.0;
        for (int i = 0; i < 2; ++i) {
          const auto first = static_cast<std::size_t>(4 * i);
          const double wave = i + 1.0;
          height += std::cos(wave * x + phases[first]) / wave +
                    std::cos(wave * y + phases[first + 1]) / wave +
                    std::cos(wave * (x + y) + phases[first + 2]) / wave +
                    std::cos(wave * (x - y) + phases[first + 3]) / wave;
        }
        heights[grid.index(ix, iy)] = height;
        sum += height * height;
      }
    const double scale =
        rms_height / std::sqrt(sum / static_cast<double>(grid.size()));
    for (double& height : heights)
      height *= scale;
    return heights;
  }

  double highest() const {
    const std::vector<double> all = heights();
    return *std::max_element(all.begin(), all.end());
  }

  Interface interface() const {
    return {paper_atoms(), layer(), substrate(), heights(), threads};
  }

  ExplicitSystem system() const {
    return {paper_crystal(),
            {layer(), levels, layers},
            interface(),
            atom_mass,
            threads};
  }
};

} // namespace asperity::md::problems
