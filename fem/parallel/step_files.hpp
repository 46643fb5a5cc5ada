#pragma once

// The files of load steps for ParaView that all ranks write together: their
// names, their lists and the order in which they appear. It does not know what
// the files contain.

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace asperity::fem {

/// One series of files, with a file per load step.
struct StepSeries {
  std::string stem; ///< of the file names, such as "block"
  /// Prints what this rank contributes to the present step (VTU).
  std::function<void(std::ostream&)> part;
  /// Prints the list of the parts with these file names (PVTU).
  std::function<void(std::ostream&, const std::vector<std::string>&)> list;
};

/// Writes the present step of each series: <stem>_<step>.<rank>.vtu on each
/// rank, then on the first rank <stem>_<step>.pvtu and <stem>.pvd, the list of
/// the steps. Each file is complete or absent, and no list names a file that
/// does not exist. This call is collective.
/// @param folder             is created if necessary; empty for the current one
/// @param nominal_pressures  [Pa] of all steps, of which the present one is the
///                           last
/// @throws std::runtime_error  on every rank if one of them could not write;
///                             the lists of earlier steps are then unchanged or
///                             name the present step, whose files exist
void write_step(const std::filesystem::path& folder,
                const std::vector<StepSeries>& series,
                const std::vector<double>& nominal_pressures);

/// Times of the steps in a PVD file: the nominal pressures if they increase
/// from step to step, otherwise the numbers of the steps, because ParaView
/// superimposes files with equal times.
std::vector<double> times_of(const std::vector<double>& nominal_pressures);

} // namespace asperity::fem
