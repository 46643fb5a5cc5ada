#pragma once

// Contact with a Winkler foundation: independent linear springs, one under each
// node, without elastic coupling. Solved exactly, without iterations.

#include "contact/solvers/contact_problem.hpp"

#include <span>

namespace asperity::contact {

/// Solves a ContactProblem for C p = (p - <p>)/k: the
/// displacement of each spring less the uniform compression, so that the
/// displacement has mean 0 and the mean gap u is that of an elastic block with
/// the same pressure. The contact is hard: the pressure is k max(0, h - s) and
/// the gap max(0, s - h), with the level s = u - p_0/k of the unloaded springs.
///
/// The contact area is the bearing area at level s: the part of the surface
/// that is higher.
///
/// @param heights    h [m], finite, not empty
/// @param stiffness  k [Pa/m] > 0
/// @param target     p_0 [Pa] > 0, or the mean gap [m] > 0
/// @throws std::domain_error  a number is outside its range
/// @par Accuracy  exact to roundoff; one sort of the heights
/// @see  K. L. Johnson, Contact Mechanics (1985), section 4.3
ContactSolution winkler_contact(std::span<const double> heights,
                                double stiffness,
                                const mechanics::LoadTarget& target);

} // namespace asperity::contact
