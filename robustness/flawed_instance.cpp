#include "base/special_numbers.hpp"
#include "cases/reader/read_case.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "robustness/kinds.hpp"
#include "surfaces/formats/text/map_file.hpp"

namespace asperity::robustness {
namespace {

/// Spoils a property of the half-space or slab; a half-space has no thickness.
void spoil_block(Instance& instance) {
  switch (instance.flaw) {
  case Flaw::zero_modulus:
    instance.contact_modulus = 0.0;
    break;
  case Flaw::nan_modulus:
    instance.contact_modulus = not_a_number;
    break;
  case Flaw::infinite_modulus:
    instance.contact_modulus = infinity;
    break;
  case Flaw::nan_thickness:
    instance.family = Family::slab;
    instance.thickness = not_a_number;
    break;
  case Flaw::nan_poisson_ratio:
    instance.family = Family::slab;
    instance.poisson_ratio = not_a_number;
    break;
  default:
    break;
  }
}

/// Solves the contact problem of the instance with one of its numbers spoilt.
void solve_spoilt(Instance instance) {
  instance.family = instance.index % 2 == 0 ? Family::halfspace : Family::slab;
  const Grid grid = grid_of(instance);
  InstanceSurface surface = surface_of(instance, grid);
  double& spoilt_height =
      surface.map
          .heights[static_cast<std::size_t>(instance.index) % grid.size()];
  mechanics::ContactInterface interface {
    mechanics::ContactLaw::penalty,
        instance.penalty* instance.contact_modulus / grid.spacing_x()
  };
  double tolerance = relative_tolerance * surface.height_scale;
  mechanics::LoadTarget target{mechanics::Control::nominal_pressure,
                               instance.contact_modulus * instance.rms_slope};
  switch (instance.flaw) {
  case Flaw::nan_height:
    spoilt_height = not_a_number;
    break;
  case Flaw::infinite_height:
    spoilt_height = instance.index % 3 == 0 ? -infinity : infinity;
    break;
  case Flaw::zero_load:
    target.amount = 0.0;
    break;
  case Flaw::negative_load:
    target.amount = -target.amount;
    break;
  case Flaw::infinite_load:
    target.amount = infinity;
    break;
  case Flaw::closed_contact_gap:
    interface.law = mechanics::ContactLaw::hard;
    target = {mechanics::Control::mean_gap, 0.0};
    break;
  case Flaw::zero_penalty:
    interface.penalty = 0.0;
    break;
  case Flaw::infinite_penalty:
    interface.penalty = infinity;
    break;
  case Flaw::zero_tolerance:
    tolerance = 0.0;
    break;
  case Flaw::nan_load:
    target.amount = not_a_number;
    break;
  case Flaw::nan_penalty:
    interface.penalty = not_a_number;
    break;
  case Flaw::nan_tolerance:
    tolerance = not_a_number;
    break;
  default: // a flaw of the block: already in the instance
    break;
  }
  spoil_block(instance);
  contact::LoadSequence(operator_of(instance, grid, 1), surface.map.heights,
                        interface, tolerance, 100)
      .solve(target);
}

void build_spoilt_block(Instance instance) {
  instance.thickness = 1.0;
  if (instance.flaw == Flaw::sliver)
    // The interface of a coating would divide the layers.
    instance.coating_stiffness = 1.0;
  int degree = instance.index % 2 == 0 ? 1 : 2;
  Grid grid = grid_of(instance);
  if (instance.flaw == Flaw::odd_q2_grid) {
    degree = 2;
    grid = {instance.points + 1, instance.points + 1, instance.length,
            instance.length};
  }
  fem::BlockRequest request = block_request(instance, grid, degree, 1);
  if (instance.flaw == Flaw::incompressible)
    request.poisson_ratio = 0.5;
  if (instance.flaw == Flaw::shrinking_layers)
    request.settings.growth = 0.5;
  if (instance.flaw == Flaw::sliver)
    request.settings.depth = {1.25 * degree, mechanics::ReferenceUnit::spacing};
  fem::load_fem_module().condensed(request);
}

void read_spoilt_map(Flaw flaw) {
  surfaces::read_height_map_text(
      flaw == Flaw::nan_in_file ? "0 1 2\n3 nan 5\n6 7 8\n"
                                : "0 1 2\n3 4 inf\n6 7 8\n",
      "map.txt", mechanics::MapFormat::plain, {1e-6, 1e-9});
}

void read_spoilt_case() {
  cases::read_case_text("schema = 1\n[surface]\nkind = \"wave-1d\"\n"
                        "length = nan\npoints = 16\namplitude = \"1 nm\"\n"
                        "wavelength = \"1 length\"\n[material]\n"
                        "contact_modulus = \"1 GPa\"\n[load]\n"
                        "nominal_pressure = [\"0.1 E*\"]\n[halfspace]\n",
                        "spoilt/case.toml");
}

} // namespace

void run_flawed(const Instance& instance, InstanceReport& report) {
  switch (instance.flaw) {
  case Flaw::incompressible:
  case Flaw::shrinking_layers:
  case Flaw::sliver:
  case Flaw::odd_q2_grid:
    build_spoilt_block(instance);
    break;
  case Flaw::nan_in_file:
  case Flaw::infinity_in_file:
    read_spoilt_map(instance.flaw);
    break;
  case Flaw::nan_in_case:
    read_spoilt_case();
    break;
  default:
    solve_spoilt(instance);
    break;
  }
  fail(report, {"refusal", name_of(instance.flaw) + " was not refused"});
}

} // namespace asperity::robustness
