#pragma once

// The part of a case that describes a heterogeneous block: its layers, its
// inclusion, the variation of its modulus, and its mesh.

#include "cases/types/quantity.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity::cases {

/// The elastic constants of an isotropic body.
struct BodyModuli {
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1], -1..0.5
};

/// One entry of material.layers, ordered from the contact surface. Below the
/// last layer the block has the constants of [material].
struct MaterialLayer {
  Quantity thickness; ///< [m] > 0
  BodyModuli moduli;
};

/// [material.inclusion]: a spherical inclusion below the centre of the contact
/// surface.
struct MaterialInclusion {
  Quantity radius; ///< [m] > 0
  Quantity depth;  ///< depth of the centre [m] > radius
  BodyModuli moduli;
};

enum class VariationKind { function, random, table };

/// [material.variation]: E(x) is E times a factor; nu is constant.
struct MaterialVariation {
  VariationKind kind = VariationKind::function;
  std::string factor; ///< function of x, y, z, each divided by length; z = 0 is
                      ///< the contact surface
  double spread = 0.0;    ///< random: factor per cell in 1 - spread..1 + spread
  std::uint64_t seed = 0; ///< seed of the random factors
  std::string file; ///< file of the table; the reader makes the path absolute
                    ///< or relative to the working directory
};

enum class MeshKind { layers, hanging, gmsh };
enum class MeshGeometry { block, indentation, layered, inclusion, file };
enum class MeshCells { hexahedra, tetrahedra };

/// [mesh]: the mesh of the full block (solver = "full").
struct MeshSpec {
  MeshKind kind = MeshKind::layers;
  int cells_a_level = 4;                       ///< cells per level, for hanging
  MeshGeometry geometry = MeshGeometry::block; ///< for gmsh
  MeshCells cells = MeshCells::hexahedra;      ///< for gmsh
  /// Edge length of a cell [m].
  Quantity size_at_contact{1.0, ReferenceUnit::spacing};
  Quantity size_far{0.1, ReferenceUnit::length}; ///< far from the contact
                                                 ///< surface [m]
  Quantity fine_radius{0.1, ReferenceUnit::length}; ///< for indentation [m]
  std::string file;                                 ///< as in MaterialVariation
  double file_unit = 1.0; ///< metres per unit of the file
};

enum class BlockSides { periodic, free };
enum class LinearSolverChoice { automatic, direct, multigrid, fourier };
enum class ContactPoints { nodes, gauss };

} // namespace asperity::cases
