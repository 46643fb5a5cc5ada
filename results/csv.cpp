#include "results/csv.hpp"

#include "base/atomic_file.hpp"
#include "results/types/curve_columns.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

namespace asperity::results {
namespace {

/// Headers of the numerical columns between realization and status.
constexpr std::array number_headers{"step",
                                    "nominal_pressure [Pa]",
                                    "mean_gap [m]",
                                    "area_fraction [1]",
                                    "area_fraction_corrected [1]",
                                    "area_fraction_fit [1]",
                                    "area_fraction_moment [1]",
                                    "contact_perimeter [1/m]",
                                    "elastic_energy [J/m^2]",
                                    "contact_stiffness [Pa/m]",
                                    "iterations",
                                    "residual",
                                    "certified_gap_error [m]",
                                    "estimated_gap_error [m]"};

/// Headers of the columns after these, of a result in which some row has a
/// number in the first column of the group: of free boundaries, of a hardness,
/// of a block with a yield stress, of adhesion, of its jumps, of the flow
/// through the gap, of spots, of conductance, of the medium in the gap, and of
/// friction.
const std::vector<std::vector<const char*>> optional_headers{
    {"mean_displacement [m]"},
    {"plastic_work [J/m^2]", "plastic_strain [1]"},
    {"plastic_area [1]"},
    {"adhesive_energy [J/m^2]", "repulsive_area [1]", "tensile_area [1]",
     "smallest_stiffness [Pa/m]", "attractive_load [Pa]"},
    {"jump_pressure [Pa]", "jump_gap [m]"},
    {"flow_factor_x [1]", "flow_factor_y [1]", "flow_conductance_x [m^3]",
     "flow_conductance_y [m^3]", "critical_gap_x [m]", "critical_gap_y [m]",
     "leak_rate_x [m^3/s]", "leak_rate_y [m^3/s]", "effective_medium [m^3]"},
    {"spot_count [1]", "largest_spot [m^2]", "spot_dimension [1]",
     "spots_percolate_x [1]", "spots_percolate_y [1]", "spot_radii [1/m]",
     "gap_count [1]", "largest_gap [m^2]", "gap_dimension [1]",
     "gap_percolates_x [1]", "gap_percolates_y [1]"},
    {"relative_conductance [1/m]", "normal_stiffness [N/m]",
     "thermal_conductance [W/(m^2 K)]", "electrical_conductance [1/(Ohm m^2)]"},
    {"relative_gap_conductance [1/m]"},
    {"stick_stiffness_x [Pa/m]", "stick_stiffness_y [Pa/m]"}};

/// Headers of the times after step.
constexpr std::array time_headers{"cpu_time [s]", "transform_time [s]",
                                  "observation_time [s]"};

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos)
    return field;
  std::string text = "\"";
  for (const char letter : field)
    text += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return text + '"';
}

/// Returns the column that a header names before its unit.
const CurveColumn& headed_column(std::string_view header) {
  return curve_column(header.substr(0, header.find(' ')));
}

bool has_number(const Result& result, const CurveColumn& column) {
  for (const MethodRecord& method : result.methods)
    for (const Curve& curve : method.realizations)
      for (const CurvePoint& point : curve.points)
        if (std::isfinite(column.get(point)))
          return true;
  return false;
}

std::vector<const char*> numbers_of(const Result& result) {
  std::vector<const char*> headers(number_headers.begin(),
                                   number_headers.end());
  for (const std::vector<const char*>& group : optional_headers)
    if (has_number(result, headed_column(group.front())))
      headers.insert(headers.end(), group.begin(), group.end());
  return headers;
}

} // namespace

std::string curves_csv(const Result& result) {
  const std::vector<const char*> headers = numbers_of(result);
  std::string text = "method,realization";
  for (const char* header : headers)
    text += fmt::format(",{}", header);
  text += ",status\r\n";

  for (const MethodRecord& method : result.methods)
    for (std::size_t i = 0; i < method.realizations.size(); ++i)
      for (const CurvePoint& point : method.realizations[i].points) {
        text += fmt::format("{},{}", quoted(method.name), i);
        for (const char* header : headers)
          text += fmt::format(",{}", headed_column(header).get(point));
        text += fmt::format(",{}\r\n", status_word(point.status));
      }
  return text;
}

std::string times_csv(const Result& result) {
  std::string text = "method,realization,step";
  for (const char* header : time_headers)
    text += fmt::format(",{}", header);
  text += "\r\n";
  for (const MethodRecord& method : result.methods)
    for (std::size_t i = 0; i < method.realizations.size(); ++i) {
      const Curve& curve = method.realizations[i];
      text += fmt::format("{},{},,{},nan,nan\r\n", quoted(method.name), i,
                          curve.setup_cpu_time);
      for (const CurvePoint& point : curve.points) {
        text += fmt::format("{},{},{}", quoted(method.name), i, point.step);
        for (const char* header : time_headers)
          text += fmt::format(",{}", headed_column(header).get(point));
        text += "\r\n";
      }
    }
  return text;
}

void write_curves_csv(const Result& result, const std::filesystem::path& path) {
  write_file_atomically(path, curves_csv(result));
}

void write_times_csv(const Result& result, const std::filesystem::path& path) {
  write_file_atomically(path, times_csv(result));
}

} // namespace asperity::results
