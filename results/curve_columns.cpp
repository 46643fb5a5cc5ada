#include "results/curve_columns.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace asperity::results {
namespace {

template <auto member>
using MemberType =
    std::remove_cvref_t<decltype(std::declval<CurvePoint>().*member)>;

template <auto member>
constexpr CurveColumn column(std::string_view name, std::string_view unit) {
  using Number = MemberType<member>;
  return {name, unit, !std::is_same_v<Number, double>,
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

constexpr std::array columns{
    column<&CurvePoint::step>("step", "1"),
    column<&CurvePoint::nominal_pressure>("nominal_pressure", "Pa"),
    column<&CurvePoint::mean_gap>("mean_gap", "m"),
    column<&CurvePoint::area_fraction>("area_fraction", "1"),
    column<&CurvePoint::area_fraction_corrected>("area_fraction_corrected",
                                                 "1"),
    column<&CurvePoint::area_fraction_fit>("area_fraction_fit", "1"),
    column<&CurvePoint::area_fraction_moment>("area_fraction_moment", "1"),
    column<&CurvePoint::contact_perimeter>("contact_perimeter", "1/m"),
    column<&CurvePoint::elastic_energy>("elastic_energy", "J/m^2"),
    column<&CurvePoint::contact_energy>("contact_energy", "J/m^2"),
    column<&CurvePoint::contact_stiffness>("contact_stiffness", "Pa/m"),
    column<&CurvePoint::iterations>("iterations", "1"),
    column<&CurvePoint::residual>("residual", "1"),
    column<&CurvePoint::cpu_time>("cpu_time", "s"),
    column<&CurvePoint::transforms>("transforms", "1"),
    column<&CurvePoint::transform_time>("transform_time", "s"),
    column<&CurvePoint::observation_time>("observation_time", "s"),
    column<&CurvePoint::linear_iterations>("linear_iterations", "1"),
    column<&CurvePoint::preconditioner_setups>("preconditioner_setups", "1"),
    column<&CurvePoint::unknowns>("unknowns", "1"),
    column<&CurvePoint::memory>("memory", "bytes"),
    column<&CurvePoint::von_mises>("von_mises", "Pa"),
    column<&CurvePoint::von_mises_depth>("von_mises_depth", "m"),
    column<&CurvePoint::status>("status", "0 converged, 1 not_converged"),
    column<&CurvePoint::is_unloading>("is_unloading", "1"),
};

} // namespace

std::span<const CurveColumn> curve_columns() {
  return columns;
}

const CurveColumn& curve_column(std::string_view name) {
  for (const CurveColumn& column : columns)
    if (column.name == name)
      return column;
  throw std::domain_error("a curve has no column " + std::string(name));
}

std::string_view status_word(StepStatus status) {
  return status == StepStatus::converged ? "converged" : "not_converged";
}

} // namespace asperity::results
