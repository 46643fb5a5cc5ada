#pragma once

// The answer of another program to a problem: submission.toml and the fields
// that it names. This file owns the keys of submission.toml.

#include "base/special_numbers.hpp"
#include "suite/exchange/problem.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity::exchange {

/// One [[load]]: a field, and what its authors state about it (NaN: nothing).
struct SubmittedLoad {
  std::size_t load = 0; ///< index in Problem::loads
  std::filesystem::path file;
  bool is_force = false; ///< whether the file has forces of nodes [N]
  std::size_t rows = 0;
  std::size_t columns = 0;
  /// As submitted, or the force over the area of a node [Pa]; rows * columns
  /// values.
  std::vector<double> pressure;
  double mean_gap = not_a_number;       ///< [m]
  double area_fraction = not_a_number;  ///< [1]
  double elastic_energy = not_a_number; ///< [J/m^2]
  double energy = not_a_number;         ///< with adhesion: U [J/m^2]
  double cpu_time = not_a_number;       ///< the median of Timing [s]
  double cpu_time_low = not_a_number;   ///< interval of cpu_time [s]
  double cpu_time_high = not_a_number;  ///< likewise
  double peak_memory = not_a_number;    ///< of the process [bytes]
  int iterations = 0;
};

/// How the times of all loads were measured, so that others can be compared
/// with them: the answers that state one run were computed in alternation on
/// one machine, as a pair (ABBA) or as more codes in turn.
struct Timing {
  std::string run; ///< its name; the answers of one run share it
  int pairs = 0;   ///< of there and back, each code once in both; >= 2
  int threads = 1;
  std::string heights; ///< SHA-256 of the problem's heights.npy
};

/// One row of a curve without fields.
struct SubmittedRow {
  double nominal_pressure = 0.0; ///< [Pa]
  double mean_gap = 0.0;         ///< [m]
  double area_fraction = 0.0;    ///< [1]
};

/// Texts are single lines of plain text (base/plain_text.hpp).
struct Submission {
  std::string problem; ///< name of the problem
  std::string code;    ///< at most 40 bytes
  std::string version; ///< likewise
  std::string method;
  std::string accuracy; ///< "default" or "best"
  std::vector<std::string> authors;
  std::string licence;
  std::string machine;
  std::string element; ///< "Q1" or "Q2", of the problem's mesh; empty: no mesh
  /// Error of each mean gap that the authors claim not to exceed [h_rms].
  double claimed_error = 1e-3;
  std::optional<Timing> timing;     ///< none: times are "as submitted"
  std::vector<SubmittedLoad> loads; ///< in the order of the file
  std::vector<SubmittedRow> curve;
};

/// Reads a submission to a problem with its fields.
/// @param folder  contains submission.toml
/// @throws input::InputError  every mistake of submission.toml with its line
///                            and key, or the first field that cannot be read
///                            or is behind a symbolic link
Submission read_submission(const std::filesystem::path& folder,
                           const Problem& problem);

/// The name of the problem that a submission answers.
/// @throws input::InputError  there is none, or no submission.toml
std::string submitted_problem(const std::filesystem::path& folder);

} // namespace asperity::exchange
