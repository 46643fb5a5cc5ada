#pragma once

// Writes the output of a run of the matrix: a page, a table, and a summary for
// use by programs.

#include "robustness/locking.hpp"
#include "robustness/matrix.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity::robustness {

/// Description of the run itself.
struct RunDescription {
  std::string rerun;   ///< "asperity robustness --seed 1", without --instance
  std::string commit;  ///< commit of the program
  std::string machine; ///< processor and number of cores
  double wall_seconds = 0.0;
  std::uint64_t seed = 0;
};

/// Returns a self-contained page: the verdict, the outcome matrix as a heat map
/// of all pairs of axes, the instances with other outcomes and the command that
/// runs each again, the metamorphic pairs, and locking.
std::string page_of(const Matrix& matrix, const RunDescription& run,
                    const std::vector<LockingRow>& locking);

/// Return the header line and the line of an instance.
std::string csv_header();
std::string csv_line(const InstanceResult& result);

/// Returns the counts, the metamorphic pairs, locking and all instances with
/// other outcomes.
std::string json_of(const Matrix& matrix, const RunDescription& run,
                    const std::vector<LockingRow>& locking);

} // namespace asperity::robustness
