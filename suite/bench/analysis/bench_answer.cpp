#include "suite/bench/analysis/bench_answer.hpp"

#include "input/types/quantity_at_load.hpp"
#include "reports/analysis/exact.hpp"
#include "reports/analysis/summary.hpp"
#include "results/types/curve_columns.hpp"
#include "results/types/map_view.hpp"
#include "theory/exact/hertz.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace asperity::bench {
namespace {

using mechanics::SurfaceKind;
using results::CurvePoint;

/// Returns the columns of a curve that are compared at each load.
std::vector<const results::CurveColumn*>
compared_columns(mechanics::Control control) {
  const std::string other =
      control == mechanics::Control::mean_gap ? "nominal_pressure" : "mean_gap";
  std::vector<const results::CurveColumn*> compared;
  for (const results::CurveColumn& column : results::curve_columns())
    if (column.name == other || column.name == "elastic_energy" ||
        is_area(std::string(column.name)))
      compared.push_back(&column);
  return compared;
}

/// True for gamma, kappa and the quantities that the case expects. A deviation
/// or an error is excluded because it already is a difference, with respect to
/// something else.
bool is_compared(const std::string& quantity, const cases::Case& contact_case) {
  for (const char* ending : {"_error", "_deviation", "_difference"})
    if (quantity.ends_with(ending))
      return false;
  if (quantity.find("excess") != std::string::npos ||
      quantity == "iterations_max" || quantity == "penetration")
    return false;
  return quantity == "gamma_slope" || quantity == "kappa" ||
         std::any_of(contact_case.expectations.begin(),
                     contact_case.expectations.end(),
                     [&](const cases::Expectation& one) {
                       return one.quantity == quantity;
                     });
}

void add_fits(const results::Result& result, const cases::Case& contact_case,
              const std::string& method, BenchAnswer& answer) {
  const reports::Summary summary = reports::summarize(result, contact_case);
  for (const reports::MethodSummary& one : summary.methods)
    if (one.name == method)
      for (const auto& [name, estimate] : one.quantities)
        if (is_compared(name, contact_case) && !estimate.is_input)
          answer.values[name] = {estimate.value};
}

/// Returns the mean absolute difference of each saved contact pressure from
/// that of Hertz, over the mean pressure [1].
std::vector<double> hertz_differences(const results::Curve& curve,
                                      const cases::Case& contact_case,
                                      bool is_free) {
  std::vector<double> differences;
  differences.reserve(curve.fields.size());
  for (const results::Fields& fields : curve.fields) {
    const Grid& grid = fields.grid;
    const theory::HertzContact hertz = reports::sphere_contact(
        contact_case.surface, contact_case.material.contact_modulus,
        fields.nominal_pressure * grid.length_x * grid.length_y, is_free);
    double difference = 0.0, expected = 0.0; // sums
    const auto columns = static_cast<std::size_t>(grid.points_x);
    const int middle_x = grid.points_x / 2; // the sphere's node
    const int middle_y = grid.points_y / 2;
    results::each_piece(
        std::array{fields.pressure_map()},
        [&](std::size_t first, const auto& values) {
          double piece_difference = 0.0, piece_expected = 0.0;
          for (std::size_t k = 0; k < values[0].size(); ++k) {
            const std::size_t row = (first + k) / columns;
            const std::size_t column = (first + k) % columns;
            const double x =
                (static_cast<double>(column) - middle_x) * grid.spacing_x();
            const double y =
                (static_cast<double>(row) - middle_y) * grid.spacing_y();
            const double hertzian =
                theory::hertz_pressure(hertz, std::hypot(x, y));
            piece_expected += hertzian;
            piece_difference += std::abs(values[0][k] - hertzian);
          }
          expected += piece_expected;
          difference += piece_difference;
        });
    differences.push_back(difference / expected);
  }
  return differences;
}

/// Integrates U(p) from the exact mean gap, whose derivative may be singular at
/// either end.
double exact_energy(const mechanics::SurfaceSpec& surface,
                    double contact_modulus, double nominal_pressure,
                    double highest) {
  const auto gap = [&](double pressure) {
    return reports::exact_point(surface, contact_modulus, pressure, highest,
                                false)
        .mean_gap;
  };
  const double last = gap(nominal_pressure);
  if (!std::isfinite(last))
    return not_a_number;
  boost::math::quadrature::tanh_sinh<double> rule;
  return nominal_pressure *
         rule.integrate(
             [&](double share) { return gap(share * nominal_pressure) - last; },
             0.0, 1.0, 1e-10);
}

/// How many methods of a case have free boundaries.
enum class FreeMethods { none, some, all };

FreeMethods free_methods(const cases::Case& contact_case) {
  const auto is_free = [](const cases::MethodSpec& method) {
    const auto* half =
        std::get_if<mechanics::HalfspaceSettings>(&method.settings);
    return half != nullptr && half->block().is_free();
  };
  return std::ranges::all_of(contact_case.methods, is_free) ? FreeMethods::all
         : std::ranges::any_of(contact_case.methods, is_free)
             ? FreeMethods::some
             : FreeMethods::none;
}

} // namespace

BenchAnswer answer_of(const results::Result& result,
                      const cases::Case& contact_case,
                      const std::string& name) {
  const results::MethodRecord* const found = result.method(name);
  if (found == nullptr)
    throw std::domain_error("the result has no method " + name);
  const results::MethodRecord& method = *found;
  BenchAnswer answer;
  for (const CurvePoint& row : method.rows()) {
    if (row.is_unloading)
      continue;
    const bool has_answer = row.status == results::StepStatus::converged;
    answer.pressure.push_back(row.nominal_pressure);
    for (const results::CurveColumn* const column :
         compared_columns(contact_case.load.control))
      answer.values[std::string(column->name)].push_back(
          has_answer ? column->get(row) : not_a_number);
  }
  if (const auto* surface = reports::surface_of(result, method, 0)) {
    answer.rms_height = surface->rms_height;
    answer.highest = surface->highest;
  }
  // On a grid, the mean plane of a sphere depends on the spacing, but its
  // highest point does not.
  if (contact_case.surface.kind == SurfaceKind::sphere)
    for (double& gap : answer.values["mean_gap"])
      gap -= answer.highest;
  if (contact_case.surface.kind == SurfaceKind::sphere &&
      (method.kind == "fem" || method.kind == "halfspace"))
    for (const results::Curve& curve : method.realizations)
      for (const double difference : hertz_differences(
               curve, contact_case,
               reports::has_free_boundaries(contact_case, method)))
        answer.values[pressure_field].push_back(difference);
  if (!reports::has_exact_curve(contact_case))
    add_fits(result, contact_case, name, answer);
  return answer;
}

bool have_same_bits(const BenchAnswer& one, const BenchAnswer& other) {
  if (one.values.size() != other.values.size())
    return false;
  for (const auto& [name, values] : one.values) {
    const auto found = other.values.find(name);
    if (found == other.values.end() || found->second.size() != values.size() ||
        std::memcmp(found->second.data(), values.data(),
                    values.size() * sizeof(double)) != 0)
      return false;
  }
  return true;
}

std::vector<double> scale_of(const std::string& quantity,
                             const BenchAnswer& reference) {
  const auto found = reference.values.find(quantity);
  if (found == reference.values.end())
    return {};
  std::vector<double> scale = found->second;
  for (double& one : scale)
    one = quantity == "mean_gap"       ? reference.rms_height
          : quantity == pressure_field ? 1.0
                                       : std::abs(one);
  return scale;
}

double error_against(const BenchAnswer& reference, const BenchAnswer& answer,
                     const std::string& quantity) {
  const std::string column =
      is_area(quantity) && !reference.values.contains(quantity)
          ? "area_fraction_corrected"
          : quantity;
  const auto expected = reference.values.find(column);
  const auto found = answer.values.find(quantity);
  if (expected == reference.values.end() || found == answer.values.end() ||
      expected->second.size() != found->second.size())
    return not_a_number;
  return reports::rms_difference(found->second, expected->second,
                                 scale_of(column, reference));
}

BenchAnswer exact_answer(const cases::Case& contact_case,
                         const BenchAnswer& answer) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  const double contact_modulus = contact_case.material.contact_modulus;
  BenchAnswer exact;
  exact.rms_height = answer.rms_height;
  exact.pressure = answer.pressure;
  if (!reports::has_exact_curve(contact_case))
    return exact;
  // For a sphere, gaps are measured from its highest point, see answer_of().
  const double top = surface.kind == SurfaceKind::sphere ? 0.0 : answer.highest;
  const FreeMethods free = free_methods(contact_case);
  const bool is_free = free == FreeMethods::all;
  if (const auto field = answer.values.find(pressure_field);
      field != answer.values.end())
    exact.values[pressure_field].assign(field->second.size(), 0.0);
  for (const double pressure : answer.pressure) {
    const reports::ExactPoint point =
        reports::exact_point(surface, contact_modulus, pressure, top, is_free);
    exact.values["area_fraction_corrected"].push_back(point.area_fraction);
    if (free == FreeMethods::some)
      continue; // mean gaps and energies have no common exact solution
    exact.values["mean_gap"].push_back(point.mean_gap);
    exact.values["elastic_energy"].push_back(
        is_free ? point.elastic_energy
                : exact_energy(surface, contact_modulus, pressure, top));
  }
  std::erase_if(exact.values, [](const auto& entry) {
    return entry.second.empty() || !all_finite(entry.second);
  });
  return exact;
}

bool TargetOutcome::is_met() const {
  return !checks.empty() &&
         std::all_of(checks.begin(), checks.end(),
                     [](const TargetCheck& check) { return check.is_met; });
}

double number_of(const std::map<std::string, double>& numbers,
                 const std::string& quantity) {
  const auto found = numbers.find(quantity);
  return found == numbers.end() ? not_a_number : found->second;
}

bool is_area(const std::string& quantity) {
  return quantity.starts_with("area_fraction") &&
         !cases::names_a_load(quantity);
}

std::string error_words(const std::string& quantity) {
  if (quantity == "mean_gap")
    return "mean gap u(p): root-mean-square error over the loads, in units of "
           "h_rms";
  if (quantity == "nominal_pressure")
    return "pressure p(u): relative root-mean-square error over the gaps";
  if (quantity == "elastic_energy")
    return "elastic energy: relative root-mean-square error over the loads";
  if (quantity == pressure_field)
    return "contact pressure p(x, y): mean absolute difference from the exact "
           "solution over the mean pressure, root mean square over the loads "
           "whose fields are saved";
  if (is_area(quantity))
    return "contact area A(p): relative root-mean-square error over the loads; "
           "estimator " +
           quantity;
  return quantity + ": relative error";
}

std::string exact_words(const cases::Case& contact_case) {
  if (!reports::has_exact_curve(contact_case))
    return "";
  switch (contact_case.surface.kind) {
  case SurfaceKind::sphere:
    return "Hertz's solution of an isolated contact, corrected for the mean "
           "displacement of its periodic images";
  case SurfaceKind::punch:
    return "the flat punch on a half-space, corrected for the mean "
           "displacement "
           "of its periodic images";
  case SurfaceKind::cone:
  case SurfaceKind::rounded_punch:
    return "the one indenter on a half-space, corrected for the mean "
           "displacement of its periodic images";
  case SurfaceKind::wave_1d:
    return "Westergaard's exact solution";
  case SurfaceKind::wave_2d:
    return "the exact asymptotic solutions for light and heavy load";
  default:
    return "";
  }
}

} // namespace asperity::bench
