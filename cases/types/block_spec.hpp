#pragma once

// What a case says of a block that is not one homogeneous box: its layers, its
// inclusion, how its modulus varies, and how all of it is meshed.

#include "cases/types/quantity.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity::cases {

/// An isotropic body by its own constants.
struct BodyModuli {
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1], -1..0.5
};

/// One entry of material.layers: the contact face's first. Below the last the
/// block is [material]'s own.
struct MaterialLayer {
  Quantity thickness; ///< [m] > 0
  BodyModuli moduli;
};

/// [material.inclusion]: a sphere under the middle of the contact face.
struct MaterialInclusion {
  Quantity radius; ///< [m] > 0
  Quantity depth;  ///< of its centre [m] > radius
  BodyModuli moduli;
};

enum class VariationKind { function, random, table };

/// [material.variation]: E(x) = E times a factor; nu stays.
struct MaterialVariation {
  VariationKind kind = VariationKind::function;
  std::string factor;     ///< of x, y, z, each over length; z = 0 is the face
  double spread = 0.0;    ///< random: 1 - spread..1 + spread, cell by cell
  std::uint64_t seed = 0; ///< of the random factors
  std::string file; ///< of the table: made absolute or relative to the working
                    ///< directory by the reader
};

enum class MeshKind { layers, hanging, gmsh };
enum class MeshGeometry { block, indentation, layered, inclusion, file };
enum class MeshCells { hexahedra, tetrahedra };

/// [mesh]: of the whole block (solver = "full").
struct MeshSpec {
  MeshKind kind = MeshKind::layers;
  int cells_a_level = 4;                             ///< hanging
  MeshGeometry geometry = MeshGeometry::block;       ///< gmsh
  MeshCells cells = MeshCells::hexahedra;            ///< gmsh
  Quantity size_at_contact{1.0, Yardstick::spacing}; ///< edge of a cell [m]
  Quantity size_far{0.1, Yardstick::length};         ///< away from the face [m]
  Quantity fine_radius{0.1, Yardstick::length};      ///< indentation [m]
  std::string file;       ///< as in MaterialVariation
  double file_unit = 1.0; ///< metres a unit of the file
};

enum class BlockSides { periodic, free };
enum class LinearSolverChoice { automatic, direct, multigrid, fourier };
enum class ContactPoints { nodes, gauss };

} // namespace asperity::cases
