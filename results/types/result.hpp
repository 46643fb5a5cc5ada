#pragma once

// The quantities that every method returns, and the contents of a result file.
// It defines the names of the observables and does not depend on any method.

#include "base/grid.hpp"
#include "results/types/map_in_cell.hpp"
#include "results/types/map_view.hpp"

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity::results {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

enum class StepStatus { converged, not_converged };

/// One load step, i.e. one row of the curve. Members that a method does not
/// provide are NaN (the theory has no perimeter) or 0 (iterations). Equations
/// are those of Yang and Persson (2008).
struct CurvePoint {
  int step = 0;                  ///< index in the loading path
  double nominal_pressure = 0.0; ///< p_0 [Pa]
  double mean_gap = 0.0;         ///< mean gap, penetration negative [m]
  double area_fraction = 0.0;    ///< nodes in contact; theory: Eq. (4) [1]
  double area_fraction_corrected = 0.0;    ///< estimate of the continuum [1]
  double area_fraction_fit = not_given;    ///< Eq. (21), fit to P(sigma) [1]
  double area_fraction_moment = not_given; ///< Eq. (21), from <sigma^2> [1]
  double contact_perimeter = 0.0;          ///< per nominal area [1/m]
  double elastic_energy = 0.0;    ///< of the block, per nominal area [J/m^2]
  double contact_energy = 0.0;    ///< of the penalty springs [J/m^2]
  double contact_stiffness = 0.0; ///< -dp_0/d(mean gap) >= 0 [Pa/m]
  int iterations = 0;
  double residual = 0.0; ///< error of complementarity, relative to h_rms [1]
  /// Bound of the error of mean_gap against the exact answer of the discrete
  /// problem [m]; NaN: the method has no certificate.
  double certified_gap_error = not_given;
  /// Estimate, no bound, of the error of mean_gap by the mesh of the full 3-D
  /// block [m]; NaN: another method, no contact, or not converged.
  double estimated_gap_error = not_given;
  double cpu_time = 0.0; ///< [s]
  int transforms = 0; ///< applications of the elastic operator or its inverse
                      ///< on the method's grid; 0: no such operator
  double transform_time = not_given;   ///< CPU time of all applications,
                                       ///< including those on coarser grids [s]
  double observation_time = not_given; ///< CPU time of areas, fits, energy [s]
  int linear_iterations = 0;           ///< of the linear solver, full 3-D block
  int preconditioner_setups = 0;       ///< or factorisations, likewise
  double unknowns = not_given;         ///< of the full 3-D block [1]
  double memory = not_given;           ///< matrix and preconditioner [bytes]
  /// Of the nodes in contact [N/m]; full 3-D block: against its clamped far
  /// boundary; surface methods: against the mean gap.
  double normal_stiffness = not_given;
  double tangential_stiffness = not_given; ///< likewise, nodes that stick [N/m]
  /// With [friction], per nominal area: tangential load over the displacement
  /// of far points along x and along y, if all of the contact sticks [Pa/m].
  double stick_stiffness_x = not_given;
  double stick_stiffness_y = not_given;
  /// Place of the resultant force from the middle of the surface [m]; NaN: the
  /// surface continues periodically and has no middle, or without contact.
  double pressure_centre_x = not_given;
  double pressure_centre_y = not_given;
  /// Mean displacement of the surface from far points [m]: the approach of far
  /// points changes by its change less that of mean_gap. NaN, stands for 0: the
  /// surface continues periodically, and displacements have no mean.
  double mean_displacement = not_given;
  double von_mises = not_given;       ///< maximum in the full 3-D block [Pa]
  double von_mises_depth = not_given; ///< depth of this maximum [m]
  /// The work of plastic flow so far, per nominal area [J/m^2]: of the full 3-D
  /// block with a yield stress, or of a hardness, over which it is the mean
  /// depth of the imprint; and the largest equivalent plastic strain.
  double plastic_work = not_given;
  double plastic_strain = not_given;
  /// Of the flow through the gap in x and y: phi and the flow of a square with
  /// 12 eta = Dp = 1 [m^3], the narrowest place of the widest path [m], the
  /// leak rate of the seal [m^3/s], and the flow of a square by the effective
  /// medium [m^3]. NaN: no flow was computed; all are 0 if open nodes do not
  /// join the sides. The theory has no directions: its flow is that of the
  /// effective medium, and its narrowest place u_1 where the open area
  /// percolates.
  double flow_factor_x = not_given;
  double flow_factor_y = not_given;
  double flow_conductance_x = not_given;
  double flow_conductance_y = not_given;
  double critical_gap_x = not_given;
  double critical_gap_y = not_given;
  double leak_rate_x = not_given;
  double leak_rate_y = not_given;
  double effective_medium = not_given;
  /// Of the clusters of contact and of the gap (observables/clusters.hpp):
  /// their number, the area of the largest [m^2], the dimension by area and
  /// perimeter, whether one goes around the map, and the sum of the radii of
  /// circles of the areas of the spots, per nominal area [1/m].
  double spot_count = not_given;
  double largest_spot = not_given;
  double spot_dimension = not_given;
  double spots_percolate_x = not_given;
  double spots_percolate_y = not_given;
  double spot_radii = not_given;
  double gap_count = not_given;
  double largest_gap = not_given;
  double gap_dimension = not_given;
  double gap_percolates_x = not_given;
  double gap_percolates_y = not_given;
  /// Of the spots of contact between two bodies, per nominal area: the
  /// conductance over the harmonic mean of the conductivities [1/m], what the
  /// medium in the gap adds to it, and the conductance of heat, with the
  /// medium [W/(m^2 K)], and of current [1/(Ohm m^2)].
  double relative_conductance = not_given;
  double relative_gap_conductance = not_given;
  double thermal_conductance = not_given;
  double electrical_conductance = not_given;
  /// Of laws with adhesion: <W(g)> <= 0 per nominal area [J/m^2]; nodes under
  /// pressure, and nodes in tension of at least 1 % of the law's largest [1];
  /// smallest eigenvalue of the energy's Hessian per area [Pa/m].
  double adhesive_energy = not_given;
  double repulsive_area = not_given;
  double tensile_area = not_given;
  double smallest_stiffness = not_given;
  double attractive_load = not_given; ///< mean of the tensions [Pa] >= 0
  /// If faces part or come together in this step: nominal pressure [Pa] and
  /// mean gap [m] of the last state before that, found by bisection.
  double jump_pressure = not_given;
  double jump_gap = not_given;
  /// Of a surface with a hardness: area at this pressure, a part of
  /// area_fraction [1].
  double plastic_area = not_given;
  StepStatus status = StepStatus::converged;
  bool is_unloading = false;
  std::string note; ///< why it did not converge or an observable is NaN; or ""
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
};

/// One column of a table.
struct Column {
  std::string name; ///< as the name of a curve column: "mean_gap"
  std::string unit; ///< SI: "m"; "1" if dimensionless
  std::vector<double> values;
};

/// Results of a study other than a curve, in columns of equal length.
struct Table {
  std::string name;
  std::string title; ///< one line for the reader
  std::vector<Column> columns;

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

  /// Returns the table of that name, or null if there is none.
  const Table* table(const std::string& name) const;
};

} // namespace asperity::results
