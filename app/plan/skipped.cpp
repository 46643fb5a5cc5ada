#include "app/plan/skipped.hpp"

#include "app/methods/chosen.hpp"
#include "app/methods/surfaces_of_case.hpp"
#include "app/plan/block_cost.hpp"
#include "base/special_numbers.hpp"
#include "surfaces/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::app {
namespace {

using cases::MethodSpec;
using results::Skipped;

/// Collects the skipped work of all kinds in one list.
class Skips {
public:
  Skips(const SelectedCase& selected, MachineRates& rates)
      : selected_(selected), rates_(rates) {}

  void add_methods_left_out();
  void add_surfaces();
  void add_maps();
  void add_of(const MethodSpec& method);

  std::vector<Skipped> list;

private:
  double n_steps() const {
    return static_cast<double>(selected_.contact_case.load.targets.size());
  }

  double nodes() const { return static_cast<double>(selected_.grid.size()); }

  /// Returns the number of steps of a method on all its realisations.
  double all_steps(const MethodSpec& method) const {
    return n_steps() * n_realizations(selected_.contact_case, method);
  }

  void add_realizations(const MethodSpec& method);

  void add_of_settings(const MethodSpec&, const mechanics::TheorySettings&) {}

  void add_of_settings(const MethodSpec& method,
                       const mechanics::HalfspaceSettings& settings);
  void add_of_settings(const MethodSpec& method,
                       const mechanics::FemSettings& settings);
  void add_of_settings(const MethodSpec& method,
                       const mechanics::MdSettings& settings);

  void add_of_settings(const MethodSpec&, const mechanics::WinklerSettings&) {}

  const SelectedCase& selected_;
  MachineRates& rates_;
  bool has_operator_ = false; ///< listed once, because the methods share the
                              ///< operator
};

void Skips::add_methods_left_out() {
  for (const MethodSpec& method : selected_.contact_case.methods) {
    const auto is_same = [&](const MethodSpec& chosen) {
      return chosen.name == method.name;
    };
    if (std::ranges::any_of(selected_.methods, is_same))
      continue;
    MethodCost cost{not_a_number, not_a_number, not_a_number, not_a_number};
    if (nodes() > 0.0)
      cost = cost_of(selected_.contact_case, method, selected_.grid, rates_);
    list.push_back({method.name, "not selected by --methods",
                    cost.setup_time + all_steps(method) * cost.step_time,
                    cost.memory});
  }
}

void Skips::add_surfaces() {
  if (needs_surfaces(selected_.methods) || nodes() == 0.0)
    return;
  const int realizations = selected_.contact_case.surface.realizations;
  list.push_back(
      {fmt::format("{} surface{}", realizations, realizations == 1 ? "" : "s"),
       "the theory uses the formula of the spectrum",
       3.0 * realizations * rates_.transform_time(selected_.grid),
       nodes() * realizations * sizeof(double)});
}

void Skips::add_maps() {
  const double kept =
      static_cast<double>(steps_with_fields(selected_.contact_case).size());
  double left_out = 0.0;
  for (const MethodSpec& method : selected_.methods)
    if (method.has_fields())
      left_out += all_steps(method) - kept;
  if (left_out > 0.0)
    list.push_back(
        {fmt::format("pressure and gap fields of {:g} steps", left_out),
         fmt::format("[report] fields saves {:g} of realisation 0", kept),
         not_a_number, left_out * map_bytes(selected_.grid)});
}

void Skips::add_of(const MethodSpec& method) {
  if (method.magnification)
    list.push_back({fmt::format("{}: roughness above {:g} q_0", method.name,
                                *method.magnification),
                    "its magnification", not_a_number, not_a_number});
  add_realizations(method);
  std::visit([&](const auto& own) { add_of_settings(method, own); },
             method.settings);
}

void Skips::add_realizations(const MethodSpec& method) {
  const int omitted = selected_.contact_case.surface.realizations -
                      n_realizations(selected_.contact_case, method);
  if (omitted == 0)
    return;
  const MethodCost cost =
      cost_of(selected_.contact_case, method, selected_.grid, rates_);
  list.push_back(
      {fmt::format("{} on {} realisation{}", method.name, omitted,
                   omitted == 1 ? "" : "s"),
       method.needs_surface()
           ? "its number of realizations"
           : "the formula of the spectrum holds for every realisation",
       omitted * (cost.setup_time + n_steps() * cost.step_time), 0.0});
}

void Skips::add_of_settings(const MethodSpec& method,
                            const mechanics::HalfspaceSettings& settings) {
  const MethodCost cost =
      cost_of(selected_.contact_case, method, selected_.grid, rates_);
  list.push_back(
      {fmt::format("{}: two tangential displacements per node", method.name),
       "the contact surface is frictionless and has no shear traction",
       2.0 * all_steps(method) * cost.step_time,
       2.0 * sizeof(double) * nodes()});
  list.push_back({method.name + ": the block below the contact surface",
                  settings.thickness
                      ? "the compliance of a slab has a closed form"
                      : "no thickness is given: the compliance of a half-space "
                        "has a closed form",
                  not_a_number, not_a_number});
}

void Skips::add_of_settings(const MethodSpec& method,
                            const mechanics::FemSettings& settings) {
  if (settings.solver == mechanics::FemSolver::full)
    return;
  const MethodCost full = cost_of_full_block(selected_.contact_case, settings,
                                             selected_.grid, rates_);
  list.push_back({fmt::format("{}: {} of {} displacements of the block",
                              method.name, count_text(full.unknowns - nodes()),
                              count_text(full.unknowns)),
                  "laterally uniform: condensed to the normal displacement of "
                  "the contact surface",
                  all_steps(method) * full.step_time, full.memory});
  const MethodCost cost =
      cost_of(selected_.contact_case, method, selected_.grid, rates_);
  if (selected_.grid.is_square() && !std::exchange(has_operator_, true))
    list.push_back(
        {fmt::format("{}: {} of {} wavevectors of the operator", method.name,
                     count_text(0.375 * nodes()), count_text(0.5 * nodes())),
         "mirror images of the others", 3.0 * cost.setup_time, 0.0});
}

void Skips::add_of_settings(const MethodSpec& method,
                            const mechanics::MdSettings& settings) {
  if (settings.bulk != mechanics::AtomBulk::green ||
      settings.engine != mechanics::AtomEngine::asperity)
    return;
  MethodSpec whole = method;
  auto& block = std::get<mechanics::MdSettings>(whole.settings);
  const double side = settings.atoms.value_or(selected_.grid.points_x);
  block.bulk = mechanics::AtomBulk::explicit_layers;
  block.levels = 1;
  block.layers =
      static_cast<int>(settings.depth.in_si({0.0, selected_.grid.length_x,
                                             selected_.grid.spacing_x(), 0.0}) /
                       selected_.grid.length_x * side);
  const MethodCost cost =
      cost_of(selected_.contact_case, whole, selected_.grid, rates_);
  list.push_back({fmt::format("{}: {} atoms inside the block", method.name,
                              count_text(cost.unknowns / 3.0 - side * side)),
                  "bulk = \"green\": condensed exactly to the lowest layer",
                  all_steps(method) * cost.step_time, cost.memory});
}

} // namespace

std::vector<Skipped> skipped_by_case(const SelectedCase& selected,
                                     MachineRates& rates) {
  Skips skips(selected, rates);
  skips.add_methods_left_out();
  skips.add_surfaces();
  skips.add_maps();
  for (const MethodSpec& method : selected.methods)
    skips.add_of(method);
  return skips.list;
}

Grid grid_of_case(const cases::Case& contact_case,
                  const std::vector<MethodSpec>& methods) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (surface.length && surface.points)
    return {*surface.points, *surface.points, *surface.length, *surface.length};
  return needs_surfaces(methods) ? surfaces::surface_grid(surface) : Grid{};
}

std::string count_text(double count) {
  if (count < 1e4)
    return fmt::format("{:.0f}", count);
  if (count < 1e6)
    return fmt::format("{:.0f}k", 1e-3 * count);
  if (count < 1e9)
    return fmt::format("{:.3g}M", 1e-6 * count);
  return fmt::format("{:.3g}", count);
}

} // namespace asperity::app
