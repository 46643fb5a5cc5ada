#include "studies/friction/friction.hpp"

#include "base/field_sums.hpp"
#include "contact/operators/wave_directions.hpp"
#include "contact/solvers/punch_stiffness.hpp"
#include "mechanics/partial_slip.hpp"
#include "results/observables/row_observer.hpp"
#include "run/methods/chosen.hpp"
#include "studies/friction/friction_study.hpp"

#include <cmath>

namespace asperity::studies {
namespace {

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
  observe("stick_stiffness_x", [&] { return stiffness(of.x); });
  observe("stick_stiffness_y", [&] { return stiffness(of.y); });
}

bool slips(const cases::Case& contact_case, const cases::MethodSpec& method) {
  return cases::has_partial_slip(method, contact_case.material);
}

} // namespace

const Study friction_study{.keys = friction_keys,
                           .pages = friction_pages,
                           .evaluate = evaluate_friction,
                           .memory = 150.0,
                           .is_for = slips};

} // namespace asperity::studies
