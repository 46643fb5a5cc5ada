#include "mechanics/contact_law.hpp"

#include <fmt/format.h>

#include <array>
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

double no_range(const ContactInterface&) {
  return 0.0;
}

constexpr std::array all_laws{
    ContactLawTraits{ContactLaw::penalty, "penalty", "penalty", false, true,
                     SurfaceSolver::complementarity, BlockSolver::springs,
                     spring_energy, spring_pressure, spring_stiffness,
                     without_tension, no_range},
    ContactLawTraits{ContactLaw::hard, "hard", "hard (unilateral) contact",
                     true, false, SurfaceSolver::complementarity,
                     BlockSolver::wall, nothing, nothing, nothing,
                     without_tension, no_range},
    ContactLawTraits{ContactLaw::augmented, "augmented",
                     "augmented Lagrangian with a penalty of", true, true,
                     SurfaceSolver::multipliers, BlockSolver::springs, nothing,
                     nothing, nothing, without_tension, no_range},
};

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

double ContactInterface::local_compliance() const {
  return has_wall(law) ? 0.0 : 1.0 / penalty;
}

std::span<const ContactLawTraits> contact_laws() {
  return all_laws;
}

const ContactLawTraits& traits_of(ContactLaw law) {
  return all_laws.at(static_cast<std::size_t>(law));
}

std::vector<const char*> contact_law_names() {
  std::vector<const char*> names;
  names.reserve(all_laws.size());
  for (const ContactLawTraits& traits : all_laws)
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
  const PressureBounds bounds = traits.pressure_bounds(interface);
  if (bounds != PressureBounds{})
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

ContactInterface ContactSettings::in_si(const Scales& scales) const {
  return {law, needs_penalty(law) ? penalty.in_si(scales) : 0.0};
}

} // namespace asperity::mechanics
