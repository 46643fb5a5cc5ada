#pragma once

// The quantities that every method returns, and the contents of a result file.
// It defines the names of the observables and does not depend on any method.

#include "base/grid.hpp"
#include "results/types/map_in_cell.hpp"
#include "results/types/map_view.hpp"

#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity::results {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

enum class StepStatus { converged, not_converged };

class CurveColumn;

/// One load step, i.e. one row of the curve. The members are those of every
/// method; what else a method or a study has to say are numbers by column
/// (curve_columns.hpp): row[columns::leak_rate.x]. Numbers that a method does
/// not provide are NaN (the theory has no perimeter), counts are 0.
struct CurvePoint {
  int step = 0;                  ///< index in the loading path
  double nominal_pressure = 0.0; ///< p_0 [Pa]
  double mean_gap = 0.0;         ///< mean gap, penetration negative [m]
  double area_fraction = 0.0;    ///< nodes in contact; theory: Eq. (4) of Yang
                                 ///< and Persson (2008) [1]
  double area_fraction_corrected = 0.0; ///< estimate of the continuum [1]
  double contact_perimeter = 0.0;       ///< per nominal area [1/m]
  double elastic_energy = 0.0;    ///< of the block, per nominal area [J/m^2]
  double contact_energy = 0.0;    ///< of the penalty springs [J/m^2]
  double contact_stiffness = 0.0; ///< -dp_0/d(mean gap) >= 0 [Pa/m]
  int iterations = 0;
  double residual = 0.0; ///< error of complementarity, relative to h_rms [1]
  double cpu_time = 0.0; ///< [s]
  StepStatus status = StepStatus::converged;
  bool is_unloading = false;
  std::string note; ///< why it did not converge or an observable is NaN; or ""

  /// Adds a reason to the note.
  void add_note(const std::string& reason) {
    note += (note.empty() ? "" : "; ") + reason;
  }

  /// The number in a column; CurveColumn::blank() if the row has none.
  double operator[](const CurveColumn& column) const;

  /// The number in a column that is not a member, which the row now has; or a
  /// member of type double.
  /// @throws std::domain_error  the member is of another type
  double& operator[](const CurveColumn& column);

  /// The numbers that are not members, in the order in which they were set.
  const std::vector<std::pair<const CurveColumn*, double>>& others() const {
    return others_;
  }

private:
  friend class CurveColumn;
  std::vector<std::pair<const CurveColumn*, double>> others_;
};

/// Maps of one load step, each of size grid.size(). The grid is that of the
/// method, which may differ from that of the surface. Either the maps are in
/// memory, or they are in the file of the result.
struct Fields {
  int step = 0;
  double nominal_pressure = 0.0; ///< [Pa]
  std::vector<double> pressure;  ///< [Pa] >= 0 without adhesion
  std::vector<double> gap; ///< [m], negative where a penalty contact penetrates
                           ///< or atoms are closer than their contact distance
  Grid grid = {};
  StoredMap stored_pressure = {};
  StoredMap stored_gap = {};
  bool has_double_maps = false; ///< in the file; else in single precision
  MapInCell map = {};           ///< the user's map in these

  /// The maps, wherever they are; the fields must outlive the views.
  MapView pressure_map() const { return view_of(pressure, stored_pressure); }

  MapView gap_map() const { return view_of(gap, stored_gap); }

  /// The maps on the user's map, which are read from these; these must outlive
  /// the result.
  Fields on_map() const;
};

/// One bin of the isotropic spectrum of a map.
struct SpectrumPoint {
  double wavevector = 0.0; ///< q [rad/m]
  double spectrum = 0.0;   ///< C(q) [m^4]
};

/// The surface of one realisation with the statistics that the report prints.
struct SurfaceRecord {
  Grid grid;
  std::vector<double> heights; ///< [m], mean 0; empty if not saved
  double rms_height = 0.0;     ///< [m]
  double rms_slope = 0.0;      ///< both directions [1]
  double rms_curvature = 0.0;  ///< half the Laplacian [1/m]
  double skewness = 0.0;       ///< [1]
  double kurtosis = 0.0;       ///< 3 for a Gaussian [1]
  double highest = 0.0;        ///< max of the heights [m]
  std::vector<SpectrumPoint> spectrum;
  StoredMap stored_heights = {}; ///< if they are not in memory
  MapInCell map = {};            ///< the user's map in the grid

  /// The grid of the user's map.
  Grid map_grid() const { return map.grid(grid); }

  /// The heights of the user's map, which are read from these; this must
  /// outlive the result.
  StoredMap heights_of_map() const { return map.of(height_map(), grid); }

  /// The heights, wherever they are, or nothing; this must outlive the view.
  MapView height_map() const { return view_of(heights, stored_heights); }

  /// Whether the heights were saved, on the grid.
  bool has_heights() const {
    return !height_map().empty() && height_map().size() == grid.size();
  }
};

/// Results of one method for one realisation.
struct Curve {
  std::vector<CurvePoint> points;
  std::vector<Fields> fields;
  double setup_cpu_time = 0.0; ///< [s]
  /// The surface of the method, if it differs from that of the case: roughness
  /// beyond a magnification is omitted, or the grid is another one.
  std::optional<SurfaceRecord> own_surface = {};
};

struct MethodRecord {
  std::string name;                ///< "fem", "fem.hard", "theory", ...
  std::string kind;                ///< fem | halfspace | theory | md | ...
  std::string description;         ///< one line for the report
  std::vector<Curve> realizations; ///< one for a theory with a formula
  /// The field of its maps by which contact is decided: "pressure" or "gap",
  /// see mechanics::ContactField.
  std::string contact = "pressure";

  /// The rows of all realisations.
  std::vector<std::reference_wrapper<const CurvePoint>> rows() const {
    std::vector<std::reference_wrapper<const CurvePoint>> all;
    for (const Curve& curve : realizations)
      all.insert(all.end(), curve.points.begin(), curve.points.end());
    return all;
  }
};

/// One column of a table.
struct Column {
  std::string name; ///< as the name of a curve column: "mean_gap"
  std::string unit; ///< SI: "m"; "1" if dimensionless
  std::vector<double> values = {};
};

/// Results of a study other than a curve, in columns of equal length.
struct Table {
  std::string name;
  std::string title; ///< one line for the reader
  std::vector<Column> columns;

  /// Adds a row.
  /// @param row  as many numbers as there are columns
  void add(std::span<const double> row);

  void add(std::initializer_list<double> row) {
    add(std::span(row.begin(), row.size()));
  }

  /// Returns the values of a column; empty if there is no such column.
  std::vector<double> values(const std::string& column) const;
};

/// A computation that was skipped because it was not required.
struct Skipped {
  std::string what; ///< "fem, realization 2"
  std::string why;  ///< "all 16 steps are in the cache"
};

/// Provenance facts as key-value pairs, in the order of writing.
using Provenance = std::vector<std::pair<std::string, std::string>>;

struct Result {
  std::string path; ///< path from which it was read
  std::string case_name;
  std::string case_title;
  std::string case_text;
  std::string case_hash;
  std::string reference;        ///< text of the case's reference.csv, or empty
  std::string status;           ///< running | complete | interrupted
  double contact_modulus = 0.0; ///< E* [Pa]
  Provenance provenance;
  std::vector<SurfaceRecord> surfaces; ///< one per realisation; empty if only
                                       ///< theory formulas were evaluated
  std::vector<MethodRecord> methods;
  std::vector<Table> tables = {}; ///< in the order of the studies
  std::vector<Skipped> skipped = {};

  /// Return the table or the method of that name, or null if there is none.
  const Table* table(const std::string& name) const;
  const MethodRecord* method(const std::string& name) const;
};

} // namespace asperity::results
