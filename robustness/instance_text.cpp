#include "robustness/instance.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace asperity::robustness {
namespace {

template <class Enum, std::size_t n>
std::string nth(const std::array<const char*, n>& names, Enum value) {
  return names.at(static_cast<std::size_t>(value));
}

} // namespace

std::string name_of(Family family) {
  return nth(std::array{"halfspace", "slab", "condensed-q1", "condensed-q2",
                        "full-block", "atoms", "theory", "flawed"},
             family);
}

std::string name_of(Shape shape) {
  return nth(std::array{"rough", "wave", "paraboloid", "spike", "step",
                        "sawtooth", "terraces", "checkerboard", "flat"},
             shape);
}

std::string name_of(mechanics::ContactLaw law) {
  return mechanics::traits_of(law).name;
}

std::string name_of(mechanics::Control control) {
  return nth(std::array{"pressure", "gap"}, control);
}

std::string name_of(mechanics::FarBoundary far_boundary) {
  return nth(std::array{"clamped", "sliding", "pressure"}, far_boundary);
}

std::string name_of(Program program) {
  return nth(std::array{"increments", "jump", "cycle"}, program);
}

std::string name_of(mechanics::LinearSolver linear_solver) {
  return nth(std::array{"auto", "direct", "multigrid"}, linear_solver);
}

std::string name_of(mechanics::MeshKind mesh) {
  return nth(std::array{"layers", "hanging", "adaptive", "gmsh"}, mesh);
}

std::string name_of(CounterBody counter) {
  return nth(std::array{"none", "sphere", "cylinder", "cuboid"}, counter);
}

std::string name_of(MetamorphicRelation relation) {
  return nth(std::array{"none", "binary-units", "decimal-units", "threads",
                        "direct-solver"},
             relation);
}

std::string name_of(Flaw flaw) {
  return nth(std::array{"none",
                        "nan-height",
                        "infinite-height",
                        "nan-in-file",
                        "infinity-in-file",
                        "nan-in-case",
                        "zero-load",
                        "negative-load",
                        "infinite-load",
                        "closed-wall-gap",
                        "zero-penalty",
                        "infinite-penalty",
                        "zero-modulus",
                        "incompressible",
                        "shrinking-layers",
                        "sliver",
                        "odd-q2-grid",
                        "zero-tolerance",
                        "nan-load",
                        "nan-modulus",
                        "nan-penalty",
                        "nan-tolerance",
                        "nan-thickness",
                        "nan-poisson-ratio",
                        "infinite-modulus"},
             flaw);
}

std::string name_of(Path path) {
  return nth(std::array{"library", "program", "report", "two-ranks"}, path);
}

std::string text_of(const Instance& instance) {
  std::string words = fmt::format(
      "seed {}, problem instance {}: {}, {} on {}^2 points, length {:.17g} m, "
      "H {:.17g}, roll-off at {:.17g} waves per side, shortest wave {:g} "
      "spacings, rms slope {:.17g}, E* {:.17g} Pa, nu {:g}, thickness {:.17g} "
      "lengths with the far boundary {}, grading ratio {:.17g}, ",
      instance.seed, instance.index, name_of(instance.family),
      name_of(instance.shape), instance.points, instance.length, instance.hurst,
      instance.roll_off, instance.shortest_wave, instance.rms_slope,
      instance.contact_modulus, instance.poisson_ratio, instance.thickness,
      name_of(instance.far_boundary), instance.growth);
  if (instance.has_free_boundaries)
    words += "free boundaries, ";
  if (instance.family == Family::full_block)
    words += fmt::format("Q{}, mesh {}, {} sides, solver {}, ", instance.degree,
                         name_of(instance.mesh),
                         instance.has_free_sides ? "free" : "periodic",
                         name_of(instance.linear_solver));
  if (instance.counter != CounterBody::none)
    words += fmt::format("on a {} of radius {:.17g} lengths and {:.17g} times "
                         "the modulus, ",
                         name_of(instance.counter), instance.counter_radius,
                         instance.counter_stiffness);
  if (instance.modulus_ratio != 1.0)
    words += fmt::format("moduli times {:.17g} to its inverse, ",
                         instance.modulus_ratio);
  if (instance.coating_stiffness != 1.0)
    words +=
        fmt::format("a coating of {:.17g} block thicknesses and {:.17g} E, ",
                    instance.coating_thickness, instance.coating_stiffness);
  words += name_of(instance.law);
  if (mechanics::needs_penalty(instance.law))
    words += fmt::format(" of {:.17g} E*/h", instance.penalty);
  if (mechanics::is_adhesive(instance.law))
    words += fmt::format(" of {:.17g} times the energy of conformity, with the "
                         "grid number {:.17g}",
                         instance.adhesion, instance.grid_number);
  words += instance.control == mechanics::Control::nominal_pressure
               ? fmt::format(", {} to {:.17g} E* h'", name_of(instance.program),
                             instance.load)
               : fmt::format(", {} to a mean gap of {:.17g} h_rms",
                             name_of(instance.program), instance.load);
  if (std::isfinite(instance.spring))
    words += fmt::format(" by a spring of {:.17g} k_c", instance.spring);
  if (instance.family == Family::theory)
    words += fmt::format(", gamma {:.17g}", instance.gamma);
  if (instance.flaw != Flaw::none)
    words += ", flaw " + name_of(instance.flaw);
  if (instance.path != Path::library)
    words += ", path " + name_of(instance.path);
  return words + fmt::format(", metamorphic pair {}, {} threads",
                             name_of(instance.relation), instance.threads);
}

} // namespace asperity::robustness
