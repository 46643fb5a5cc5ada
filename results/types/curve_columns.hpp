#pragma once

// The columns of a curve. A column is told once, where its owner defines it:
// the file of results, the journal and the cache, their checks, CSV files,
// comparisons and the reference page are derived from that.

#include "results/types/result.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace asperity::results {

/// Range of a number, including both ends. Ranges that end at 1 allow for a
/// roundoff error of 1e-9. NaN, "not determined", is allowed unless is_needed
/// is set.
struct ColumnRange {
  double lowest;
  double highest;
  bool is_needed = false; ///< finite in every converged step

  /// Returns "must lie between 0 and 1", "must be finite and >= 0" etc.
  std::string text() const;

  /// Returns whether the number is within the range; false for NaN.
  bool holds(double number) const;
};

inline constexpr double largest_number = std::numeric_limits<double>::max();
inline constexpr ColumnRange not_negative{0.0, largest_number};
inline constexpr ColumnRange any_number{-largest_number, largest_number};
inline constexpr ColumnRange needed_number{-largest_number, largest_number,
                                           true};
inline constexpr ColumnRange zero_to_one{0.0, 1.0};

/// Whether a number is the same for the user's map and for the cell that a
/// solver presses (map_in_cell.hpp), or in proportion to the area.
enum class Extent { intensive, extensive };

/// What a number says: an answer; how a solver came to it, which differs
/// between settings of equal accuracy; or what it cost, which differs between
/// two runs.
enum class ColumnUse { answer, solution, cost };

/// What the owner of a column says of it.
struct ColumnTraits {
  std::string_view name; ///< "mean_gap"; unique in the program
  std::string_view unit; ///< SI: "m"; "1" if dimensionless
  ColumnRange range = not_negative;
  /// What it is and when it is there, for the reference page; empty: told
  /// together with the column before it.
  std::string_view text = {};
  Extent extent = Extent::intensive;
  ColumnUse use = ColumnUse::answer;
  /// A count, of which 0 is the value of a row without it; otherwise NaN.
  bool is_integer = false;
};

/// A column of a curve, and its place in a row. An object of this type is
/// known to the program from its definition on (curve_columns()), and is the
/// only one with its name; it is identified by its address.
class CurveColumn : public ColumnTraits {
public:
  using Member =
      std::variant<std::monostate, double CurvePoint::*, int CurvePoint::*,
                   StepStatus CurvePoint::*, bool CurvePoint::*>;

  /// @param owner   whose column it is: "flow"; columns are in the order of
  ///                their owners, of which the rows of every method are first
  /// @param traits  texts must live as long as the program
  /// @param member  where it is in a row, for a column that every row has
  /// @throws std::logic_error  another column has the name
  CurveColumn(std::string_view owner, const ColumnTraits& traits,
              Member member = {});
  CurveColumn(const CurveColumn&) = delete;
  CurveColumn& operator=(const CurveColumn&) = delete;
  CurveColumn(CurveColumn&&) = delete;
  CurveColumn& operator=(CurveColumn&&) = delete;
  ~CurveColumn();

  /// Integers are converted to double exactly.
  double get(const CurvePoint& row) const;
  void set(CurvePoint& row, double number) const;

  std::string_view owner() const { return owner_; }

  /// The number of a row that does not have it.
  double blank() const { return is_integer ? 0.0 : not_given; }

private:
  friend struct CurvePoint;
  std::string_view owner_;
  Member member_;
};

/// A number along x and along y, in the columns "leak_rate_x" and
/// "leak_rate_y". The page says of the second "likewise along y".
class DirectedColumn {
public:
  /// @param traits  with the name of both; the text is that of x
  DirectedColumn(std::string_view owner, ColumnTraits traits);

  const CurveColumn& along(bool is_y) const { return is_y ? y : x; }

private:
  std::string name_x_, name_y_;

public:
  const CurveColumn x, y;
};

/// Returns all columns; `note` is not among them.
const std::vector<std::reference_wrapper<const CurveColumn>>& curve_columns();

/// Returns the column of that name, or null if there is none.
const CurveColumn* find_curve_column(std::string_view name);

/// Returns the column of that name.
/// @throws std::domain_error  there is none
const CurveColumn& curve_column(std::string_view name);

/// Returns docs/reference/columns.md: every column with its unit, its range and
/// what its owner says of it.
std::string columns_markdown();

/// Makes the extensive numbers of a row, which are those of the cell that a
/// solver presses, those of the user's map.
/// @param share  MapInCell::share() of the surface
void state_of_map(CurvePoint& row, double share);

/// Returns "converged" or "not_converged".
std::string_view status_word(StepStatus status);

} // namespace asperity::results

/// The columns of all owners are in this namespace.
namespace asperity::columns {

using results::ColumnUse;
using results::CurveColumn;
using results::CurvePoint;
using results::DirectedColumn;
using results::Extent;

// What every row has: members of CurvePoint.

inline const CurveColumn step{
    "",
    {.name = "step",
     .unit = "1",
     .text = "number of the load step (missing: the row)",
     .is_integer = true},
    &CurvePoint::step};

inline const CurveColumn nominal_pressure{"",
                                          {.name = "nominal_pressure",
                                           .unit = "Pa",
                                           .range = results::needed_number,
                                           .text = "load over nominal area"},
                                          &CurvePoint::nominal_pressure};

inline const CurveColumn mean_gap{
    "",
    {.name = "mean_gap",
     .unit = "m",
     .range = results::needed_number,
     .text = "mean gap, to which penetration contributes negative values"},
    &CurvePoint::mean_gap};

inline const CurveColumn area_fraction{
    "",
    {.name = "area_fraction",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "contact area as counted; theory: Eq. (4)"},
    &CurvePoint::area_fraction};

inline const CurveColumn area_fraction_corrected{
    "",
    {.name = "area_fraction_corrected",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "the best estimate of the contact area of the continuum"},
    &CurvePoint::area_fraction_corrected};

inline const CurveColumn contact_perimeter{
    "",
    {.name = "contact_perimeter", .unit = "1/m", .text = "per nominal area"},
    &CurvePoint::contact_perimeter};

inline const CurveColumn elastic_energy{
    "",
    {.name = "elastic_energy",
     .unit = "J/m^2",
     .range = results::any_number,
     .text = "of the block, per nominal area"},
    &CurvePoint::elastic_energy};

inline const CurveColumn contact_energy{
    "",
    {.name = "contact_energy",
     .unit = "J/m^2",
     .range = results::any_number,
     .text = "of the penalty springs, per nominal area"},
    &CurvePoint::contact_energy};

inline const CurveColumn contact_stiffness{"",
                                           {.name = "contact_stiffness",
                                            .unit = "Pa/m",
                                            .range = results::any_number,
                                            .text = "-dp/du"},
                                           &CurvePoint::contact_stiffness};

inline const CurveColumn iterations{"",
                                    {.name = "iterations",
                                     .unit = "1",
                                     .text = "of the contact iteration",
                                     .use = ColumnUse::solution,
                                     .is_integer = true},
                                    &CurvePoint::iterations};

inline const CurveColumn residual{
    "",
    {.name = "residual",
     .unit = "1",
     .text = "error of complementarity, relative to h_rms",
     .use = ColumnUse::solution},
    &CurvePoint::residual};

inline const CurveColumn cpu_time{"",
                                  {.name = "cpu_time",
                                   .unit = "s",
                                   .text = "of the step",
                                   .use = ColumnUse::cost},
                                  &CurvePoint::cpu_time};

inline const CurveColumn status{
    "",
    {.name = "status",
     .unit = "0 converged, 1 not_converged",
     .range = results::zero_to_one,
     .text = "0 converged, 1 not converged, also because the load, the "
             "mean gap or the balance of forces misses what was prescribed "
             "by more than [the "
             "tolerance](../numerics/solver.md#asked-and-reached)",
     .is_integer = true},
    &CurvePoint::status};

inline const CurveColumn is_unloading{
    "",
    {.name = "is_unloading",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "0 loading, 1 unloading: the way back of a cycle, and steps "
             "of a list lighter than an earlier one where a method depends "
             "on the path (adhesion, hardness, plastic flow, atoms)",
     .is_integer = true},
    &CurvePoint::is_unloading};

} // namespace asperity::columns
