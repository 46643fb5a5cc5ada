#pragma once

// What a run of the matrix leaves: a page, a table and a summary for programs.

#include <cstdint>
#include <string>
#include <vector>

#include "robustness/locking.hpp"
#include "robustness/matrix.hpp"

namespace asperity::robustness {

/// What the page says of the run itself.
struct RunWords {
  std::string rerun;   ///< "asperity robustness --seed 1", without --scene
  std::string commit;  ///< of the program
  std::string machine; ///< processor and cores
  double wall_seconds = 0.0;
  std::uint64_t seed = 0;
};

/// The whole page, with nothing outside it: verdict, the matrix as a heat map
/// of every two axes, scenes that ended otherwise with the command that runs
/// each again, twins, locking.
std::string page_of(const Matrix& matrix, const RunWords& run,
                    const std::vector<LockingRow>& locking);

/// The header line and the line of a scene.
std::string csv_header();
std::string csv_line(const SceneResult& result);

/// Counts, twins, locking and every scene that ended otherwise.
std::string json_of(const Matrix& matrix, const RunWords& run,
                    const std::vector<LockingRow>& locking);

} // namespace asperity::robustness
