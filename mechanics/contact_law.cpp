#include "mechanics/contact_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::mechanics {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double nothing(const ContactInterface&, double) {
  return 0.0;
}

/// W = k g^2 / 2 where g < 0
double spring_energy(const ContactInterface& own, double gap) {
  return gap < 0.0 ? 0.5 * own.penalty * gap * gap : 0.0;
}

double spring_pressure(const ContactInterface& own, double gap) {
  return gap < 0.0 ? -own.penalty * gap : 0.0;
}

double spring_stiffness(const ContactInterface& own, double gap) {
  return gap < 0.0 ? own.penalty : 0.0;
}

PressureBounds without_tension(const ContactInterface&) {
  return {};
}

PressureBounds up_to_hardness(const ContactInterface& own) {
  return {0.0, own.hardness};
}

double at_zero(const ContactInterface&) {
  return 0.0;
}

double at_no_gap(const ContactInterface&) {
  return -infinity;
}

double exponential_energy(const ContactInterface& own, double gap) {
  return -own.work_of_adhesion * std::exp(-gap / own.adhesion_range);
}

double exponential_pressure(const ContactInterface& own, double gap) {
  return exponential_energy(own, gap) / own.adhesion_range;
}

double exponential_stiffness(const ContactInterface& own, double gap) {
  return exponential_pressure(own, gap) / own.adhesion_range;
}

double everywhere(const ContactInterface&) {
  return infinity;
}

/// (rho + d - g)/(2 d), the share of the tension within the edge of Dugdale's
/// law; 1 before it and 0 behind it.
double dugdale_share(const ContactInterface& own, double gap) {
  const double behind = own.adhesion_range + own.edge - gap;
  return behind <= 0.0              ? 0.0
         : behind >= 2.0 * own.edge ? 1.0
                                    : behind / (2.0 * own.edge);
}

double dugdale_energy(const ContactInterface& own, double gap) {
  const double share = dugdale_share(own, gap);
  return share < 1.0 ? -own.work_of_adhesion * own.edge / own.adhesion_range *
                           share * share
                     : -own.work_of_adhesion * (1.0 - gap / own.adhesion_range);
}

double dugdale_pressure(const ContactInterface& own, double gap) {
  return -own.work_of_adhesion / own.adhesion_range * dugdale_share(own, gap);
}

double dugdale_stiffness(const ContactInterface& own, double gap) {
  const double share = dugdale_share(own, gap);
  return share > 0.0 && share < 1.0
             ? -own.work_of_adhesion / (2.0 * own.edge * own.adhesion_range)
             : 0.0;
}

double dugdale_range(const ContactInterface& own) {
  return own.adhesion_range + own.edge;
}

/// 1 - g/rho where g < rho
double depth_in_range(const ContactInterface& own, double gap) {
  return std::max(0.0, 1.0 - gap / own.adhesion_range);
}

double cubic_energy(const ContactInterface& own, double gap) {
  const double depth = depth_in_range(own, gap);
  return -own.work_of_adhesion * depth * depth * depth;
}

double cubic_pressure(const ContactInterface& own, double gap) {
  const double depth = depth_in_range(own, gap);
  return -3.0 * own.work_of_adhesion / own.adhesion_range * depth * depth;
}

double cubic_stiffness(const ContactInterface& own, double gap) {
  return -6.0 * own.work_of_adhesion /
         (own.adhesion_range * own.adhesion_range) * depth_in_range(own, gap);
}

double own_range(const ContactInterface& own) {
  return own.adhesion_range;
}

/// x = 1 + g/rho, the distance over that of equilibrium.
double lennard_jones_distance(const ContactInterface& own, double gap) {
  return 1.0 + gap / own.adhesion_range;
}

/// The power of a number with a constant exponent >= 0.
template <int exponent>
double power(double base) {
  if constexpr (exponent == 0)
    return 1.0;
  else {
    const double root = power<exponent / 2>(base);
    return exponent % 2 == 0 ? root * root : root * root * base;
  }
}

/// W = -w (m x^-n - n x^-m)/(m - n), m > n
template <int m, int n>
double lennard_jones_energy(const ContactInterface& own, double gap) {
  const double x = lennard_jones_distance(own, gap);
  if (!(x > 0.0))
    return infinity;
  return -own.work_of_adhesion / (m - n) *
         (m * power<n>(1.0 / x) - n * power<m>(1.0 / x));
}

template <int m, int n>
double lennard_jones_pressure(const ContactInterface& own, double gap) {
  const double x = lennard_jones_distance(own, gap);
  if (!(x > 0.0))
    return infinity;
  return own.work_of_adhesion / own.adhesion_range * m * n / (m - n) *
         (power<m + 1>(1.0 / x) - power<n + 1>(1.0 / x));
}

template <int m, int n>
double lennard_jones_stiffness(const ContactInterface& own, double gap) {
  const double x = lennard_jones_distance(own, gap);
  if (!(x > 0.0))
    return infinity;
  return own.work_of_adhesion / (own.adhesion_range * own.adhesion_range) * m *
         n / (m - n) *
         ((m + 1) * power<m + 2>(1.0 / x) - (n + 1) * power<n + 2>(1.0 / x));
}

double lennard_jones_core(const ContactInterface& own) {
  return -own.adhesion_range;
}

template <int m, int n>
double lennard_jones_strongest(const ContactInterface& own) {
  return own.adhesion_range *
         (std::pow((m + 1.0) / (n + 1.0), 1.0 / (m - n)) - 1.0);
}

double morse_energy(const ContactInterface& own, double gap) {
  const double decay = std::exp(-gap / own.adhesion_range);
  return own.work_of_adhesion * (decay - 2.0) * decay;
}

double morse_pressure(const ContactInterface& own, double gap) {
  const double decay = std::exp(-gap / own.adhesion_range);
  return 2.0 * own.work_of_adhesion / own.adhesion_range * (decay - 1.0) *
         decay;
}

double morse_stiffness(const ContactInterface& own, double gap) {
  const double decay = std::exp(-gap / own.adhesion_range);
  return 2.0 * own.work_of_adhesion /
         (own.adhesion_range * own.adhesion_range) * (2.0 * decay - 1.0) *
         decay;
}

double morse_strongest(const ContactInterface& own) {
  return own.adhesion_range * std::numbers::ln2;
}

/// The largest tension is that at a gap of the law.
template <ContactLawTraits::Function pressure,
          double (*strongest)(const ContactInterface&)>
PressureBounds tension_at(const ContactInterface& own) {
  return {pressure(own, strongest(own)), infinity};
}

template <int m, int n>
constexpr ContactLawTraits lennard_jones_row(const char* name,
                                             const char* words) {
  return {
      name,
      words,
      false,
      false,
      SurfaceSolver::adhesive,
      BlockSolver::none,
      lennard_jones_energy<m, n>,
      lennard_jones_pressure<m, n>,
      lennard_jones_stiffness<m, n>,
      tension_at<lennard_jones_pressure<m, n>, lennard_jones_strongest<m, n>>,
      everywhere,
      lennard_jones_core,
      lennard_jones_strongest<m, n>};
}

constexpr std::array own_laws{
    ContactLawTraits{"penalty", "penalty", false, true,
                     SurfaceSolver::complementarity, BlockSolver::springs,
                     spring_energy, spring_pressure, spring_stiffness,
                     without_tension, at_zero, at_no_gap, at_zero},
    ContactLawTraits{"hard", "hard (unilateral) contact", true, false,
                     SurfaceSolver::complementarity, BlockSolver::wall, nothing,
                     nothing, nothing, up_to_hardness, at_zero, at_zero,
                     at_zero},
    ContactLawTraits{"augmented", "augmented Lagrangian with a penalty of",
                     true, true, SurfaceSolver::multipliers,
                     BlockSolver::springs, nothing, nothing, nothing,
                     without_tension, at_zero, at_zero, at_zero},
    ContactLawTraits{"exponential", "a hard wall with exponential adhesion",
                     true, false, SurfaceSolver::adhesive, BlockSolver::none,
                     exponential_energy, exponential_pressure,
                     exponential_stiffness,
                     tension_at<exponential_pressure, at_zero>, everywhere,
                     at_zero, at_zero},
    ContactLawTraits{"dugdale", "a hard wall with Dugdale's adhesion", true,
                     false, SurfaceSolver::adhesive, BlockSolver::none,
                     dugdale_energy, dugdale_pressure, dugdale_stiffness,
                     tension_at<dugdale_pressure, at_zero>, dugdale_range,
                     at_zero, at_zero},
    ContactLawTraits{"cubic", "a hard wall with cubic adhesion", true, false,
                     SurfaceSolver::adhesive, BlockSolver::none, cubic_energy,
                     cubic_pressure, cubic_stiffness,
                     tension_at<cubic_pressure, at_zero>, own_range, at_zero,
                     at_zero},
    lennard_jones_row<9, 3>("lennard-jones",
                            "the Lennard-Jones law of half-spaces (9-3)"),
    lennard_jones_row<10, 4>(
        "lennard-jones-10-4",
        "the Lennard-Jones law of two layers of atoms (10-4)"),
    ContactLawTraits{"morse", "Morse's law", false, false,
                     SurfaceSolver::adhesive, BlockSolver::none, morse_energy,
                     morse_pressure, morse_stiffness,
                     tension_at<morse_pressure, morse_strongest>, everywhere,
                     at_no_gap, morse_strongest},
};

/// The laws, in the order of their numbers.
struct LawList {
  std::array<ContactLawTraits, 32> rows{};
  std::size_t count = 0;

  constexpr LawList() {
    for (const ContactLawTraits& law : own_laws)
      add(law);
  }

  constexpr ContactLaw add(ContactLawTraits law) {
    law.law = static_cast<ContactLaw>(count);
    rows.at(count++) = law;
    return law.law;
  }
};

constinit LawList all_laws;

double behind_wall(const ContactInterface& own, double gap,
                   ContactLawTraits::Function ContactLawTraits::*function) {
  const ContactLawTraits& traits = traits_of(own.law);
  return traits.has_wall && gap < 0.0 ? infinity : (traits.*function)(own, gap);
}

} // namespace

double ContactInterface::energy(double gap) const {
  return behind_wall(*this, gap, &ContactLawTraits::energy);
}

double ContactInterface::pressure(double gap) const {
  return behind_wall(*this, gap, &ContactLawTraits::pressure);
}

double ContactInterface::stiffness(double gap) const {
  return behind_wall(*this, gap, &ContactLawTraits::stiffness);
}

PressureBounds ContactInterface::pressure_bounds() const {
  return traits_of(law).pressure_bounds(*this);
}

double ContactInterface::range() const {
  return traits_of(law).range(*this);
}

double ContactInterface::least_gap() const {
  return traits_of(law).least_gap(*this);
}

double ContactInterface::strongest_gap() const {
  return traits_of(law).strongest_gap(*this);
}

double ContactInterface::local_compliance() const {
  return has_wall(law) || !needs_penalty(law) ? 0.0 : 1.0 / penalty;
}

std::span<const ContactLawTraits> contact_laws() {
  return std::span(all_laws.rows).first(all_laws.count);
}

RegisteredLaw::RegisteredLaw(const ContactLawTraits& row)
    : law_(all_laws.add(row)) {}

RegisteredLaw::~RegisteredLaw() {
  --all_laws.count;
}

const ContactLawTraits& traits_of(ContactLaw law) {
  return all_laws.rows.at(static_cast<std::size_t>(law));
}

std::vector<const char*> contact_law_names() {
  std::vector<const char*> names;
  for (const ContactLawTraits& traits : contact_laws())
    names.push_back(traits.name);
  return names;
}

SurfaceSolver surface_solver_of(const ContactLawTraits& traits,
                                const ContactInterface& interface) {
  if (traits.surface_solver == SurfaceSolver::none)
    throw std::domain_error(
        fmt::format("contact = {}: this law is not available for a half-space, "
                    "a slab or a condensed block",
                    traits.name));
  PressureBounds bounds = traits.pressure_bounds(interface);
  if (traits.surface_solver == SurfaceSolver::complementarity)
    bounds.largest = infinity;
  if (traits.surface_solver != SurfaceSolver::adhesive &&
      bounds != PressureBounds{})
    throw std::domain_error(fmt::format(
        "contact = {}: pressures from {:g} to {:g} Pa, but the solver of this "
        "law assumes that they are >= 0 without an upper bound",
        traits.name, bounds.smallest, bounds.largest));
  return traits.surface_solver;
}

BlockSolver block_solver_of(const ContactLawTraits& traits) {
  if (traits.block_solver == BlockSolver::none)
    throw std::domain_error(fmt::format(
        "contact = {}: this law is not available for a meshed block",
        traits.name));
  return traits.block_solver;
}

double ContactInterface::grid_number(double contact_modulus,
                                     double spacing) const {
  const double tension = pressure_bounds().smallest;
  return tension * tension * spacing / (work_of_adhesion * contact_modulus);
}

double tabor_parameter(const ContactInterface& law, double contact_modulus,
                       const Roughness& roughness) {
  const double length = law.work_of_adhesion / contact_modulus;
  return std::cbrt(length * length / roughness.rms_curvature) /
         law.adhesion_range;
}

double stickiness(const ContactInterface& law, double contact_modulus,
                  const Roughness& roughness) {
  const double slope = roughness.rms_slope;
  const double range = law.adhesion_range;
  return 0.5 * slope * contact_modulus * range / law.work_of_adhesion *
         std::pow(slope * slope / (2.0 * roughness.rms_curvature * range),
                  2.0 / 3.0);
}

ContactInterface ContactSettings::in_si(const Scales& scales) const {
  ContactInterface own{law};
  if (needs_penalty(law))
    own.penalty = penalty.in_si(scales);
  if (is_adhesive(law)) {
    own.work_of_adhesion = work_of_adhesion;
    own.adhesion_range = 1.0;
    const double unit =
        std::sqrt(own.grid_number(scales.contact_modulus, scales.spacing) /
                  accurate_grid_number);
    own.adhesion_range = range ? range->in_si(scales) : unit;
    if (law == ContactLaw::dugdale)
      own.edge =
          std::min(own.grid_number(scales.contact_modulus, scales.spacing),
                   1.0) *
          own.adhesion_range;
  }
  if (hardness)
    own.hardness = hardness->in_si(scales);
  return own;
}

} // namespace asperity::mechanics
