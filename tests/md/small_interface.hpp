#pragma once

// The paper's atoms (Sec. 4) on cells small enough for a double loop.

#include "md/interface/interface.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace asperity::md::problems {

constexpr double angstrom = 1e-10;
constexpr double milli_electron_volt = 1.602176634e-22;
constexpr double contact_distance = 4.3615 * angstrom; // d_c
constexpr double layer_spacing = 2.6 * angstrom;       // a

/// eps = 74.4 meV, r_0 = 3.28 A, a cut-off of 10 A whose last angstrom is
/// tapered.
inline Interaction paper_atoms(double attraction = 0.0) {
  return {74.4 * milli_electron_volt, 3.28 * angstrom, 10.0 * angstrom,
          9.0 * angstrom, attraction};
}

/// The pressure of the untruncated repulsion between two parallel planes of
/// atoms, one per atom_area and one per substrate_area, both treated as
/// continuous, at a distance d:
///
///     p = 2 pi eps r_0^12 / (atom_area substrate_area d^11)             [Pa]
///
/// The discrete sum over two incommensurate planes has the same mean, except
/// for the effects of the cutoff, which removes a fraction (d/cutoff)^12, and
/// of the taper.
inline double plane_repulsion_pressure(const Interaction& interaction,
                                       double atom_area, double substrate_area,
                                       double height) {
  return 2.0 * std::numbers::pi * interaction.energy * interaction.distance /
         (atom_area * substrate_area) *
         std::pow(interaction.distance / height, 11);
}

inline Grid lattice(int points, double length) {
  return {points, points, length, length};
}

inline std::vector<double> random_numbers(std::size_t count, double low,
                                          double high, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(low, high);
  std::vector<double> numbers(count);
  for (double& each : numbers)
    each = number(generator);
  return numbers;
}

/// Values, each changed at random by up to `most`.
inline std::vector<double> disturbed(std::vector<double> values, double most,
                                     unsigned seed) {
  const std::vector<double> changes =
      random_numbers(values.size(), -most, most, seed);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] += changes[i];
  return values;
}

/// Three planes of a layer, of positions or of forces.
struct Planes {
  std::vector<double> x, y, z;

  explicit Planes(std::size_t size) : x(size), y(size), z(size) {}

  LayerView view() const { return {x, y, z}; }

  LayerForces forces() { return {x, y, z}; }
};

/// A layer about `height` over a rough substrate, displaced at random by up to
/// `displacement` [m].
struct InterfaceProblem {
  Grid layer;
  Grid substrate;
  std::vector<double> heights;
  Planes atoms;

  InterfaceProblem(int layer_points, int substrate_points, double displacement,
                   unsigned seed, double height = 3.6 * angstrom)
      : layer(lattice(layer_points, layer_points * layer_spacing)),
        substrate(lattice(substrate_points, layer.length_x)),
        heights(random_numbers(substrate.size(), -angstrom, angstrom, seed)),
        atoms(layer.size()) {
    atoms.x =
        random_numbers(layer.size(), -displacement, displacement, seed + 1);
    atoms.y =
        random_numbers(layer.size(), -displacement, displacement, seed + 2);
    atoms.z = random_numbers(layer.size(), height - angstrom,
                             height + 5.0 * angstrom, seed + 3);
  }

  Interface interface(const Interaction& interaction, int threads = 1) const {
    return {interaction, layer, substrate, heights, threads};
  }
};

/// Calls take(i, dx, dy, dz) for atom i and each substrate atom, with the
/// vector from the latter to the atom, x and y to the nearest image [m].
template <class Take>
void for_all_pairs(const InterfaceProblem& problem, const Take& take) {
  const Grid& layer = problem.layer;
  const Grid& substrate = problem.substrate;
  for (std::size_t i = 0; i < layer.size(); ++i) {
    const auto column =
        static_cast<double>(i % static_cast<std::size_t>(layer.points_x));
    const auto row =
        static_cast<double>(i / static_cast<std::size_t>(layer.points_x));
    const double x = column * layer.spacing_x() + problem.atoms.x[i];
    const double y = row * layer.spacing_y() + problem.atoms.y[i];
    for (int jy = 0; jy < substrate.points_y; ++jy)
      for (int jx = 0; jx < substrate.points_x; ++jx)
        take(i, std::remainder(x - jx * substrate.spacing_x(), layer.length_x),
             std::remainder(y - jy * substrate.spacing_y(), layer.length_y),
             problem.atoms.z[i] - problem.heights[substrate.index(jx, jy)]);
  }
}

} // namespace asperity::md::problems
