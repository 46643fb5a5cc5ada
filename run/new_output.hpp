#pragma once

// Where a command computes while the output of an earlier one is in its folder.

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::run {

/// Returns the name of the folder of the files that a method writes beside the
/// result: "fem-0".
std::string files_of_method(const std::string& method, int realization);

/// Removes the report, the result and the sweep that our commands wrote into a
/// folder; edited figures for a journal are kept (reports::keep_edited).
/// Nothing else is touched.
void remove_output(const std::filesystem::path& folder);

/// Removes all that a run wrote into a folder that we made for it, such as that
/// of a part or a point, and the folder if nothing else is in it.
void remove_run(const std::filesystem::path& folder);

/// Returns where the last run into a folder has left its output: the hidden
/// folder of NewOutput if it is not complete, otherwise the folder.
std::filesystem::path latest_output(const std::filesystem::path& folder);

/// The output of a command. In a folder without an output of ours it is
/// computed in the folder itself, otherwise in the hidden folder ".new-run" in
/// it, whose files replace the earlier output once they are complete: no run
/// that fails or is killed touches what another one has completed. A run that
/// resumes continues what is in ".new-run", or else what is in the folder.
///
/// All functions throw std::system_error or results::Hdf5Error if a file
/// operation fails.
class NewOutput {
public:
  static constexpr const char* hidden_folder = ".new-run";

  /// Removes what an earlier run has left in ".new-run", unless it is complete
  /// or resumed.
  /// @param folder     which the command has locked (OutputFolder)
  /// @param main_file  what the command writes and can resume
  NewOutput(std::filesystem::path folder, bool resume,
            const char* main_file = "result.h5");

  /// Returns the folder to compute in.
  const std::filesystem::path& place() const { return place_; }

  /// Replaces the earlier output by the new one, which is complete.
  void replace();

  /// To be called if the run is refused: removes its result, unless it holds
  /// load steps, which --resume continues.
  void drop();

private:
  std::filesystem::path folder_;
  std::filesystem::path place_;
};

} // namespace asperity::run
