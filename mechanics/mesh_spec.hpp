#pragma once

// The specification of the mesh of a full 3-D block, and of its lateral sides.

#include "mechanics/quantity.hpp"

#include <optional>
#include <string>

namespace asperity::mechanics {

/// The lateral sides of a block.
enum class BlockSides { periodic, free };

enum class MeshKind { layers, hanging, adaptive, gmsh };
enum class MeshGeometry { block, indentation, layered, inclusion, file };

/// The outline of a counter-body that is meshed by itself: a half ball or a cap
/// of it, or an upright circular or square column.
enum class CounterShape { sphere, cylinder, cuboid };

/// [mesh.counter]: the second body (bodies = 2) of finite size, under the
/// centre of the contact surface.
struct CounterMeshSpec {
  CounterShape shape = CounterShape::sphere;
  /// Of the sphere or the cylinder; half the side of the cuboid [m] > 0.
  Quantity radius{0.0, ReferenceUnit::si};
  std::optional<Quantity> height = {}; ///< [m] > 0; empty: the radius
  /// Of a cell [m]; empty: that of the block's cells.
  std::optional<Quantity> size_at_contact = {};
  Quantity size_far{0.1, ReferenceUnit::length}; ///< of a cell [m]
  /// Half the width of the fine region at the centre [m]; empty: a quarter of
  /// the radius for a sphere, otherwise the radius, which makes the whole end
  /// fine.
  std::optional<Quantity> fine_radius = {};
  Quantity offset_x{0.0, ReferenceUnit::si}; ///< of its axis [m]
  Quantity offset_y{0.0, ReferenceUnit::si}; ///< [m]
};

/// [mesh]: the mesh of the full block (solver = "full").
struct MeshSpec {
  MeshKind kind = MeshKind::layers;
  int cells_a_level = 4; ///< cells per level, for hanging
  int halvings = 3;      ///< at the contact, for adaptive
  /// For adaptive: largest ratio of moduli in a cell that need not be halved.
  double moduli_ratio = 1.25;
  /// For adaptive: halvings of cells at an interface between materials; unset,
  /// they follow from the distance from the contact surface.
  std::optional<int> interface_halvings = {};
  MeshGeometry geometry = MeshGeometry::block; ///< for gmsh
  /// Edge length of a cell [m].
  Quantity size_at_contact{1.0, ReferenceUnit::spacing};
  Quantity size_far{0.1, ReferenceUnit::length};    ///< far from the contact
                                                    ///< surface [m]
  Quantity fine_radius{0.1, ReferenceUnit::length}; ///< for indentation [m]
  std::string file;                                 ///< as in MaterialVariation
  double file_unit = 1.0; ///< metres per unit of the file
  /// Empty: a meshed counter-body is the mirror image of the block.
  std::optional<CounterMeshSpec> counter = {};
};

} // namespace asperity::mechanics
