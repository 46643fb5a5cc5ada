#include "results/types/curve_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace asperity::results {
namespace {

template <auto member>
using MemberType =
    std::remove_cvref_t<decltype(std::declval<CurvePoint>().*member)>;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double rounding = 1e-9; // of sums of weights whose mean is 1

constexpr ColumnRange any{-largest, largest};
constexpr ColumnRange needed{-largest, largest, true};
constexpr ColumnRange share{0.0, 1.0};

template <auto member>
constexpr CurveColumn column(std::string_view name, std::string_view unit,
                             const ColumnRange& range = not_negative,
                             Extent extent = Extent::intensive) {
  using Number = MemberType<member>;
  return {name,
          unit,
          range,
          !std::is_same_v<Number, double>,
          extent,
          [](const CurvePoint& point) {
            return static_cast<double>(point.*member);
          },
          [](CurvePoint& point, double number) {
            if constexpr (std::is_same_v<Number, double>)
              point.*member = number;
            else
              point.*member = static_cast<Number>(static_cast<int>(number));
          }};
}

constexpr std::array all_columns{
    column<&CurvePoint::step>("step", "1"),
    column<&CurvePoint::nominal_pressure>("nominal_pressure", "Pa", needed),
    column<&CurvePoint::mean_gap>("mean_gap", "m", needed),
    column<&CurvePoint::area_fraction>("area_fraction", "1", share),
    column<&CurvePoint::area_fraction_corrected>("area_fraction_corrected", "1",
                                                 share),
    column<&CurvePoint::area_fraction_fit>("area_fraction_fit", "1", share),
    column<&CurvePoint::area_fraction_moment>("area_fraction_moment", "1",
                                              share),
    column<&CurvePoint::contact_perimeter>("contact_perimeter", "1/m"),
    column<&CurvePoint::elastic_energy>("elastic_energy", "J/m^2", any),
    column<&CurvePoint::contact_energy>("contact_energy", "J/m^2", any),
    column<&CurvePoint::contact_stiffness>("contact_stiffness", "Pa/m", any),
    column<&CurvePoint::iterations>("iterations", "1"),
    column<&CurvePoint::residual>("residual", "1"),
    column<&CurvePoint::certified_gap_error>("certified_gap_error", "m"),
    column<&CurvePoint::estimated_gap_error>("estimated_gap_error", "m"),
    column<&CurvePoint::cpu_time>("cpu_time", "s"),
    column<&CurvePoint::transforms>("transforms", "1"),
    column<&CurvePoint::transform_time>("transform_time", "s"),
    column<&CurvePoint::observation_time>("observation_time", "s"),
    column<&CurvePoint::linear_iterations>("linear_iterations", "1"),
    column<&CurvePoint::preconditioner_setups>("preconditioner_setups", "1"),
    column<&CurvePoint::unknowns>("unknowns", "1"),
    column<&CurvePoint::memory>("memory", "bytes"),
    column<&CurvePoint::normal_stiffness>("normal_stiffness", "N/m",
                                          not_negative, Extent::extensive),
    column<&CurvePoint::tangential_stiffness>("tangential_stiffness", "N/m",
                                              not_negative, Extent::extensive),
    column<&CurvePoint::stick_stiffness_x>("stick_stiffness_x", "Pa/m"),
    column<&CurvePoint::stick_stiffness_y>("stick_stiffness_y", "Pa/m"),
    column<&CurvePoint::pressure_centre_x>("pressure_centre_x", "m", any),
    column<&CurvePoint::pressure_centre_y>("pressure_centre_y", "m", any),
    column<&CurvePoint::mean_displacement>("mean_displacement", "m", any),
    column<&CurvePoint::von_mises>("von_mises", "Pa"),
    column<&CurvePoint::von_mises_depth>("von_mises_depth", "m"),
    column<&CurvePoint::plastic_work>("plastic_work", "J/m^2"),
    column<&CurvePoint::plastic_strain>("plastic_strain", "1"),
    column<&CurvePoint::flow_factor_x>("flow_factor_x", "1"),
    column<&CurvePoint::flow_factor_y>("flow_factor_y", "1"),
    column<&CurvePoint::flow_conductance_x>("flow_conductance_x", "m^3"),
    column<&CurvePoint::flow_conductance_y>("flow_conductance_y", "m^3"),
    column<&CurvePoint::critical_gap_x>("critical_gap_x", "m"),
    column<&CurvePoint::critical_gap_y>("critical_gap_y", "m"),
    column<&CurvePoint::leak_rate_x>("leak_rate_x", "m^3/s"),
    column<&CurvePoint::leak_rate_y>("leak_rate_y", "m^3/s"),
    column<&CurvePoint::effective_medium>("effective_medium", "m^3"),
    column<&CurvePoint::spot_count>("spot_count", "1"),
    column<&CurvePoint::largest_spot>("largest_spot", "m^2"),
    column<&CurvePoint::spot_dimension>("spot_dimension", "1", any),
    column<&CurvePoint::spots_percolate_x>("spots_percolate_x", "1", share),
    column<&CurvePoint::spots_percolate_y>("spots_percolate_y", "1", share),
    column<&CurvePoint::spot_radii>("spot_radii", "1/m"),
    column<&CurvePoint::gap_count>("gap_count", "1"),
    column<&CurvePoint::largest_gap>("largest_gap", "m^2"),
    column<&CurvePoint::gap_dimension>("gap_dimension", "1", any),
    column<&CurvePoint::gap_percolates_x>("gap_percolates_x", "1", share),
    column<&CurvePoint::gap_percolates_y>("gap_percolates_y", "1", share),
    column<&CurvePoint::relative_conductance>("relative_conductance", "1/m"),
    column<&CurvePoint::relative_gap_conductance>("relative_gap_conductance",
                                                  "1/m"),
    column<&CurvePoint::thermal_conductance>("thermal_conductance",
                                             "W/(m^2 K)"),
    column<&CurvePoint::electrical_conductance>("electrical_conductance",
                                                "1/(Ohm m^2)"),
    column<&CurvePoint::adhesive_energy>("adhesive_energy", "J/m^2", any),
    column<&CurvePoint::repulsive_area>("repulsive_area", "1", share),
    column<&CurvePoint::tensile_area>("tensile_area", "1", share),
    column<&CurvePoint::smallest_stiffness>("smallest_stiffness", "Pa/m", any),
    column<&CurvePoint::attractive_load>("attractive_load", "Pa"),
    column<&CurvePoint::jump_pressure>("jump_pressure", "Pa", any),
    column<&CurvePoint::jump_gap>("jump_gap", "m", any),
    column<&CurvePoint::plastic_area>("plastic_area", "1", share),
    column<&CurvePoint::status>("status", "0 converged, 1 not_converged",
                                share),
    column<&CurvePoint::is_unloading>("is_unloading", "1", share),
};

} // namespace

bool ColumnRange::holds(double number) const {
  const double allowed = highest == 1.0 ? rounding : 0.0;
  return number >= lowest - allowed && number <= highest + allowed;
}

std::string ColumnRange::text() const {
  if (highest < largest)
    return fmt::format("must lie between {} and {}", lowest, highest);
  return lowest == 0.0 ? "must be finite and >= 0" : "must be finite";
}

std::span<const CurveColumn> curve_columns() {
  return all_columns;
}

const CurveColumn* find_curve_column(std::string_view name) {
  const auto found =
      std::find_if(all_columns.begin(), all_columns.end(),
                   [&](const CurveColumn& one) { return one.name == name; });
  return found == all_columns.end() ? nullptr : &*found;
}

const CurveColumn& curve_column(std::string_view name) {
  if (const CurveColumn* found = find_curve_column(name))
    return *found;
  throw std::domain_error("a curve has no column " + std::string(name));
}

void state_of_map(CurvePoint& row, double share) {
  for (const CurveColumn& one : all_columns)
    if (one.extent == Extent::extensive)
      one.set(row, share * one.get(row));
}

std::string_view status_word(StepStatus status) {
  return status == StepStatus::converged ? "converged" : "not_converged";
}

} // namespace asperity::results
