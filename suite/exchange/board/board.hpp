#pragma once

// The board: problems and the answers of many codes to them, read from folders
// and certified. This file owns the layout of these folders and what is known
// of each answer.

#include "input/types/case.hpp"
#include "suite/exchange/answers/imported_answer.hpp"
#include "suite/exchange/problem.hpp"
#include "suite/exchange/submission.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity::exchange {

/// One submission as the board shows it.
struct BoardEntry {
  enum class State {
    certified,    ///< every claim about every field holds
    as_submitted, ///< a curve without fields: not ranked
    failed        ///< unreadable, a mistake, or a claim that does not hold
  };
  std::string folder; ///< below the folder of submissions, or as it was named
  bool is_named = false; ///< named beside the board, not one of its folder
  /// Without its fields; of one that cannot be read, the problem and what its
  /// folder is called.
  Submission answer;
  State state = State::failed;
  std::vector<std::string> reasons; ///< why it failed
  std::size_t loads = 0;            ///< number of fields
  std::size_t missing_loads = 0;    ///< of the problem: shown after the others
  double gap_error = not_a_number;  ///< of the mean gaps that follow from the
                                    ///< fields: largest bound [h_rms]
  double distance = not_a_number; ///< with adhesion: largest one of a gap from
                                  ///< a minimum, rms [h_rms]
  /// With adhesion: U of each load of the problem [J/m^2]; NaN: not answered.
  std::vector<double> energies;
  /// With adhesion: mean over the answered loads of what U is above the lowest
  /// of all complete answers and the reference [w].
  double energy_above = not_a_number;
  std::size_t lowest_loads = 0;    ///< how many are the lowest to 1e-6 w
  std::size_t reference_loads = 0; ///< how many are the reference's, likewise
  double pressure_error = not_a_number;  ///< largest bound [1]
  double mesh_error = not_a_number;      ///< as gap_error, with the compliance
                                         ///< of the mesh of these elements
  double continuum_error = not_a_number; ///< largest distance of a mean gap
                                         ///< from the continuum's [h_rms]
  double continuum_uncertainty = not_a_number; ///< largest of these [h_rms]
  double cpu_time = not_a_number;      ///< of all loads [s]; NaN: not stated
  double cpu_time_low = not_a_number;  ///< sum of the loads' ends [s]
  double cpu_time_high = not_a_number; ///< likewise
  double peak_memory = not_a_number;   ///< the largest of all loads [bytes]
  int iterations = 0;                  ///< of all loads; 0: not stated
};

/// A problem, its reference answers and its entries.
struct BoardProblem {
  Problem problem;
  /// From which it was computed, with the mesh of its [fem]; none: it is given
  /// by its files.
  std::optional<cases::Case> contact_case;
  std::vector<ProblemAnswer> answers;
  std::vector<ContinuumAnswer> continuum;
  /// Certified first, then those with all loads, in ascending error; with
  /// adhesion in ascending energy.
  std::vector<BoardEntry> entries;
};

/// Reads the problems and all answers to them:
///
///     FOLDER/<problem>/problem.json or case.toml
///     FOLDER/submissions/<problem>/<code>/<version>/submission.toml
///
/// A problem that is given as a case is computed. Each problem is written into
/// problems/<problem> of the site, or the files of its SHA256SUMS are copied
/// there. No symbolic link below FOLDER is followed.
///
/// @param named  further answers, folders with a submission.toml: if there are
///               any, only their problems are read
/// @throws input::InputError  no submissions, or a problem that does not exist
///                            or is invalid, or has another checksum or a
///                            symbolic link. A submission cannot cause an
///                            exception: it becomes an entry that failed.
std::vector<BoardProblem>
read_board(const std::filesystem::path& folder,
           const std::filesystem::path& site,
           const std::vector<std::filesystem::path>& named = {});

} // namespace asperity::exchange
