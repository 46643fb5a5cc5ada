#include "suite/bench/settings/bench_plan.hpp"

#include "input/input_error.hpp"
#include "suite/bench/settings/bench_axes.hpp"
#include "suite/bench/settings/block_settings.hpp"
#include "suite/bench/settings/case_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::bench {
namespace {

using cases::MethodSpec;

constexpr int least_points = 16;

/// From this number of points on, transforms of multiples of 16 take about half
/// the time per node of those of odd multiples of 2.
constexpr int large_points = 256;

/// True for 2^a 3^b 5^c, for which the FFT is fast.
bool transforms_well(int points) {
  for (const int factor : {2, 3, 5})
    while (points % factor == 0)
      points /= factor;
  return points == 1;
}

// points per side, below which N/2 is not meaningful
constexpr int axes_at_half_from = 256;

int even(double points) {
  return 2 * static_cast<int>(std::lround(points / 2.0));
}

std::string points_override(int points) {
  return fmt::format("{}={}", points_axis, points);
}

void append(std::vector<std::string> more, std::vector<std::string>& list) {
  list.insert(list.end(), more.begin(), more.end());
}

bool is_chosen(const MethodSpec& method,
               const std::vector<std::string>& names) {
  return names.empty() ||
         std::any_of(names.begin(), names.end(), [&](const std::string& name) {
           return name == method.name ||
                  name == cases::kind_of_method(method.name);
         });
}

/// Adds the orders that follow from the position of the contact boundary, which
/// the grid misplaces by a fraction of h: the counted area is of first order in
/// it; energy and mean gap are stationary. A penalty stiffness proportional to
/// E*/h is penetrated by p/k ~ h.
void add_theoretical_orders(const cases::Case& contact_case,
                            const std::string& method, BenchSeries& series) {
  const CaseValues values(contact_case);
  const auto contact = values.value(method, "contact");
  if (!contact)
    return;
  const auto penalty = values.value(method, "penalty");
  const bool is_penalized = contact->text == "penalty" && penalty &&
                            penalty->text.find("E*/h") != std::string::npos;
  const double order = is_penalized ? 1.0 : 2.0;
  series.theoretical_orders = {
      {"mean_gap", order}, {"elastic_energy", order}, {"area_fraction", 1.0}};
  series.order_source =
      is_penalized ? "penetration under a penalty stiffness ~ 1/h: first order"
                   : "the grid misplaces the contact boundary by a fraction of "
                     "h: the area is of first order; energy and gap are "
                     "stationary in it and of second order";
}

/// Returns the smallest even number of points per side that is not below
/// `least` and 16 and of the form 2^a 3^b 5^c, for which transforms are fast; a
/// multiple of 16 if `least` exceeds 256.
int transformable_points(int least) {
  const int step = least > large_points ? 16 : 2;
  int points = std::max(least_points, (least + step - 1) / step * step);
  while (!transforms_well(points))
    points += step;
  return points;
}

/// Returns the overrides that define a method "halfspace" as the elastic
/// half-space or slab, with hard contact, that corresponds to the case's block;
/// empty if the case already has this method.
std::vector<std::string> reference_overrides(const cases::Case& contact_case) {
  const CaseValues values(contact_case);
  const bool has_halfspace = std::any_of(
      contact_case.methods.begin(), contact_case.methods.end(),
      [](const MethodSpec& method) { return method.name == "halfspace"; });
  std::vector<std::string> overrides;
  const auto contact = values.value("halfspace", "contact");
  if (!has_halfspace || (contact && contact->text != "hard"))
    overrides.emplace_back("halfspace.contact=hard");
  if (has_halfspace)
    return overrides;
  for (const MethodSpec& method : contact_case.methods)
    if (cases::kind_of_method(method.name) == "fem") {
      overrides.push_back(
          "halfspace.thickness=" +
          scaled_value(*values.value(method.name, "depth"), 1.0));
      overrides.push_back("halfspace.top=" +
                          values.value(method.name, "top")->text);
      break;
    }
  return overrides;
}

/// Assembles the plan; a setting that two series share occurs once.
class Planner {
public:
  Planner(const cases::Case& contact_case, const BenchPlanOptions& options)
      : case_(contact_case),
        values_(contact_case),
        options_(options),
        own_points_(contact_case.surface.points.value_or(0)) {}

  BenchPlan plan() &&;

private:
  void add_reference();
  void add_points(const MethodSpec& method);
  void add_points(const AddedMethod& method);
  /// the overrides of other points than the case's
  std::vector<std::string> overrides_of(int points) const;
  void add_axes(const MethodSpec& method);
  void add_axis(const MethodSpec& method, const Axis& axis);
  std::size_t point(BenchPoint wanted);
  /// N/4, N/2, N, if they resolve the roughness
  std::vector<int> grids() const;
  int axis_points() const;

  const cases::Case& case_;
  CaseValues values_;
  const BenchPlanOptions& options_;
  int own_points_;
  BenchPlan plan_;
};

std::size_t Planner::point(BenchPoint wanted) {
  for (std::size_t i = 0; i < plan_.points.size(); ++i) {
    BenchPoint& known = plan_.points[i];
    if (known.method != wanted.method || known.overrides != wanted.overrides)
      continue;
    known.is_reference = known.is_reference && wanted.is_reference;
    known.is_own = known.is_own || wanted.is_own;
    return i;
  }
  plan_.points.push_back(std::move(wanted));
  return plan_.points.size() - 1;
}

std::vector<std::string> Planner::overrides_of(int points) const {
  std::vector<std::string> overrides;
  if (points == own_points_)
    return overrides;
  overrides.push_back(points_override(points));
  append(mesh_overrides(case_, points).value(), overrides);
  return overrides;
}

std::vector<int> Planner::grids() const {
  const int least = least_carrying_points(case_.surface);
  std::vector<int> kept;
  for (const double share : {0.25, 0.5}) {
    const int points = std::max(even(share * own_points_), least);
    if (mesh_overrides(case_, points) && 4 * points <= 3 * own_points_ &&
        (kept.empty() || points > kept.back()))
      kept.push_back(points);
  }
  kept.push_back(own_points_);
  return kept;
}

int Planner::axis_points() const {
  const std::vector<int> carried = grids();
  return own_points_ >= axes_at_half_from && carried.size() >= 2
             ? carried[carried.size() - 2]
             : own_points_;
}

void Planner::add_reference() {
  if (own_points_ == 0)
    return;
  const auto kind = case_.surface.kind;
  if (kind == mechanics::SurfaceKind::sphere ||
      (kind == mechanics::SurfaceKind::punch && case_.surface.tilt == 0.0) ||
      kind == mechanics::SurfaceKind::wave_1d)
    return; // all compared quantities have an exact solution
  BenchSeries series{.method = "halfspace",
                     .axis = points_axis,
                     .title = "points of the reference series"};
  const std::vector<std::string> overrides = reference_overrides(case_);
  std::vector<int> carried = grids();
  carried.push_back(2 * own_points_);
  for (const int points : carried) {
    BenchPoint wanted;
    wanted.method = wanted.kind = "halfspace";
    wanted.label = fmt::format("{} points", points);
    wanted.points = points;
    wanted.overrides = overrides;
    append(overrides_of(points), wanted.overrides);
    wanted.is_reference = true;
    series.points.push_back(point(std::move(wanted)));
    series.coordinates.push_back(1.0 / points);
  }
  plan_.reference_series = plan_.series.size();
  plan_.series.push_back(std::move(series));
}

void Planner::add_points(const MethodSpec& method) {
  add_points(AddedMethod{method.name, {}});
  for (const AddedMethod& same : same_block_methods(case_, method))
    add_points(same);
}

void Planner::add_points(const AddedMethod& method) {
  BenchSeries series{
      .method = method.name, .axis = points_axis, .title = "points per side"};
  const std::string kind = cases::kind_of_method(method.name);
  std::vector<int> carried = grids();
  if (!varies_with_points(kind) || own_points_ == 0)
    carried = {own_points_};
  for (const int points : carried) {
    BenchPoint wanted;
    wanted.method = method.name;
    wanted.kind = kind;
    wanted.is_elastic = varies_with_points(kind);
    wanted.points = points;
    wanted.label =
        points == 0 ? "as set in the case" : fmt::format("{} points", points);
    wanted.is_own = points == own_points_ && method.overrides.empty();
    wanted.overrides = method.overrides;
    append(overrides_of(points), wanted.overrides);
    series.points.push_back(point(std::move(wanted)));
    if (points > 0)
      series.coordinates.push_back(1.0 / points);
  }
  add_theoretical_orders(case_, method.name, series);
  if (series.points.size() > 1)
    plan_.series.push_back(std::move(series));
}

void Planner::add_axes(const MethodSpec& method) {
  const bool is_variant = method.name.find('.') != std::string::npos;
  const bool has_layers = !is_block_on_mesh(case_, method);
  for (const Axis& axis : axes_of(values_, method.name))
    if ((!is_variant || values_.is_set(method.name, axis.key)) &&
        (has_layers ||
         (axis.key != "growth" && axis.key != "surface_cell_depth")))
      add_axis(method, axis);
}

void Planner::add_axis(const MethodSpec& method, const Axis& axis) {
  BenchSeries series{.method = method.name,
                     .axis = method.name + "." + axis.key,
                     .title = axis.title,
                     .theoretical_orders = {{"mean_gap", axis.order},
                                            {"elastic_energy", axis.order}},
                     .order_source = axis.source};
  const std::string kind = cases::kind_of_method(method.name);
  const int points = varies_with_points(kind) ? axis_points() : own_points_;
  const std::string grid =
      points == 0 ? "" : fmt::format("{} points, ", points);
  for (const AxisValue& value : axis.values) {
    BenchPoint wanted;
    wanted.method = method.name;
    wanted.kind = kind;
    wanted.is_elastic = varies_with_points(kind);
    wanted.points = points;
    wanted.label = value.is_own
                       ? fmt::format("{} points", points)
                       : fmt::format("{}{} {}", grid, axis.title, value.text);
    wanted.is_own = value.is_own && points == own_points_;
    wanted.overrides = overrides_of(points);
    if (!value.is_own)
      wanted.overrides.push_back(series.axis + "=" + value.text);
    series.points.push_back(point(std::move(wanted)));
    if (std::isfinite(value.coordinate))
      series.coordinates.push_back(value.coordinate);
  }
  if (series.points.size() > 1)
    plan_.series.push_back(std::move(series));
}

BenchPlan Planner::plan() && {
  plan_.common = common_overrides(case_, options_.realizations);
  if (case_.surface.realizations > options_.realizations)
    plan_.remarks.push_back(
        fmt::format("{} of the case's {} realisations were run.",
                    options_.realizations, case_.surface.realizations));
  if (own_points_ > 0 && grids().size() < 3)
    plan_.remarks.push_back(fmt::format(
        "Grids below {} points per side do not resolve all of the roughness.",
        least_carrying_points(case_.surface)));
  add_reference();
  for (const MethodSpec& method : case_.methods)
    if (is_chosen(method, options_.methods))
      add_points(method);
  if (options_.is_quick)
    plan_.remarks.emplace_back(
        "Quick benchmark: only the number of points is varied.");
  else
    for (const MethodSpec& method : case_.methods)
      if (is_chosen(method, options_.methods))
        add_axes(method);
  if (!options_.is_quick && axis_points() != own_points_)
    plan_.remarks.push_back(
        fmt::format("Settings other than the number of points are varied at {} "
                    "points per side.",
                    axis_points()));
  return std::move(plan_);
}

} // namespace

int least_carrying_points(const mechanics::SurfaceSpec& surface) {
  if (!surface.length || !(surface.wavevector_high > 0.0))
    return least_points;
  constexpr double rounding = 1e-9;
  const double waves =
      surface.wavevector_high * *surface.length / (2.0 * std::numbers::pi);
  return transformable_points(
      2 * static_cast<int>(std::floor(waves * (1 + rounding))) + 2);
}

std::vector<std::string> common_overrides(const cases::Case& contact_case,
                                          int realizations) {
  std::vector<std::string> overrides;
  if (contact_case.surface.realizations > realizations)
    overrides.push_back(fmt::format("surface.realizations={}", realizations));
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (surface.length && surface.points)
    for (std::string& one :
         CaseValues(contact_case)
             .without_spacings(*surface.length / *surface.points))
      overrides.push_back(std::move(one));
  return overrides;
}

BenchPlan bench_plan_of(const cases::Case& contact_case,
                        const BenchPlanOptions& options) {
  for (const std::string& name : options.methods)
    if (std::none_of(contact_case.methods.begin(), contact_case.methods.end(),
                     [&](const MethodSpec& method) {
                       return is_chosen(method, {name});
                     }))
      throw input::InputError("--methods " + name + ": " + contact_case.path +
                              " has no such method");
  return Planner(contact_case, options).plan();
}

} // namespace asperity::bench
