#include "md/lammps/lammps_block.hpp"

#include "base/require.hpp"
#include "input/input_error.hpp"
#include "md/contact/request_parts.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::md {
namespace {

/// Rejects settings that the LAMMPS engine does not support, before any
/// computation.
void require_supported(const mechanics::MdSettings& settings,
                       double poisson_ratio) {
  const auto refuse = [](const std::string& what) {
    throw input::InputError("[md] engine = \"lammps\" " + what);
  };
  if (settings.lattice != mechanics::AtomLattice::central ||
      std::abs(poisson_ratio - 0.25) > 1e-12)
    refuse("needs lattice = \"central\" and poisson_ratio = 0.25: its harmonic "
           "bonds are pair springs, which fix Poisson's ratio; \"isotropic\" "
           "and \"born\" need more than pair interactions");
  if (settings.modes != mechanics::AtomModes::vector)
    refuse("moves its atoms in all three directions: modes = \"normal\" is "
           "available only with engine = \"asperity\"");
  if (settings.bulk != mechanics::AtomBulk::green)
    refuse("always uses one spacing from the surface down to `depth`: remove "
           "bulk = \"explicit\", levels and layers");
  if (settings.minimizer == mechanics::AtomMinimizer::dynamics)
    refuse("supports only static equilibrium: minimizer = \"dynamics\" is "
           "available only with engine = \"asperity\"");
}

} // namespace

double LammpsBlock::bond_stiffness() const {
  return crystal.youngs_modulus / (2.0 * (1.0 + crystal.poisson_ratio)) *
         crystal.spacing;
}

LammpsBlock lammps_block(const AtomRequest& request) {
  const mechanics::MdSettings& settings = request.settings;
  require_supported(settings, request.poisson_ratio);
  require_positive("youngs_modulus", request.youngs_modulus, "Pa");
  require_positive("length", request.layer.length_x, "m");
  if (!request.layer.is_square() || request.layer.points_x < 3)
    refuse_argument(
        "layer.points_x", request.layer.points_x,
        "at least 3 and equal to layer.points_y, with equal side lengths");
  if (request.heights.size() != request.substrate.size())
    refuse_argument("heights", static_cast<double>(request.heights.size()),
                    "one per atom of the substrate");

  LammpsBlock block;
  block.layer = request.layer;
  block.substrate = request.substrate;
  block.heights = request.heights;
  block.crystal = crystal_of(request);
  block.interaction = interaction_of(settings);
  const double depth = settings.depth.in_si(request.scales);
  require_positive("depth", depth, "m");
  block.cells =
      std::max(1, static_cast<int>(std::lround(depth / block.crystal.spacing)));
  return block;
}

BlockVectors undeformed(const LammpsBlock& block, double height) {
  BlockVectors positions;
  positions.reserve(block.atoms());
  for (int k = 0; k <= block.cells; ++k)
    for (int iy = 0; iy < block.layer.points_y; ++iy)
      for (int ix = 0; ix < block.layer.points_x; ++ix)
        positions.push_back({ix * block.layer.spacing_x(),
                             iy * block.layer.spacing_y(),
                             height + k * block.crystal.spacing});
  return positions;
}

double mean_height(const LammpsBlock& block, const BlockVectors& positions) {
  const std::size_t n = block.layer.size();
  double sum = 0.0;
  for (std::size_t atom = 0; atom < n; ++atom)
    sum += positions[atom][2];
  return sum / static_cast<double>(n);
}

double residual(const LammpsBlock& block, double force_norm,
                double contact_force) {
  if (force_norm == 0.0)
    return 0.0;
  return force_norm * std::sqrt(static_cast<double>(block.layer.size()) / 3.0) /
         contact_force;
}

} // namespace asperity::md
