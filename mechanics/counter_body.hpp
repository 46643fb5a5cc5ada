#pragma once

// The counter-body of [mesh.counter] in SI units, and what its numbers must
// satisfy.

#include "mechanics/mesh_spec.hpp"

#include <optional>
#include <string>

namespace asperity::mechanics {

/// A counter-body below the contact surface: it occupies z <= 0, its axis is
/// parallel to z, and its highest point or its flat end lies at z = 0.
struct CounterBody {
  CounterShape shape = CounterShape::sphere;
  double radius = 0.0; ///< of the ball or the cylinder, half the side of the
                       ///< cuboid [m] > 0
  double height = 0.0; ///< [m]; of a cap 0.25 to 1 times the radius
  double size_at_contact = 0.0; ///< of a cell in the fine region [m] > 0
  double size_far = 0.0;        ///< upper limit of the length of a cell along
                                ///< the way out [m] >= size_at_contact
  double fine_radius = 0.0;     ///< half the width of the fine region [m]
  double centre_x = 0.0;        ///< of the axis [m]
  double centre_y = 0.0;        ///< [m]
};

/// The block below whose contact surface the body lies.
struct OpposedBlock {
  double length_x = 0.0, length_y = 0.0; ///< [m]
  BlockSides sides = BlockSides::periodic;
  /// Smallest edge of its cells at the contact surface [m]; 0 if it is not
  /// known before the block is meshed.
  double edge = 0.0;
};

/// A number of a counter-body that cannot be.
struct CounterMistake {
  std::string key; ///< of [mesh.counter]
  double value = 0.0;
  std::string rule; ///< with its unit, "between 1 and 2 [m]"
};

/// The largest distance from the axis of a point of the body [m].
double half_width(const CounterBody& body);

/// The body below the centre of the block. Its size_at_contact is 0 if it
/// follows from an edge of the block's cells that is not known.
CounterBody counter_body_of(const CounterMeshSpec& spec, const Scales& scales,
                            const OpposedBlock& block);

/// The first number that contradicts another one of the body; empty if there is
/// none. Rules about a size_at_contact of 0 are left out.
std::optional<CounterMistake> mistake_in(const CounterBody& body);

/// The same for the body and the block: a body must lie within the block, and
/// its cells must not be finer than those of the block, whose nodes are those
/// that are tested for contact.
std::optional<CounterMistake> mistake_in(const CounterBody& body,
                                         const OpposedBlock& block);

} // namespace asperity::mechanics
