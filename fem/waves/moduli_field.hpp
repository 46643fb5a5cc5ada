#pragma once

// Elastic moduli as a function of the place in the block. This file converts
// the material description of a case to lambda and mu of a cell.

#include "fem/waves/elastic_layers.hpp"
#include "mechanics/material.hpp"
#include "mechanics/quantity.hpp"
#include "meshes/block_mesh.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity::fem {

/// Lame's moduli of an isotropic material.
struct Moduli {
  double lame_modulus = 0.0;  ///< lambda [Pa] > -2 mu / 3
  double shear_modulus = 0.0; ///< mu [Pa] > 0

  friend bool operator==(const Moduli&, const Moduli&) = default;
};

/// @throws std::domain_error  E or nu is outside its range
Moduli moduli(const mechanics::BodyModuli& body);

/// A dimensionless factor on E as a function of the place (x, y, z) [m], with z
/// pointing into the block.
using ModulusFactor = std::function<double(const meshes::Place&)>;

/// The factor given by a muParser expression in x, y, z, each divided by
/// `length`; `pi` is defined too. Copies share one parser, so they must not be
/// used by several threads at once.
/// @param length  unit of length of x, y, z [m] > 0
/// @throws std::domain_error  the expression is invalid; the message contains
///                            the parser's own message and the column
ModulusFactor expression_factor(const std::string& expression, double length);

/// A factor that is uniformly distributed in 1 - spread..1 + spread and
/// independent from cell to cell. It is computed by Philox with the seed as key
/// and the place of the cell, in eighths of the spacing, as counter, so the
/// factor of a cell does not depend on the order of cells or on the ranks.
/// @param spread   [1] 0..0.99
/// @param spacing  [m] > 0; places closer than an eighth of it share a factor
ModulusFactor random_factor(double spread, std::uint64_t seed, double spacing);

/// As random_factor, but with one factor in each cube of a grid of boxes from
/// the origin, so that the factor of a place does not depend on the mesh.
/// @param edge  of the cubes [m] > 0
ModulusFactor random_cubes(double spread, std::uint64_t seed, double edge);

/// Piecewise constant factors in equal boxes over length_x, length_y, depth.
struct FactorTable {
  std::array<int, 3> boxes{};      ///< number of boxes in x, y, z, each >= 1
  std::vector<double> factors;     ///< factors on E [1] > 0, x fastest, then y
  std::array<double, 3> lengths{}; ///< of the full block [m] > 0
};

/// @throws std::domain_error  the sizes are inconsistent, or a factor is not
///                            positive
ModulusFactor table_factor(FactorTable table);

/// Reads a text file of numbers: a comment "# boxes nx ny nz", then ny nz rows
/// of nx factors, starting at the contact surface.
/// @param lengths  of the block [m]
/// @throws input::InputError  as surfaces::read_number_file; also for a wrong
///                            number of factors, or a factor that is not
///                            positive, with its line
FactorTable read_factor_table(const std::string& path,
                              const std::array<double, 3>& lengths);

/// The moduli of a cell as a function of the place of its centre. A sphere
/// takes precedence over layers and layers over the remaining material; a
/// factor multiplies E of all three and leaves nu unchanged. The second body
/// (z < 0) is not covered by this class.
class ModuliField {
public:
  /// A field with one material everywhere.
  explicit ModuliField(Moduli everywhere) : rest_(everywhere) {}

  /// A field with the block's layers; the last one extends to infinity.
  explicit ModuliField(const LayeredBlock& block);

  /// Adds the next layer from the contact surface upwards.
  /// @param thickness  thickness of the layer [m] > 0
  void add_layer(double thickness, const Moduli& layer);

  /// @param centre  centre of the sphere [m]
  /// @param radius  radius of the sphere [m]
  void set_sphere(const meshes::Place& centre, double radius,
                  const Moduli& sphere);

  /// @param feature  the least edge of a box in which the factor is constant
  ///                 [m]; 0 if there are no such boxes
  void set_factor(ModulusFactor factor, double feature = 0.0) {
    factor_ = std::move(factor);
    feature_ = feature;
  }

  /// Depths of the interfaces between the layers [m], increasing.
  std::vector<double> interfaces() const;

  struct Sphere {
    meshes::Place centre; ///< [m]
    double radius = 0.0;  ///< [m]
    Moduli moduli;
  };

  const std::optional<Sphere>& sphere() const { return sphere_; }

  bool has_factor() const { return static_cast<bool>(factor_); }

  double feature() const { return feature_; } ///< of set_factor [m]

  /// The factor on E [1]; 1 if there is none.
  /// @throws std::domain_error  as at()
  double factor(const meshes::Place& place) const;

  /// @throws std::domain_error  the factor is not positive and finite at the
  ///                            place
  Moduli at(const meshes::Place& place) const;

private:
  struct Layer {
    double upper_side = 0.0; ///< [m]
    Moduli moduli;
  };

  Moduli without_factor(const meshes::Place& place) const;

  Moduli rest_;
  std::vector<Layer> layers_;
  std::optional<Sphere> sphere_;
  ModulusFactor factor_;
  double feature_ = 0.0;
};

/// The moduli field of a case.
/// @param block  E and nu of the block itself, below the layers
/// @param grid   grid of the surface: expressions measure lengths in
///               grid.length_x, random factors places in grid.spacing_x()
/// @param depth  depth of the block, which a table covers [m] > 0
/// @throws std::domain_error, input::InputError  as the factors above; or no
///         part of the inclusion lies in the block, or it reaches the contact
///         surface
ModuliField moduli_field(const mechanics::MaterialSpec& material,
                         const mechanics::Scales& scales,
                         const mechanics::BodyModuli& block, const Grid& grid,
                         double depth);

} // namespace asperity::fem
