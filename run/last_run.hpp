#pragma once

// Handles the files that an earlier run left in the output folder of a new one.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace asperity::run {

/// Returns the name of the folder of the files that a method writes beside the
/// result: "fem-0".
std::string files_of_method(const std::string& method, int realization);

/// The output of the last run while a new one writes into its folder. The
/// result is renamed to result.previous.h5, or to result.unfinished.h5 if its
/// run has not finished, so that runs that fail do not replace the last
/// complete result, which contains all completed work. Tables, reports, figures
/// and files of methods that could be mistaken for output of the new run are
/// moved into the folder ".last-run". Figures for a journal that were edited
/// are kept for good in "journal.edited". Nothing else in the folder is
/// changed.
///
/// All functions throw std::system_error or results::Hdf5Error if a file
/// operation fails.
class LastRun {
public:
  /// Puts the output of the last run aside, if there is any.
  /// @param new_folders  names of folders that the new run may create in it
  explicit LastRun(std::filesystem::path folder,
                   const std::vector<std::string>& new_folders = {});

  /// Removes for good what was moved. The new output stays.
  void end();

  /// Removes the output of the new run, which is refused, and restores the
  /// folder as it was. The new result must not be open.
  /// @param has_cache  the steps of the new run are cached. Otherwise a result
  ///                   with steps is kept: as result.unfinished.h5 beside a
  ///                   complete last result, and in its place if there is none
  void put_back(bool has_cache);

private:
  void move_aside(const std::filesystem::path& file);

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> new_folders_; ///< that did not exist
  bool is_complete_ = false;    ///< the last result is complete
  std::filesystem::path aside_; ///< the last result; empty: there is none
  /// Files and folders that were moved: where they were, and where they are.
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> moved_;
};

/// Puts aside the output of the last run for good.
///
/// @throws std::system_error, results::Hdf5Error  a file operation fails
void put_last_run_aside(const std::filesystem::path& folder);

} // namespace asperity::run
