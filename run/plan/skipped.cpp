#include "run/plan/skipped.hpp"

#include "input/types/omissions.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/surfaces_of_case.hpp"
#include "surfaces/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace asperity::run {
namespace {

using cases::MethodSpec;
using results::Skipped;

/// Collects the skipped work of all kinds in one list.
class Skips {
public:
  explicit Skips(const SelectedCase& selected) : selected_(selected) {}

  void add_methods_left_out();
  void add_surfaces();
  void add_maps();
  void add_of(const MethodSpec& method);
  void add_omissions(const MethodSpec& method);

  std::vector<Skipped> list;

private:
  double nodes() const { return static_cast<double>(selected_.grid.size()); }

  /// Returns the number of steps of a method on all its realisations.
  double all_steps(const MethodSpec& method) const {
    return static_cast<double>(selected_.contact_case.load.targets.size()) *
           methods::n_realizations(selected_.contact_case, method);
  }

  void add(std::string what, std::string why) {
    list.push_back({std::move(what), std::move(why)});
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
    add(method.name, "not selected by --methods");
  }
}

void Skips::add_surfaces() {
  if (methods::needs_surfaces(selected_.methods) || nodes() == 0.0)
    return;
  const int realizations = selected_.contact_case.surface.realizations;
  add(fmt::format("{} surface{}", realizations, realizations == 1 ? "" : "s"),
      "the theory uses the formula of the spectrum");
}

void Skips::add_maps() {
  const double kept = static_cast<double>(
      methods::steps_with_fields(selected_.contact_case).size());
  double left_out = 0.0;
  for (const MethodSpec& method : selected_.methods)
    if (method.has_fields())
      left_out += all_steps(method) - kept;
  if (left_out > 0.0)
    add(fmt::format("pressure and gap fields of {:g} steps", left_out),
        fmt::format("[report] fields saves {:g} of realisation 0", kept));
}

void Skips::add_of(const MethodSpec& method) {
  if (method.magnification)
    add(fmt::format("{}: roughness above {:g} q_0", method.name,
                    *method.magnification),
        "its magnification");
  add_realizations(method);
  std::visit([&](const auto& own) { add_of_settings(method, own); },
             method.settings);
}

/// What the case asks and the method has no answer to.
void Skips::add_omissions(const MethodSpec& method) {
  for (const cases::Omission& one :
       cases::omissions(selected_.contact_case, method))
    add(method.name + ": " + one.what, one.why);
}

void Skips::add_realizations(const MethodSpec& method) {
  const int omitted = selected_.contact_case.surface.realizations -
                      methods::n_realizations(selected_.contact_case, method);
  if (omitted == 0)
    return;
  add(fmt::format("{} on {} realisation{}", method.name, omitted,
                  omitted == 1 ? "" : "s"),
      method.needs_surface()
          ? "its number of realizations"
          : "the formula of the spectrum holds for every realisation");
}

void Skips::add_of_settings(const MethodSpec& method,
                            const mechanics::HalfspaceSettings& settings) {
  add(method.name + ": two tangential displacements per node",
      "the contact surface is frictionless and has no shear traction");
  add(method.name + ": the block below the contact surface",
      !settings.block().is_infinite()
          ? "the compliance of a slab has a closed form"
          : "no thickness is given: the compliance of a half-space "
            "has a closed form");
}

void Skips::add_of_settings(const MethodSpec& method,
                            const mechanics::FemSettings& settings) {
  if (settings.solver == mechanics::FemSolver::full)
    return;
  add(method.name + ": the displacements of the block",
      "laterally uniform: condensed to the normal displacement of the "
      "contact surface");
  if (selected_.grid.is_square() && !std::exchange(has_operator_, true))
    add(fmt::format("{}: {} of {} wavevectors of the operator", method.name,
                    count_text(0.375 * nodes()), count_text(0.5 * nodes())),
        "mirror images of the others");
}

void Skips::add_of_settings(const MethodSpec& method,
                            const mechanics::MdSettings& settings) {
  if (settings.bulk == mechanics::AtomBulk::green &&
      settings.engine == mechanics::AtomEngine::asperity)
    add(method.name + ": the atoms inside the block",
        "bulk = \"green\": condensed exactly to the lowest layer");
}

} // namespace

std::vector<Skipped> skipped_by_case(const SelectedCase& selected) {
  Skips skips(selected);
  skips.add_methods_left_out();
  skips.add_surfaces();
  skips.add_maps();
  for (const MethodSpec& method : selected.methods)
    skips.add_omissions(method);
  for (const MethodSpec& method : selected.methods)
    skips.add_of(method);
  return skips.list;
}

Grid grid_of_case(const cases::Case& contact_case,
                  const std::vector<MethodSpec>& methods) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (surface.length && surface.points)
    return {*surface.points, *surface.points, *surface.length, *surface.length};
  return methods::needs_surfaces(methods) ? surfaces::surface_grid(surface)
                                          : Grid{};
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

} // namespace asperity::run
