#include "studies/friction/friction.hpp"

#include "base/field_sums.hpp"
#include "contact/operators/wave_directions.hpp"
#include "contact/solvers/punch_stiffness.hpp"
#include "input/reader/bound_key.hpp"
#include "mechanics/partial_slip.hpp"
#include "results/observables/row_observer.hpp"
#include "run/methods/chosen.hpp"
#include "studies/key_checks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace asperity::studies {
namespace {

using cases::Case;
using cases::Dimension;
using cases::eg;
using cases::inside;
using cases::key;
using cases::MethodSpec;
using cases::needed;
using cases::positive;
using cases::TableReader;
using Friction = FrictionStudy;

/// Tangential over normal compliance along x and y [1].
/// @param local  share of the springs of a penalty in the normal compliance,
///               whose ratio is that of the mean over the directions
mechanics::Directions ratios(const mechanics::MaterialSpec& material,
                             double along_x, double local) {
  const double mean = mechanics::tangential_ratio(material);
  const double turned = std::isnan(along_x) // of a uniform pressure: none
                            ? 0.0
                            : (1.0 - local) *
                                  mechanics::tangential_anisotropy(material) *
                                  (along_x - 0.5);
  return {mean - turned, mean + turned};
}

/// Sets stick_stiffness_x and _y: the normal stiffness of the contact
/// (contact/solvers/punch_stiffness.hpp) over the ratio kappa of the tangential
/// compliance to the normal one, which follows from the directions of the waves
/// of the punch's pressure (contact/operators/wave_directions.hpp). The note of
/// the row says if all nodes are in contact, which has no finite one.
void evaluate_friction(const Step& step, results::CurvePoint& row) {
  const mechanics::MaterialSpec& material = step.contact_case.material;
  const auto* const law = methods::convex_contact(step.method);
  if (law == nullptr ||
      !cases::has_partial_slip(step.method, step.contact_case.material))
    return;
  const double compliance = law->in_si(step.surface.scales).local_compliance();
  const auto elasticity = step.elasticity();
  const contact::PunchStiffness normal = contact::punch_stiffness(
      *elasticity, step.nodes.contact_set(), compliance);
  const auto& q = normal.pressure;
  mechanics::Directions of;
  if (!q.empty())
    of = ratios(material,
                contact::energy_along_x(step.grid, q, elasticity->is_periodic(),
                                        step.threads),
                compliance * normal.stiffness * dot(q, q) /
                    static_cast<double>(q.size()));
  const auto stiffness = [&](double ratio) -> results::Observed {
    if (!normal.converged)
      return {results::Observed::none, "the linear solver did not converge"};
    if (std::isinf(normal.stiffness))
      return {results::Observed::none, "all nodes are in contact"};
    return q.empty() ? 0.0 : normal.stiffness / ratio;
  };
  results::RowObserver observe(row);
  observe(columns::stick_stiffness.x, [&] { return stiffness(of.x); });
  observe(columns::stick_stiffness.y, [&] { return stiffness(of.y); });
}

bool slips(const cases::Case& contact_case, const cases::MethodSpec& method) {
  return cases::has_partial_slip(method, contact_case.material);
}

cases::Table keys_of_friction() {
  return {
      .name = "friction",
      .when = "Optional; needs a [theory] or a [halfspace] without thickness, "
              "adhesion and hardness, and material.poisson_ratio.",
      .description =
          "Partial slip under a normal load and tangential loads up to "
          "sliding, from the lighter normal loads of the case "
          "(docs/numerics/friction.md).",
      .keys = {
          key<&Friction::coefficient>("coefficient", positive(),
                                      "Coefficient of friction mu.",
                                      needed("0.5")),
          key<&Friction::normal_load>(
              "normal_load",
              {Dimension::pressure,
               positive(),
               {mechanics::ReferenceUnit::contact_modulus,
                mechanics::ReferenceUnit::contact_modulus_times_slope}},
              "Normal load P over the nominal area. It becomes a load step, "
              "unless it is one.",
              eg("10 MPa", "default: the largest load")),
          key<&Friction::tangential_loads>(
              "tangential_load", inside(0.0, 1.0),
              "Tangential loads Q over that of sliding mu P. Each adds the "
              "load step P - Q/mu, unless the case has it.",
              eg("[0.5, 0.9]",
                 "default: those that belong to the loads of the case")),
      }};
}

/// Whether the loads are nominal pressures that rise.
bool has_rising_loads(const mechanics::LoadingPath& load) {
  return load.control == mechanics::Control::nominal_pressure &&
         !load.targets.empty() &&
         std::ranges::none_of(load.is_unloading, std::identity()) &&
         std::ranges::is_sorted(load.targets, {}, &mechanics::Quantity::value);
}

/// A pressure in the unit of the loads; nothing if that needs the surface.
std::optional<mechanics::Quantity> like_loads(const mechanics::Quantity& load,
                                              const Case& read) {
  const mechanics::ReferenceUnit unit = read.load.targets.back().reference;
  if (load.reference == unit)
    return load;
  using mechanics::ReferenceUnit;
  if (load.reference == ReferenceUnit::contact_modulus_times_slope ||
      unit == ReferenceUnit::contact_modulus_times_slope ||
      !(read.material.contact_modulus > 0.0))
    return {};
  const mechanics::Scales scales{.contact_modulus =
                                     read.material.contact_modulus};
  const double one = mechanics::Quantity{1.0, unit}.in_si(scales);
  return mechanics::Quantity{load.in_si(scales) / one, unit};
}

/// Adds a load step, unless there is one: before the first larger load.
void add_step(mechanics::LoadingPath& load, const mechanics::Quantity& step) {
  constexpr double same = 1e-12;
  auto next = load.targets.begin();
  while (next != load.targets.end() && next->value < step.value * (1.0 - same))
    ++next;
  if (next != load.targets.end() && next->value <= step.value * (1.0 + same))
    return;
  load.targets.insert(next, step);
  load.is_unloading.push_back(false);
}

/// The steps of this load and of the lighter one nearest to its half.
std::vector<std::size_t> steps_of_traction(const mechanics::LoadingPath& load,
                                           double full) {
  std::size_t pressed = 0;
  while (pressed + 1 < load.targets.size() &&
         load.targets[pressed].value < full)
    ++pressed;
  if (pressed == 0)
    return {};
  std::size_t eased = 0;
  for (std::size_t i = 1; i < pressed; ++i)
    if (std::abs(load.targets[i].value - 0.5 * full) <
        std::abs(load.targets[eased].value - 0.5 * full))
      eased = i;
  return {eased, pressed};
}

/// Adds the load steps of the normal load and of the tangential loads.
void add_friction_steps(TableReader& table, FrictionStudy& study, Case& read) {
  for (const char* const key : {"normal_load", "tangential_load"})
    if (table.has(key) && !has_rising_loads(read.load)) {
      table.refuse(table.said_by(key),
                   "needs a [load] by nominal pressures that only rise");
      return;
    }
  if (!has_rising_loads(read.load))
    return;
  mechanics::Quantity full = read.load.targets.back();
  if (study.normal_load) {
    const auto own = like_loads(*study.normal_load, read);
    if (!own) {
      table.refuse(table.said_by("normal_load"),
                   "must be in E* h' where the loads are, and only there: the "
                   "slope h' of the surface is not known before the run");
      return;
    }
    full = *own;
    add_step(read.load, full);
  }
  for (const mechanics::Quantity& share : study.tangential_loads)
    add_step(read.load, {full.value * (1.0 - share.value), full.reference});
  study.map_steps = steps_of_traction(read.load, full.value * (1.0 - 1e-12));
}

void read_friction(TableReader table, Case& read) {
  FrictionStudy study;
  table.read(study);
  if (std::ranges::none_of(read.methods, [&](const MethodSpec& method) {
        return cases::has_partial_slip(method, read.material);
      }))
    table.complain(table.node(),
                   "needs a [theory] or a [halfspace] without thickness, "
                   "adhesion and hardness, on a uniform material");
  if (!read.material.poisson_ratio)
    table.complain(table.node(), "needs material.poisson_ratio");
  add_friction_steps(table, study, read);
  read.studies.ask(std::move(study));
}

std::string no_partial_slip(const Case& contact_case,
                            const MethodSpec& method) {
  return cases::obstacle_to_partial_slip(method, contact_case.material);
}

/// The answers of a step do not depend on the numbers of [friction].
std::string friction_key(const cases::Case&) {
  return "\nfriction";
}

std::vector<std::size_t> steps_of_friction(const Case& contact_case) {
  return contact_case.study<FrictionStudy>()->map_steps;
}

const cases::StudyKeys& friction_keys() {
  static const cases::StudyKeys keys{
      .tables = {keys_of_friction()},
      .read = read_friction,
      .is_asked = asks<FrictionStudy>,
      .questions = {{"[friction]", {}, asks<FrictionStudy>, no_partial_slip}},
      .step_key = friction_key,
      .saved_steps = steps_of_friction};
  return keys;
}

} // namespace

const Study friction_study{.keys = friction_keys,
                           .pages = friction_pages,
                           .evaluate = evaluate_friction,
                           .memory = 150.0,
                           .is_for = slips};

} // namespace asperity::studies
