#pragma once

// What every method answers in, and what a result file holds once it is read.
// Owns the observables' names; nothing here knows which method it is.

#include "base/grid.hpp"

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity::results {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

enum class StepStatus { converged, not_converged };

/// One load step: a row of the curve. Fields a method does not have are NaN
/// (the theory has no perimeter) or 0 (iterations).
struct CurvePoint {
  int step = 0;                  ///< index in the load program
  double nominal_pressure = 0.0; ///< p_0 [Pa]
  double mean_gap = 0.0;         ///< mean of the gap, penetration negative [m]
  double area_fraction = 0.0;    ///< counted (theory: (4)) [1]
  double area_fraction_corrected = 0.0;    ///< best estimate of the limit [1]
  double area_fraction_fit = not_given;    ///< (21) of the fit to P(sigma) [1]
  double area_fraction_moment = not_given; ///< (21) of <sigma^2> [1]
  double contact_perimeter = 0.0;          ///< per nominal area [1/m]
  double elastic_energy = 0.0;    ///< in the block per nominal area [J/m^2]
  double contact_energy = 0.0;    ///< in the penalty springs [J/m^2]
  double contact_stiffness = 0.0; ///< -dp_0/d(mean gap) >= 0 [Pa/m]
  int iterations = 0;
  double residual = 0.0; ///< complementarity, relative to h_rms [1]
  double cpu_time = 0.0; ///< [s]
  int transforms = 0; ///< applications of the elastic operator or its inverse
                      ///< on the method's grid; 0: not by such an operator
  double transform_time = not_given;   ///< CPU time of all of them, those on
                                       ///< coarser grids among it [s]
  double observation_time = not_given; ///< CPU time of areas, fits and energy
                                       ///< once the step is solved [s]
  int linear_iterations = 0;           ///< of the whole block's linear solves
  int preconditioner_setups = 0;       ///< or factorisations, of the same
  double unknowns = not_given;         ///< of the whole block [1]
  double memory = not_given;           ///< matrix and preconditioner [bytes]
  double von_mises = not_given; ///< the strongest inside the whole block [Pa]
  double von_mises_depth = not_given; ///< of its place [m]
  StepStatus status = StepStatus::converged;
  bool is_unloading = false;
  std::string note; ///< why it did not converge, an observable is NaN; or ""
};

/// Maps of one load step, both grid.size() long. The grid is the method's own,
/// which need not be the surface's.
struct Fields {
  int step = 0;
  double nominal_pressure = 0.0; ///< [Pa]
  std::vector<double> pressure;  ///< [Pa] >= 0
  std::vector<double> gap; ///< [m], negative where a penalty is pressed in or
                           ///< atoms are closer than their contact distance
  Grid grid = {};
};

/// One bin of the isotropic spectrum of a map.
struct SpectrumPoint {
  double wavevector = 0.0; ///< q [rad/m]
  double spectrum = 0.0;   ///< C(q) [m^4]
};

/// The surface of one realisation with the statistics the report prints.
struct SurfaceRecord {
  Grid grid;
  std::vector<double> heights; ///< [m], mean 0; empty where not kept
  double rms_height = 0.0;     ///< [m]
  double rms_slope = 0.0;      ///< both directions [1]
  double rms_curvature = 0.0;  ///< half the Laplacian [1/m]
  double skewness = 0.0;       ///< [1]
  double kurtosis = 0.0;       ///< 3 for a Gaussian [1]
  double highest = 0.0;        ///< max of the heights [m]
  std::vector<SpectrumPoint> spectrum;
};

/// One method on one realisation.
struct Curve {
  std::vector<CurvePoint> points;
  std::vector<Fields> fields;
  double setup_cpu_time = 0.0; ///< [s]
  /// The surface it ran on where that is not the case's: roughness left out
  /// above a magnification, another grid.
  std::optional<SurfaceRecord> own_surface = {};
};

struct MethodRecord {
  std::string name;                ///< "fem", "fem.hard", "theory", ...
  std::string kind;                ///< fem | halfspace | theory | md | ...
  std::string description;         ///< one line for the report
  std::vector<Curve> realizations; ///< theory from a formula: one
};

/// One column of a table.
struct Column {
  std::string name; ///< as a name of a curve's columns: "mean_gap"
  std::string unit; ///< SI: "m"; "1" for none
  std::vector<double> values;
};

/// What a study of the theory found beside its curve: columns of one length.
struct Table {
  std::string name;
  std::string title; ///< one line for the reader
  std::vector<Column> columns;

  /// The values of a column, none if there is no such column.
  std::vector<double> values(const std::string& column) const;
};

/// Something the scene did not need and that was not computed.
struct Skipped {
  std::string what;      ///< "fem, realization 2"
  std::string why;       ///< "all 16 steps are in the cache"
  double cpu_time = 0.0; ///< it would have cost [s]; NaN: not predicted
  double bytes = 0.0;    ///< of memory it would have taken; NaN: not predicted
};

/// Key-value facts about what made the file, in the order they were written.
using Provenance = std::vector<std::pair<std::string, std::string>>;

struct Result {
  std::string path; ///< where it was read from
  std::string case_name;
  std::string case_title;
  std::string case_text;
  std::string case_hash;
  std::string reference;        ///< text of the case's reference.csv, or empty
  std::string status;           ///< running | complete | interrupted
  double contact_modulus = 0.0; ///< E* [Pa]
  Provenance provenance;
  std::vector<SurfaceRecord> surfaces; ///< one a realisation; empty if the
                                       ///< theory alone ran from a formula
  std::vector<MethodRecord> methods;
  std::vector<Table> tables = {}; ///< of studies, in the order they were made
  std::vector<Skipped> skipped = {};

  /// Null if there is none of that name.
  const Table* table(const std::string& name) const;
};

} // namespace asperity::results
