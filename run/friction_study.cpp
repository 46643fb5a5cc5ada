#include "run/friction_study.hpp"

#include "base/field_sums.hpp"
#include "contact/operators/wave_directions.hpp"
#include "contact/solvers/punch_stiffness.hpp"
#include "mechanics/contact_nodes.hpp"
#include "mechanics/partial_slip.hpp"
#include "methods/chosen.hpp"
#include "results/observables/row_observer.hpp"

#include <cmath>
#include <string>

namespace asperity::run {
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

} // namespace

void add_stick_stiffness(const StudiedMethod& studied,
                         methods::StepAnswer& answer) {
  const mechanics::MaterialSpec& material = studied.contact_case.material;
  const auto* const law = methods::convex_contact(studied.method);
  results::CurvePoint& row = answer.row;
  if (row.status != results::StepStatus::converged || answer.gap.empty() ||
      law == nullptr || !cases::has_partial_slip(studied.method, material))
    return;
  const double compliance =
      law->in_si(studied.surface.scales).local_compliance();
  const auto elasticity = studied.solvers.operator_of(
      studied.method, studied.surface, studied.threads);
  const mechanics::ContactNodes nodes(
      studied.method.contact_criterion(studied.surface.scales.rms_height),
      answer.pressure, answer.gap);
  const contact::PunchStiffness normal =
      contact::punch_stiffness(*elasticity, nodes.contact_set(), compliance);
  const auto& q = normal.pressure;
  mechanics::Directions of;
  if (!q.empty())
    of = ratios(material,
                contact::energy_along_x(
                    answer.grid, q, elasticity->is_periodic(), studied.threads),
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

} // namespace asperity::run
