#pragma once

// Blocks whose mesh follows the contact, uniform ones to compare them with, and
// what presses them.

#include "fem/adaptive/adaptive_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"
#include "tests/fem/rough_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace asperity::fem {

using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::FarBoundary;

constexpr double length = 1e-6; // m, of a side and of the depth
inline const mechanics::BodyModuli body{soft_modulus, 0.3};
inline const double contact_modulus = soft_modulus / (1.0 - 0.3 * 0.3);

inline BlockProblem adaptive_problem(const Grid& grid, int degree,
                                     int halvings) {
  const int step = degree << halvings;
  return {.grid = grid,
          .mesh =
              meshes::equal_boxes({grid.points_x / step, grid.points_y / step,
                                   grid.length_x, grid.length_y},
                                  length),
          .degree = degree,
          .moduli = ModuliField(moduli(body)),
          .adaptive = AdaptiveMesh{halvings}};
}

/// Layers growing by 1.2.
inline std::unique_ptr<FullBlock> uniform_block(const Grid& grid, int degree) {
  return make_full_block(
      grid, degree,
      homogeneous_block(
          meshes::graded_layers(degree * grid.spacing_x(), 1.2, length),
          body.youngs_modulus, body.poisson_ratio, FarBoundary::clamped));
}

inline BlockContact contact_of(const Grid& grid,
                               ContactLaw law = ContactLaw::hard) {
  return {law, 1e3 * contact_modulus / grid.spacing_x(), 1e-8, 400};
}

inline mechanics::LoadTarget pressed(double reduced_pressure) {
  return {Control::nominal_pressure, reduced_pressure * contact_modulus};
}

inline double share(double a, double b) {
  return std::abs(a / b - 1.0);
}

/// A block of 32 points whose mesh has followed a rough contact.
inline std::unique_ptr<FullBlock> adapted_block(const BlockProblem& problem) {
  auto block = make_adaptive_block(problem);
  const BlockSolution found =
      block->solve(self_affine_heights(problem.grid), pressed(0.001),
                   contact_of(problem.grid));
  EXPECT_TRUE(found.converged) << found.note;
  return block;
}

} // namespace asperity::fem
