#include "robustness/written_case.hpp"

#include "base/special_numbers.hpp"
#include "robustness/kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace asperity::robustness {
namespace {

/// The numbers of a case that a flaw may spoil, in SI units except those in
/// units of h.
struct CaseNumbers {
  double length = 0.0;
  double contact_modulus = 0.0;
  double poisson_ratio = 0.0;
  double thickness = 0.0;
  double growth = 0.0;
  double penalty = 0.0;
  double tolerance = relative_tolerance;
  bool has_elements = false;
  bool is_slab = false;
  bool by_pressure = true;
  mechanics::ContactLaw law = mechanics::ContactLaw::hard;
  std::vector<double> loads;
};

CaseNumbers numbers_of(const Instance& instance) {
  CaseNumbers numbers{.length = instance.length,
                      .contact_modulus = instance.contact_modulus,
                      .poisson_ratio = instance.poisson_ratio,
                      .thickness = instance.thickness * instance.length,
                      .growth = instance.growth,
                      .law = instance.law,
                      .loads = {}};
  numbers.penalty =
      instance.penalty * instance.contact_modulus / instance.spacing();
  numbers.has_elements = instance.family == Family::condensed_q1 ||
                         instance.family == Family::condensed_q2 ||
                         instance.family == Family::full_block;
  numbers.is_slab = instance.family == Family::slab;
  numbers.by_pressure =
      instance.control == mechanics::Control::nominal_pressure;
  const double scale = surface_of(instance, grid_of(instance)).height_scale;
  for (const mechanics::LoadTarget& target : targets_of(instance, scale))
    numbers.loads.push_back(target.amount);
  return numbers;
}

/// Applies flaws of the loads and of the interface.
void spoil_contact(Flaw flaw, CaseNumbers& numbers) {
  switch (flaw) {
  case Flaw::zero_load:
    numbers.loads[0] = 0.0;
    break;
  case Flaw::negative_load:
    numbers.loads[0] *= -1.0;
    break;
  case Flaw::infinite_load:
    numbers.loads[0] = infinity;
    break;
  case Flaw::nan_load:
    numbers.loads[0] = not_a_number;
    break;
  case Flaw::closed_contact_gap:
    numbers.law = mechanics::ContactLaw::hard;
    numbers.by_pressure = false;
    numbers.loads = {0.0};
    break;
  case Flaw::zero_penalty:
    numbers.penalty = 0.0;
    break;
  case Flaw::infinite_penalty:
    numbers.penalty = infinity;
    break;
  case Flaw::nan_penalty:
    numbers.penalty = not_a_number;
    break;
  case Flaw::zero_tolerance:
    numbers.tolerance = 0.0;
    break;
  case Flaw::nan_tolerance:
    numbers.tolerance = not_a_number;
    break;
  default:
    break;
  }
}

/// Applies flaws of the block; some have an effect only with finite elements or
/// a slab.
void spoil_block(const Instance& instance, CaseNumbers& numbers) {
  switch (instance.flaw) {
  case Flaw::zero_modulus:
    numbers.contact_modulus = 0.0;
    break;
  case Flaw::nan_modulus:
    numbers.contact_modulus = not_a_number;
    break;
  case Flaw::infinite_modulus:
    numbers.contact_modulus = infinity;
    break;
  case Flaw::nan_in_case:
    numbers.length = not_a_number;
    break;
  case Flaw::nan_poisson_ratio:
    numbers.is_slab = true;
    numbers.poisson_ratio = not_a_number;
    break;
  case Flaw::nan_thickness:
    numbers.is_slab = true;
    numbers.thickness = not_a_number;
    break;
  case Flaw::incompressible:
    numbers.has_elements = true;
    numbers.poisson_ratio = 0.5;
    break;
  case Flaw::shrinking_layers:
    numbers.has_elements = true;
    numbers.growth = 0.5;
    break;
  case Flaw::sliver:
    numbers.has_elements = true;
    numbers.thickness = 1.25 * instance.spacing();
    break;
  case Flaw::odd_q2_grid:
    numbers.has_elements = true;
    break;
  default:
    break;
  }
}

/// TOML requires a decimal point or an exponent in a float, which {} omits for
/// whole numbers.
std::string number(double value) {
  return fmt::format("{:.17e}", value);
}

int degree_of(const Instance& instance) {
  if (instance.family == Family::full_block)
    return instance.degree;
  return instance.family == Family::condensed_q1 ||
                 instance.flaw == Flaw::sliver
             ? 1
             : 2;
}

/// The coating uses the unspoilt thickness of the block.
std::string coating_text(const Instance& instance) {
  const double youngs_modulus =
      instance.contact_modulus *
      (1.0 - instance.poisson_ratio * instance.poisson_ratio);
  return fmt::format(
      "layers = [{{ thickness = {}, youngs_modulus = {}, poisson_ratio = {} "
      "}}]\n",
      number(instance.coating_thickness * instance.thickness * instance.length),
      number(instance.coating_stiffness * youngs_modulus),
      number(instance.poisson_ratio));
}

std::string method_text(const Instance& instance, const CaseNumbers& numbers) {
  std::string text;
  if (numbers.has_elements) {
    const int degree = degree_of(instance);
    const double depth =
        instance.flaw == Flaw::sliver
            ? 1.0
            : block_request(instance, grid_of(instance), degree, 1)
                  .settings.surface_cell_depth;
    text = fmt::format(
        "[fem]\nelement = \"Q{}\"\nsolver = \"{}\"\n"
        "surface_cell_depth = {}\ngrowth = {}\ndepth = {}\n",
        degree, instance.family == Family::full_block ? "full" : "condensed",
        number(depth), number(numbers.growth), number(numbers.thickness));
  } else {
    text = "[halfspace]\n";
    if (instance.has_free_boundaries)
      text += "boundaries = \"free\"\n";
    if (numbers.is_slab)
      text += "thickness = " + number(numbers.thickness) + "\n";
  }
  if (numbers.has_elements || numbers.is_slab)
    text += "top = \"" + name_of(instance.far_boundary) + "\"\n";
  text += "contact = \"" + name_of(numbers.law) + "\"\n";
  if (mechanics::needs_penalty(numbers.law))
    text += "penalty = " + number(numbers.penalty) + "\n";
  return text + "tolerance = " + number(numbers.tolerance) + "\n";
}

bool needs_penalty(Flaw flaw) {
  return flaw == Flaw::zero_penalty || flaw == Flaw::infinite_penalty ||
         flaw == Flaw::nan_penalty;
}

} // namespace

std::string map_text_of(const Instance& instance) {
  Instance wanted = instance;
  wanted.points += instance.flaw == Flaw::odd_q2_grid ? 1 : 0;
  const Grid grid = grid_of(wanted);
  std::vector<double> heights = surface_of(wanted, grid).map.heights;
  double& spoilt =
      heights[static_cast<std::size_t>(instance.index) % grid.size()];
  if (instance.flaw == Flaw::nan_height || instance.flaw == Flaw::nan_in_file)
    spoilt = not_a_number;
  if (instance.flaw == Flaw::infinite_height ||
      instance.flaw == Flaw::infinity_in_file)
    spoilt = instance.index % 3 == 0 ? -infinity : infinity;
  std::string text;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      text += fmt::format("{:.17e}{}", heights[grid.index(ix, iy)],
                          ix + 1 == grid.points_x ? '\n' : ' ');
  return text;
}

std::string case_text_of(const Instance& instance) {
  CaseNumbers numbers = numbers_of(instance);
  spoil_contact(instance.flaw, numbers);
  spoil_block(instance, numbers);
  if (needs_penalty(instance.flaw))
    numbers.law = mechanics::ContactLaw::penalty;
  std::vector<std::string> loads;
  for (const double load : numbers.loads)
    loads.push_back(number(load));
  return fmt::format(
      "schema = 1\ntitle = \"problem instance {}\"\n\n"
      "[surface]\nkind = \"measured\"\nfile = \"map.txt\"\n"
      "format = \"plain\"\nlevel = \"none\"\nedges = \"periodic\"\n"
      "fill = \"none\"\n"
      "height_unit = 1.0\nlength = {}\n\n"
      "[material]\ncontact_modulus = {}\npoisson_ratio = {}\n{}\n"
      "[load]\n{} = [{}]\n\n{}",
      instance.index, number(numbers.length), number(numbers.contact_modulus),
      number(numbers.poisson_ratio),
      numbers.has_elements && instance.flaw == Flaw::none &&
              instance.coating_stiffness != 1.0
          ? coating_text(instance)
          : "",
      numbers.by_pressure ? "nominal_pressure" : "mean_gap",
      fmt::join(loads, ", "), method_text(instance, numbers));
}

} // namespace asperity::robustness
