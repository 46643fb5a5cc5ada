#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <span>

#include "robustness/scene.hpp"

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
  return nth(std::array{"penalty", "hard", "augmented"}, law);
}

std::string name_of(mechanics::Control control) {
  return nth(std::array{"pressure", "gap"}, control);
}

std::string name_of(mechanics::FarBoundary top) {
  return nth(std::array{"clamped", "sliding", "pressure"}, top);
}

std::string name_of(Program program) {
  return nth(std::array{"increments", "jump", "cycle"}, program);
}

std::string name_of(Twin twin) {
  return nth(std::array{"none", "binary-units", "decimal-units", "threads"},
             twin);
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

std::string in_words(const Scene& scene) {
  std::string words = fmt::format(
      "seed {}, problem instance {}: {}, {} on {}^2 points, length {:.17g} m, "
      "H {:.17g}, roll-off at {:.17g} waves per side, shortest wave {:g} "
      "spacings, rms slope {:.17g}, E* {:.17g} Pa, nu {:g}, thickness {:.17g} "
      "lengths with the far boundary {}, grading ratio {:.17g}, ",
      scene.seed, scene.index, name_of(scene.family), name_of(scene.shape),
      scene.points, scene.length, scene.hurst, scene.roll_off,
      scene.shortest_wave, scene.rms_slope, scene.contact_modulus,
      scene.poisson_ratio, scene.thickness, name_of(scene.top), scene.growth);
  if (scene.has_free_boundaries)
    words += "free boundaries, ";
  if (scene.family == Family::full_block)
    words += fmt::format("Q{}, ", scene.degree);
  if (scene.coating_stiffness != 1.0)
    words +=
        fmt::format("a coating of {:.17g} block thicknesses and {:.17g} E, ",
                    scene.coating_thickness, scene.coating_stiffness);
  words += name_of(scene.law);
  if (scene.law != mechanics::ContactLaw::hard)
    words += fmt::format(" of {:.17g} E*/h", scene.penalty);
  words += scene.control == mechanics::Control::nominal_pressure
               ? fmt::format(", {} to {:.17g} E* h'", name_of(scene.program),
                             scene.load)
               : fmt::format(", {} to a mean gap of {:.17g} h_rms",
                             name_of(scene.program), scene.load);
  if (scene.family == Family::theory)
    words += fmt::format(", gamma {:.17g}", scene.gamma);
  if (scene.flaw != Flaw::none)
    words += ", flaw " + name_of(scene.flaw);
  if (scene.path != Path::library)
    words += ", path " + name_of(scene.path);
  return words + fmt::format(", metamorphic pair {}, {} threads",
                             name_of(scene.twin), scene.threads);
}

} // namespace asperity::robustness
