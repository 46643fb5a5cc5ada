#include "md/lattice/surface_stiffness.hpp"

#include "base/field_sums.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity::md {
namespace {

using mechanics::AtomModes;
using Complex = std::complex<double>;

const Grid& required(const Crystal& crystal, const Grid& layer) {
  if (!layer.is_square())
    refuse_argument("points_y of the layer", layer.points_y,
                    "equal to points_x, with equal side lengths");
  if (layer.points_x % 2 != 0)
    refuse_argument("points_x of the layer", layer.points_x, "even");
  const double spacing = layer.spacing_x();
  if (std::abs(spacing / crystal.spacing - 1.0) > 1e-9)
    refuse_argument("spacing of the layer", spacing, "that of the crystal [m]");
  return layer;
}

/// Maps K(x, y) to K(y, x) by the mirror symmetry x <-> y.
SymmetricBlock swapped(const SymmetricBlock& block) {
  return {block.yy, block.xx, block.zz, block.xy, block.yz, block.xz};
}

/// The octant 0 <= jy <= jx <= n/2 of all wavevectors, from which the others
/// follow by symmetry.
class Octant {
public:
  Octant(const SlabSymbol& slab, int points, int cells, AtomModes modes) {
    const auto angle = [&](int j) {
      return 2.0 * std::numbers::pi * j / points;
    };
    for (int jx = 0; jx <= points / 2; ++jx) {
      for (int jy = 0; jy <= jx; ++jy) {
        SymmetricBlock block = slab.clamped(angle(jx), angle(jy), cells);
        if (modes == AtomModes::normal)
          block = {.zz = 1.0 / inverse(block).zz};
        // On the zone boundary +q and -q are the same mode, so odd entries
        // vanish.
        if (2 * jx == points)
          block.xy = block.xz = 0.0;
        if (2 * jy == points)
          block.xy = block.yz = 0.0;
        blocks_.push_back(block);
      }
    }
  }

  SymmetricBlock at(int jx, int jy) const {
    const auto high = static_cast<std::size_t>(std::max(jx, std::abs(jy)));
    const auto low = static_cast<std::size_t>(std::min(jx, std::abs(jy)));
    SymmetricBlock block = blocks_[high * (high + 1) / 2 + low];
    if (std::abs(jy) > jx)
      block = swapped(block);
    if (jy < 0) {
      block.xy = -block.xy;
      block.yz = -block.yz;
    }
    return block;
  }

private:
  std::vector<SymmetricBlock> blocks_;
};

/// Computes (x, y, z) = K (x, y, z) for Fourier coefficients without the
/// factors -i. The even entries of K then remain real, and the odd ones become
/// imaginary.
void multiply(const SymmetricBlock& block, Complex& x, Complex& y, Complex& z) {
  const auto turned = [](double factor, const Complex& value) {
    return Complex(-factor * value.imag(), factor * value.real());
  };
  const Complex new_x = block.xx * x + block.xy * y + turned(block.xz, z);
  const Complex new_y = block.xy * x + block.yy * y + turned(block.yz, z);
  z = block.zz * z - turned(block.xz, x) - turned(block.yz, y);
  x = new_x;
  y = new_y;
}

} // namespace

SurfaceStiffness::SurfaceStiffness(const Crystal& crystal, const Grid& layer,
                                   int cells, AtomModes modes, int threads)
    : modes_(modes),
      fourier_(required(crystal, layer), threads),
      z_(layer.half_spectrum_size()) {
  const int points = layer.points_x;
  const Octant octant(SlabSymbol(crystal), points, cells, modes);
  symbol_.reserve(layer.half_spectrum_size());
  for (int jy = 0; jy < points; ++jy)
    for (int jx = 0; jx <= points / 2; ++jx)
      symbol_.push_back(octant.at(jx, signed_wavenumber(jy, points)));
  symbol_[0] = {}; // the uniform displacement has no stiffness
  if (modes == AtomModes::vector) {
    x_.resize(layer.half_spectrum_size());
    y_.resize(layer.half_spectrum_size());
  }
}

const SymmetricBlock& SurfaceStiffness::at(int jx, int jy) const {
  const std::size_t columns = layer().half_spectrum_columns();
  return symbol_[static_cast<std::size_t>(jy) * columns +
                 static_cast<std::size_t>(jx)];
}

double SurfaceStiffness::local_stiffness() const {
  const int points = layer().points_x;
  double sum = 0.0;
  for (int jy = 0; jy < points; ++jy)
    for (int jx = 0; jx <= points / 2; ++jx)
      sum += (jx == 0 || 2 * jx == points ? 1.0 : 2.0) * at(jx, jy).zz;
  return sum / static_cast<double>(layer().size());
}

void SurfaceStiffness::to_spectra(const LayerView& planes) {
  if (modes_ == AtomModes::vector) {
    fourier_.forward(planes.x, x_);
    fourier_.forward(planes.y, y_);
  }
  fourier_.forward(planes.z, z_);
}

void SurfaceStiffness::from_spectra(const LayerForces& planes) {
  if (modes_ == AtomModes::vector) {
    fourier_.backward(x_, planes.x);
    fourier_.backward(y_, planes.y);
  } else {
    std::ranges::fill(planes.x, 0.0);
    std::ranges::fill(planes.y, 0.0);
  }
  fourier_.backward(z_, planes.z);
}

double SurfaceStiffness::apply(const LayerView& displacement,
                               const LayerForces& forces) {
  // A forward and a backward transform multiply by the number of atoms.
  const double factor = 1.0 / static_cast<double>(layer().size());
  to_spectra(displacement);
  for (std::size_t j = 0; j < symbol_.size(); ++j) {
    z_[j] *= factor;
    if (modes_ == AtomModes::normal) {
      z_[j] *= symbol_[j].zz;
      continue;
    }
    x_[j] *= factor;
    y_[j] *= factor;
    multiply(symbol_[j], x_[j], y_[j], z_[j]);
  }
  from_spectra(forces);
  double twice = dot(displacement.z, forces.z);
  if (modes_ == AtomModes::vector)
    twice += dot(displacement.x, forces.x) + dot(displacement.y, forces.y);
  return 0.5 * twice;
}

void SurfaceStiffness::solve(const LayerView& forces,
                             const ContactStiffness& contact,
                             const LayerForces& displacement) {
  const double factor = 1.0 / static_cast<double>(layer().size());
  to_spectra(forces);
  for (std::size_t j = 1; j < symbol_.size(); ++j) {
    z_[j] *= factor;
    if (modes_ == AtomModes::normal) {
      z_[j] /= symbol_[j].zz + contact.normal;
      continue;
    }
    x_[j] *= factor;
    y_[j] *= factor;
    multiply(inverse(symbol_[j], contact.lateral, contact.normal), x_[j], y_[j],
             z_[j]);
  }
  z_[0] = 0.0;
  if (modes_ == AtomModes::vector)
    x_[0] = y_[0] = 0.0;
  from_spectra(displacement);
}

} // namespace asperity::md
