#pragma once

// What an earlier run left in the folder of a new one.

#include <filesystem>

namespace asperity::app {

/// Keeps the last result as result.previous.h5, with everything that was done,
/// and removes the tables, reports, figures and files of methods that would
/// seem to be the new run's. Nothing else in the folder is touched.
/// @throws std::system_error, results::Hdf5Error  the disk refuses
void put_last_run_aside(const std::filesystem::path& folder);

/// Removes the report and the figures of a folder.
void remove_report(const std::filesystem::path& folder);

} // namespace asperity::app
