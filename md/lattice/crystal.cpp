#include "md/lattice/crystal.hpp"

#include "base/require.hpp"

#include <cmath>

namespace asperity::md {
namespace {

using LatticeVector = std::array<double, 3>;

constexpr std::size_t corners = 8;
constexpr std::size_t unknowns = 3 * corners;

double shear_modulus(const Crystal& crystal) {
  return crystal.youngs_modulus / (2.0 * (1.0 + crystal.poisson_ratio));
}

/// Returns kappa = lambda - mu.
double dilatation_modulus(const Crystal& crystal) {
  const double nu = crystal.poisson_ratio;
  return shear_modulus(crystal) * (4.0 * nu - 1.0) / (1.0 - 2.0 * nu);
}

void require(const Crystal& crystal) {
  require_positive("spacing", crystal.spacing, "m");
  require_positive("youngs_modulus", crystal.youngs_modulus, "Pa");
  const double nu = crystal.poisson_ratio;
  if (!(nu > -1.0 && nu < 0.5))
    refuse_argument("poisson_ratio", nu, "above -1 and below 0.5");
  if (crystal.lattice == mechanics::AtomLattice::central &&
      std::abs(nu - 0.25) > 1e-12)
    refuse_argument("poisson_ratio", nu, "1/4 for central springs");
}

/// Adds the spring energy (1/2) stiffness (direction . (u_second - u_first))^2.
void add_spring(CellStiffness& matrix, std::size_t first, std::size_t second,
                const LatticeVector& direction, double stiffness) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double term = stiffness * direction[i] * direction[j];
      matrix[(3 * first + i) * unknowns + 3 * first + j] += term;
      matrix[(3 * second + i) * unknowns + 3 * second + j] += term;
      matrix[(3 * first + i) * unknowns + 3 * second + j] -= term;
      matrix[(3 * second + i) * unknowns + 3 * first + j] -= term;
    }
  }
}

/// Adds the twelve edges, a quarter of each.
void add_edges(CellStiffness& matrix, double normal, double tangential) {
  for (std::size_t corner = 0; corner < corners; ++corner) {
    for (std::size_t along = 0; along < 3; ++along) {
      if ((corner >> along) & 1U)
        continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        LatticeVector direction{};
        direction[axis] = 1.0;
        add_spring(matrix, corner, corner | (1U << along), direction,
                   0.25 * (axis == along ? normal : tangential));
      }
    }
  }
}

/// Adds the twelve face diagonals, half of each.
void add_face_diagonals(CellStiffness& matrix, double stiffness) {
  for (std::size_t normal = 0; normal < 3; ++normal) {
    const std::size_t along = (normal + 1) % 3;
    const std::size_t across = (normal + 2) % 3;
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t origin = side << normal;
      LatticeVector direction{};
      direction[along] = std::sqrt(0.5);
      direction[across] = std::sqrt(0.5);
      add_spring(matrix, origin, origin | (1U << along) | (1U << across),
                 direction, 0.5 * stiffness);
      direction[across] = -std::sqrt(0.5);
      add_spring(matrix, origin | (1U << across), origin | (1U << along),
                 direction, 0.5 * stiffness);
    }
  }
}

/// Adds (1/2) kappa a^3 (div u)^2, where div u is the mean divergence over the
/// cell, the sum of +-u_axis / (4 a) over its corners.
void add_dilatation(CellStiffness& matrix, double modulus, double spacing) {
  std::array<double, unknowns> divergence{};
  for (std::size_t corner = 0; corner < corners; ++corner)
    for (std::size_t axis = 0; axis < 3; ++axis)
      divergence[3 * corner + axis] = (corner >> axis) & 1U ? 0.25 : -0.25;
  for (std::size_t i = 0; i < unknowns; ++i)
    for (std::size_t j = 0; j < unknowns; ++j)
      matrix[i * unknowns + j] +=
          modulus * spacing * divergence[i] * divergence[j];
}

} // namespace

CellStiffness cell_stiffness(const Crystal& crystal) {
  require(crystal);
  const double spacing = crystal.spacing;
  const double shear = shear_modulus(crystal);
  CellStiffness matrix{};
  if (crystal.lattice == mechanics::AtomLattice::born) {
    add_edges(matrix, crystal.youngs_modulus * spacing, shear * spacing);
    return matrix;
  }
  add_edges(matrix, shear * spacing, 0.0);
  add_face_diagonals(matrix, shear * spacing);
  if (crystal.lattice == mechanics::AtomLattice::isotropic)
    add_dilatation(matrix, dilatation_modulus(crystal), spacing);
  return matrix;
}

} // namespace asperity::md
