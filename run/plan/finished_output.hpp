#pragma once

// Recognises a run whose output is already in its folder or in the cache, so
// that nothing is computed or drawn again. This file defines what determines
// that output and the list of its files, output.json.

#include "cases/types/case.hpp"
#include "methods/cache/cache.hpp"
#include "run/plan/run_options.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace asperity::run {

/// Hashes of what determines the files of a run.
struct OutputKeys {
  /// Everything: the program itself, gnuplot, the processor, the case with its
  /// files, the methods and options.
  std::string output;
  /// The same without the title, comments, [expect] and reference.csv, on which
  /// neither numbers nor figures depend.
  std::string numbers;
};

/// @param extras  options of the command beyond those of the run
/// @throws input::InputError  a file of the case cannot be read
OutputKeys output_keys(const cases::Case& contact_case,
                       const RunOptions& options, const std::string& extras);

/// Lists the files in the folder of a completed run with their hashes in
/// output.json, and saves list, files and figures in the cache unless together
/// they are larger than a tenth of its size limit. Hidden files and the
/// previous result are left out.
/// @param figures  the bytes of the figures
/// @throws std::system_error, FileError  a file cannot be read or written
void record_output(const std::filesystem::path& folder, const OutputKeys& keys,
                   std::string_view figures, methods::Cache& cache);

/// Whether the folder holds every file of a completed run with this key, byte
/// for byte.
bool has_output(const std::filesystem::path& folder, const std::string& key);

/// The bytes of each file of a run, by its path in the output folder.
using OutputFiles = std::map<std::string, std::string>;

/// Returns the files of a completed run with this key, output.json among them;
/// nothing unless the cache has all of them.
std::optional<OutputFiles> cached_output(const std::string& key,
                                         methods::Cache& cache);

/// What remains of a completed run if only words and verdicts change.
struct KeptNumbers {
  OutputFiles files; ///< without output.json
  std::string figures;
};

/// Returns the output of a completed run with this OutputKeys::numbers; nothing
/// unless the cache has all of it.
std::optional<KeptNumbers> cached_numbers(const std::string& key,
                                          methods::Cache& cache);

/// Writes the files into the folder, without waiting for the disk: after a
/// power failure has_output() finds those that are incomplete.
/// @throws std::system_error  a file cannot be written
void write_output(const std::filesystem::path& folder,
                  const OutputFiles& files);

} // namespace asperity::run
