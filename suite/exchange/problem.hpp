#pragma once

// A contact problem that is handed to other programs: problem.json and the
// heights beside it. This file owns the meaning of its members, and reads it.

#include "base/grid.hpp"
#include "base/special_numbers.hpp"
#include "contact/operators/halfspace.hpp"
#include "mechanics/contact_law.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::exchange {

/// A rigid rough surface that is pressed on an elastic block without friction:
/// in non-adhesive, hard contact on one periodic cell or once, on a rectangle
/// of an infinite half-space, or with a hard wall and exponential attraction,
/// on a periodic cell.
struct Problem {
  std::string name;  ///< is_good_name(), not beginning with '.'
  std::string title; ///< one line of at most longest_line bytes
  Grid grid;
  std::vector<double> heights;  ///< [m], positive towards the block, mean 0
  mechanics::ElasticBlock body; ///< with its border
  /// With ContactLaw::exponential; none: non-adhesive, hard contact.
  std::optional<mechanics::ContactInterface> adhesion = {};
  /// Nominal pressures p_0 [Pa] > 0, ascending; with adhesion mean gaps [m] > 0
  /// in the order of the path, which begins out of contact.
  std::vector<double> loads;
  double rms_height = 0.0;  ///< of the heights [m] > 0
  double rms_slope = 0.0;   ///< of the heights, both directions [1]
  std::string heights_hash; ///< SHA-256 of heights.npy, if read from a folder

  bool is_periodic() const { return !body.is_free(); }
};

/// The solution of the discrete problem at one load.
struct ProblemAnswer {
  double nominal_pressure = 0.0; ///< [Pa]
  double mean_gap = 0.0;         ///< [m]
  double mean_gap_error = 0.0;   ///< certified bound [m]; 0 if prescribed
  /// Share of the nodes with p > 0, with adhesion of those at the wall [1].
  double area_fraction = 0.0;
  double elastic_energy = 0.0;   ///< per nominal area [J/m^2]
  double largest_pressure = 0.0; ///< [Pa]
  double energy = not_a_number;  ///< with adhesion: U per nominal area [J/m^2]
};

/// An estimate of the continuum solution at one load.
struct ContinuumAnswer {
  double nominal_pressure = 0.0;        ///< [Pa]
  double mean_gap = not_a_number;       ///< [m]
  double mean_gap_error = not_a_number; ///< estimated; 0: exact solution [m]
  double area_fraction = not_a_number;  ///< [1]
  double area_fraction_error = not_a_number; ///< likewise [1]
  std::string source; ///< "Westergaard (1939)", "Richardson, 256 to 1024"
};

/// The operator of the body with the boundaries of the problem on `grid`, which
/// may be finer than that of the problem.
std::unique_ptr<contact::SurfaceOperator>
surface_operator(const Problem& problem, const Grid& grid);

/// Returns the text of problem.json.
/// @param example  answer at one load, by which units can be verified
/// @param hashes   pairs of file name and SHA-256 of the height files
/// @param mesh     the member `mesh`, or null: the problem has none
std::string
problem_json(const Problem& problem, const ProblemAnswer& example,
             std::span<const std::pair<std::string, std::string>> hashes,
             const nlohmann::ordered_json& mesh);

/// Reads problem.json and heights.npy of a folder, and verifies all files of
/// its SHA256SUMS.
/// @throws input::InputError  naming the file and the member: what was found
///                            and what is allowed; the heights are not those of
///                            the checksum, or do not have the rms height and
///                            slope that are stated; a symbolic link
Problem read_problem(const std::filesystem::path& folder);

} // namespace asperity::exchange
