#pragma once

// The contact laws of block and counter-surface: what pressure acts at a gap,
// and which solver finds the contact. A law is a row of functions in the list
// of the .cpp, or a RegisteredLaw; docs/extending.md tells how to add one.

#include "mechanics/quantity.hpp"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::mechanics {

/// The number of a law in contact_laws(). The names are those of which other
/// files speak; a law needs none.
enum class ContactLaw {
  penalty,     ///< p = k * penetration
  hard,        ///< unilateral contact, complementarity conditions
  augmented,   ///< penalty, its multiplier updated until nothing penetrates
  exponential, ///< hard wall, attraction W = -w exp(-g/rho)
  dugdale,     ///< hard wall, uniform tension w/rho up to the gap rho
  cubic,       ///< hard wall, attraction W = -w (1 - g/rho)^3 up to the gap rho
  lennard_jones,        ///< no wall, W of a half-space of atoms, 9-3
  lennard_jones_layers, ///< no wall, W of two layers of atoms, 10-4
  morse,                ///< no wall, W = w (exp(-2g/rho) - 2 exp(-g/rho))
};

/// Pressures that a law admits [Pa]. The smallest one is negative for a law
/// with tension.
struct PressureBounds {
  double smallest = 0.0;
  double largest = std::numeric_limits<double>::infinity();

  bool operator==(const PressureBounds&) const = default;
};

/// A contact law with its parameters in SI units. Its energy per area W(g)
/// depends on the gap g [m], which is negative where the surfaces penetrate.
/// Laws with a wall admit no g < 0, where all three functions are infinite; at
/// g = 0, the wall carries any pressure above that of the law.
///
/// The laws with adhesion hold W(0) = -w, the work of adhesion of flat faces:
///
///     exponential  W = -w exp(-g/rho)            largest tension w/rho
///     dugdale      W = -w (1 - g/rho), g < rho   w/rho
///     cubic        W = -w (1 - g/rho)^3, g < rho 3 w/rho
///
/// and those without a wall, whose gap counts from the equilibrium of flat
/// faces, W'(0) = 0:
///
///     lennard-jones  W = -w (3 x^-3 - x^-9)/2, x = 1 + g/rho > 0
///                                                1.466 w/rho at .165 rho
///     lennard-jones-10-4  W = -w (5 x^-4 - 2 x^-10)/3
///                                                1.886 w/rho at .140 rho
///     morse          W = w (exp(-2g/rho) - 2 exp(-g/rho))
///                                                w/(2 rho) at rho ln 2
///
/// The exponential law is that of numerical work on rough contact, Dugdale's
/// that of the Maugis-Dugdale theory of a sphere. The cubic law is the lowest
/// power of 1 - g/rho whose tension and stiffness end without a jump. The 9-3
/// law is the 12-6 energy of pairs, summed over a half-space without structure,
/// and the 10-4 law that summed over a layer; rho is then the distance of the
/// faces in equilibrium.
/// @see  L. Pastewka, M. O. Robbins, PNAS 111, 3298 (2014); D. Maugis,
///       J. Colloid Interface Sci. 150, 243 (1992)
struct ContactInterface {
  ContactLaw law = ContactLaw::hard;
  double penalty = 0.0;          ///< k [Pa/m] > 0; not used by hard contact
  double work_of_adhesion = 0.0; ///< w [J/m^2] > 0, of laws with adhesion
  double adhesion_range = 0.0;   ///< rho [m] > 0, likewise
  /// H [Pa] > 0, of hard contact: the largest pressure, at which the surface
  /// yields and keeps an imprint.
  double hardness = std::numeric_limits<double>::infinity();
  /// d [m] in 0..rho, of Dugdale's law: its tension falls to zero linearly over
  /// the gaps rho - d to rho + d, see ContactSettings::in_si().
  double edge = 0.0;

  double energy(double gap) const;    ///< W [J/m^2], 0 at infinity
  double pressure(double gap) const;  ///< -W' [Pa]
  double stiffness(double gap) const; ///< W'' [Pa/m]
  PressureBounds pressure_bounds() const;
  double range() const; ///< smallest gap beyond which W = 0 [m] >= 0
  /// Gap below which W is infinite [m]: 0 with a wall, possibly -infinity.
  double least_gap() const;
  /// Gap of the largest tension [m], beyond which the tension falls; 0 for
  /// laws without tension.
  double strongest_gap() const;
  /// s^2 h/(w E*) of a law with adhesion, with its largest tension s: the
  /// spacing h of the grid over the length in which the tension acts at the
  /// edge of a contact [1].
  double grid_number(double contact_modulus, double spacing) const;
  /// Compliance 1/k [m/Pa] of a linear penalty; 0 for a law with a wall.
  double local_compliance() const;
};

/// The height statistics by which adhesion is judged.
struct Roughness {
  double rms_slope = 0.0;     ///< h', both directions [1] > 0
  double rms_curvature = 0.0; ///< of half the Laplacian [1/m] > 0
};

/// (w^2/(E*^2 kappa rho^3))^{1/3} with the rms curvature kappa: Tabor's
/// parameter of a peak with this curvature. Small: attraction acts around the
/// contact (DMT); large: within it (JKR).
double tabor_parameter(const ContactInterface& law, double contact_modulus,
                       const Roughness& roughness);

/// h' E* rho/(2 w) (h'^2/(h'' rho))^{2/3}, h'' = 2 kappa: below 1 the faces
/// stick, if the range is short against 16/3 h'^2/h''.
/// @see  L. Pastewka, M. O. Robbins, PNAS 111, 3298 (2014)
double stickiness(const ContactInterface& law, double contact_modulus,
                  const Roughness& roughness);

/// Grid number up to which adhesion is accurate, and from which on its numbers
/// are those of the grid.
inline constexpr double accurate_grid_number = 0.25;
inline constexpr double largest_grid_number = 1.0;

/// Solver of a surface operator: half-space, slab or condensed block.
enum class SurfaceSolver {
  none,
  complementarity, ///< contact/solvers/solver.hpp
  multipliers,     ///< solve_augmented() of contact/solvers/load_sequence.hpp
  adhesive,        ///< contact/solvers/adhesive.hpp
};

/// Solver of a meshed block (fem/newton/contact_newton.hpp).
enum class BlockSolver {
  none,
  wall,    ///< active set of nodes; neither Gauss points nor two bodies
  springs, ///< penalty, and multiplier updates if the law has a wall
};

/// What is known of a contact law without its parameters.
struct ContactLawTraits {
  const char* name = nullptr; ///< in cases
  const char* words =
      nullptr;           ///< in reports, before the penalty if it needs one
  bool has_wall = false; ///< whether its solution is free of penetration
  bool needs_penalty = false; ///< whether a case must give k
  SurfaceSolver surface_solver = SurfaceSolver::none;
  BlockSolver block_solver = BlockSolver::none;

  using Function = double (*)(const ContactInterface&, double gap);
  using OfLaw = double (*)(const ContactInterface&);
  /// Where the wall admits the gap.
  Function energy = nullptr, pressure = nullptr, stiffness = nullptr;
  PressureBounds (*pressure_bounds)(const ContactInterface&) = nullptr;
  OfLaw range = nullptr, least_gap = nullptr, strongest_gap = nullptr;
  ContactLaw law = {}; ///< its number, given by the list
};

/// A law that a file of its own adds to the list while this object exists. It
/// is made before other threads ask for laws and before the first case is read;
/// the one made last ends first.
class RegisteredLaw {
public:
  /// @throws std::out_of_range  there are 32 laws
  explicit RegisteredLaw(const ContactLawTraits& row);
  RegisteredLaw(const RegisteredLaw&) = delete;
  RegisteredLaw& operator=(const RegisteredLaw&) = delete;
  ~RegisteredLaw();

  operator ContactLaw() const { return law_; }

private:
  ContactLaw law_;
};

/// All contact laws.
std::span<const ContactLawTraits> contact_laws();

const ContactLawTraits& traits_of(ContactLaw law);

/// Names of all laws in cases.
std::vector<const char*> contact_law_names();

inline bool has_wall(ContactLaw law) {
  return traits_of(law).has_wall;
}

inline bool needs_penalty(ContactLaw law) {
  return traits_of(law).needs_penalty;
}

/// Whether a law is solved by a series of problems with a penalty.
inline bool needs_multipliers(ContactLaw law) {
  return has_wall(law) && needs_penalty(law);
}

/// Whether a law has a work of adhesion and a range.
inline bool is_adhesive(ContactLaw law) {
  return traits_of(law).surface_solver == SurfaceSolver::adhesive;
}

/// The solver of a law for surface operators. All but SurfaceSolver::adhesive
/// assume pressures >= 0, and all but SurfaceSolver::complementarity that they
/// have no upper bound.
/// @throws std::domain_error  no solver serves the law, or its pressures with
///         these parameters have other bounds
SurfaceSolver surface_solver_of(const ContactLawTraits& traits,
                                const ContactInterface& interface);

/// @throws std::domain_error  no solver of meshed blocks serves the law
BlockSolver block_solver_of(const ContactLawTraits& traits);

/// The contact law and its solver settings for an elastic method.
struct ContactSettings {
  ContactLaw law = ContactLaw::hard;
  Quantity penalty{100.0,
                   ReferenceUnit::contact_modulus_per_spacing}; ///< [Pa/m]
  double work_of_adhesion = 0.0; ///< w [J/m^2] > 0, of laws with adhesion
  /// rho [m] > 0, likewise; none: the shortest that the grid resolves, with
  /// ContactInterface::grid_number() = accurate_grid_number.
  std::optional<Quantity> range = {};
  std::optional<Quantity> hardness = {}; ///< H [Pa] > 0, of hard contact
  double tolerance = 1e-8; ///< of complementarity, relative to h_rms and p_0
  int max_iterations = 2000;

  ContactInterface in_si(const Scales& scales) const;
};

} // namespace asperity::mechanics
