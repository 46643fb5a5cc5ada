#pragma once

// Handles the files that an earlier run left in the output folder of a new one.

#include <filesystem>

namespace asperity::app {

/// Renames the last result to result.previous.h5, or to result.unfinished.h5 if
/// its run has not finished, so that runs that fail do not replace the last
/// complete result. It contains all completed work. Removes tables, reports,
/// figures and files of methods that could be mistaken for output of the new
/// run. Nothing else in the folder is changed.
///
/// @throws std::system_error, results::Hdf5Error  a file operation fails
void put_last_run_aside(const std::filesystem::path& folder);

/// Removes the report and the figures in a folder.
void remove_report(const std::filesystem::path& folder);

} // namespace asperity::app
