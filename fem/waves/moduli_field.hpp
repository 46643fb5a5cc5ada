#pragma once

// Elastic moduli as a function of the place in the block. Owns how what a case
// says of its material becomes lambda and mu of a cell.

#include "cases/types/case.hpp"
#include "fem/waves/elastic_layers.hpp"
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
Moduli moduli(const cases::BodyModuli& body);

/// A dimensionless factor on E by place (x, y, z) [m], z into the block.
using ModulusFactor = std::function<double(const meshes::Place&)>;

/// The factor of a muParser expression in x, y, z, each over `length`; `pi` is
/// known too. Copies share one parser: not for several threads at once.
/// @param length  what one unit of x, y, z stands for [m] > 0
/// @throws std::domain_error  the parser's own message and the column
ModulusFactor expression_factor(const std::string& expression, double length);

/// 1 - spread..1 + spread, uniform and independent from cell to cell: Philox
/// with the seed as key and the cell's place, in eighths of the spacing, as
/// counter. So a cell's factor knows neither the order of cells nor the ranks.
/// @param spread   [1] 0..0.99
/// @param spacing  [m] > 0; places nearer than an eighth of it share a factor
ModulusFactor random_factor(double spread, std::uint64_t seed, double spacing);

/// Factors in equal boxes over length_x, length_y, depth, piecewise constant.
struct FactorTable {
  std::array<int, 3> boxes{};      ///< in x, y, z, each >= 1
  std::vector<double> factors;     ///< of E [1] > 0, x fastest, then y
  std::array<double, 3> lengths{}; ///< of the whole block [m] > 0
};

/// @throws std::domain_error  sizes that do not fit, or a factor not positive
ModulusFactor table_factor(FactorTable table);

/// Reads a text of numbers: a comment "# boxes nx ny nz", then ny nz rows of
/// nx factors, those of the contact face first.
/// @param lengths  of the block [m]
/// @throws cases::CaseError  as surfaces::read_number_file, another count, and
///                           a factor that is not positive, by its line
FactorTable read_factor_table(const std::string& path,
                              const std::array<double, 3>& lengths);

/// What a cell is made of, by the place of its centre. A sphere goes before
/// layers and layers before the rest; a factor multiplies E of all three and
/// leaves nu. A counter body (z < 0) is not asked for here.
class ModuliField {
public:
  /// One material everywhere.
  explicit ModuliField(Moduli everywhere) : rest_(everywhere) {}

  /// The block's layers; the last goes on for ever.
  explicit ModuliField(const LayeredBlock& block);

  /// @param thickness  of the next layer from the contact face up [m] > 0
  void add_layer(double thickness, const Moduli& layer);

  /// @param radius, depth  of the sphere's centre below (centre x, y) [m]
  void set_sphere(const meshes::Place& centre, double radius,
                  const Moduli& sphere);

  void set_factor(ModulusFactor factor) { factor_ = std::move(factor); }

  /// @throws std::domain_error  a factor that is not positive and finite there
  Moduli at(const meshes::Place& place) const;

private:
  struct Layer {
    double upper_side = 0.0; ///< [m]
    Moduli moduli;
  };

  struct Sphere {
    meshes::Place centre;
    double radius = 0.0;
    Moduli moduli;
  };

  Moduli without_factor(const meshes::Place& place) const;

  Moduli rest_;
  std::vector<Layer> layers_;
  std::optional<Sphere> sphere_;
  ModulusFactor factor_;
};

/// The material of a case.
/// @param block  E and nu of the block itself, below the layers
/// @param grid   of the surface: expressions count lengths in grid.length_x,
///               random factors places in grid.spacing_x()
/// @param depth  of the block [m] > 0, which a table covers
/// @throws std::domain_error, cases::CaseError  as the factors above
ModuliField moduli_field(const cases::MaterialSpec& material,
                         const cases::Scales& scales,
                         const cases::BodyModuli& block, const Grid& grid,
                         double depth);

} // namespace asperity::fem
