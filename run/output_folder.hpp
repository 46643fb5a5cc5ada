#pragma once

// The folder that a command writes into: it is locked, and what lies under the
// names of the outputs is examined before any of it is touched. A file that we
// wrote is replaced; one that we did not write is refused, as is an output that
// the command reads.

#include "base/folder_lock.hpp"
#include "input/types/case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::run {

/// Names in a folder that a command may replace or remove. A name that ends
/// with '/' is a folder.
using OutputNames = std::vector<std::string>;

/// Names of a report on results: tables, pages and figures.
const OutputNames& report_outputs();

/// Names of a run of this case: those of a report, the result and its journal,
/// and the folders of its methods.
OutputNames run_outputs(const cases::Case& contact_case);

/// Names that every result has, of a case or imported.
OutputNames result_outputs();

/// Names of a sweep, with the folders of its points.
OutputNames sweep_outputs();

/// Files that a case is read from, as far as they are given by name.
std::vector<std::filesystem::path> input_files(const cases::Case& contact_case);

/// Regular files in a folder, for commands that read all of it.
std::vector<std::filesystem::path>
files_in(const std::filesystem::path& folder);

/// Returns the script of the figure of ours that a file belongs to, or is: its
/// data are NAME.csv and NAME-MAP.csv, its pictures NAME.svg and the like.
/// Empty if there is no such script.
std::filesystem::path figure_script_of(const std::filesystem::path& file);

/// Requires that nothing is lost or awaited when the outputs are written.
///
/// An output is ours if the folder has a file that says so in its first 64
/// KiB: a result, or the JSON file or list of methods that each report writes
/// before its figures. A file in a folder without one is not ours, except a
/// figure with its script.
///
/// @param inputs  files that the command reads
/// @throws input::InputError  an output is there that is not ours, that is not
///         a regular file (or a folder, by its name), or that is an input
void require_own_outputs(const std::filesystem::path& folder,
                         const OutputNames& names,
                         const std::vector<std::filesystem::path>& inputs = {});

/// Locks an output folder as FolderLock does, and requires that the outputs in
/// it are ours.
class OutputFolder {
public:
  /// @param purpose  as for FolderLock
  /// @throws as FolderLock and require_own_outputs
  OutputFolder(const std::filesystem::path& folder, const std::string& purpose,
               const OutputNames& names,
               const std::vector<std::filesystem::path>& inputs = {});

private:
  FolderLock lock_;
};

/// Requires that a file named by an option can be written without loss: there
/// is none, or one with this text in its first 64 KiB, by which it is ours.
/// @throws input::InputError  naming the option and what to do
void require_own_file(const std::string& option,
                      const std::filesystem::path& file,
                      const std::string& own_text);

} // namespace asperity::run
