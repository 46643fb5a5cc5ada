#pragma once

// Blocks and pressures that several tests of the module use.

#include "fem/waves/elastic_layers.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <span>
#include <vector>

namespace asperity::fem {

constexpr double soft_modulus = 2.0e9; // Pa

/// A block of graded layers whose moduli differ from layer to layer.
inline LayeredBlock layered_block(double surface_thickness, double depth,
                                  mechanics::FarBoundary far_boundary) {
  LayeredBlock block;
  block.far_boundary = far_boundary;
  const std::vector<double> thickness =
      meshes::graded_layers(surface_thickness, 1.4, depth);
  for (std::size_t i = 0; i < thickness.size(); ++i)
    block.layers.push_back(elastic_layer(
        thickness[i], soft_modulus * (1.0 + 0.3 * static_cast<double>(i % 3)),
        0.45 - 0.1 * static_cast<double>(i % 4)));
  return block;
}

/// Independent uniformly distributed numbers in 0..1.
inline std::vector<double> random_field(std::size_t size, unsigned int seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> field(size);
  std::generate(field.begin(), field.end(), [&] { return uniform(engine); });
  return field;
}

/// The largest magnitude. NaN for an empty field or for a number that is not
/// finite, so that every comparison with it fails.
inline double largest_magnitude(std::span<const double> field) {
  double largest = field.empty() ? std::nan("") : 0.0;
  for (const double value : field) {
    if (!std::isfinite(value))
      return std::nan("");
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// The largest difference. NaN as above, and for fields of two sizes.
inline double largest_difference(std::span<const double> a,
                                 std::span<const double> b) {
  if (a.size() != b.size())
    return std::nan("");
  std::vector<double> differences(a.size());
  std::transform(a.begin(), a.end(), b.begin(), differences.begin(),
                 std::minus<>());
  return largest_magnitude(differences);
}

} // namespace asperity::fem
