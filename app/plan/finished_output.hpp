#pragma once

// Recognises a run whose output is already in its folder, so that nothing is
// read from the cache, written or drawn again. This file defines what
// determines that output and the list of its files, output.json.

#include "app/plan/run_options.hpp"
#include "cases/types/case.hpp"

#include <filesystem>
#include <string>

namespace asperity::app {

/// A hash of everything that determines the files of a run: the program itself,
/// the processor, the case with its files, the methods and `extras`.
/// @param extras  options of the command beyond those of the run
/// @throws input::InputError  a file of the case cannot be read
std::string output_key(const cases::Case& contact_case,
                       const RunOptions& options, const std::string& extras);

/// Lists the files in the folder of a completed run with their hashes in
/// output.json. Hidden files and the previous result are left out.
/// @throws std::system_error, FileError  a file cannot be read or written
void record_output(const std::filesystem::path& folder, const std::string& key);

/// Whether the folder holds every file of a completed run with this key, byte
/// for byte.
bool has_output(const std::filesystem::path& folder, const std::string& key);

} // namespace asperity::app
