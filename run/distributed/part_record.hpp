#pragma once

// Part.json, which states what a part of a run is: the case, which of its
// members the part computes, and the command that computes it.

#include "run/arguments/named_cases.hpp"
#include "run/distributed/share.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity::run {

/// The options of `run` that determine its numbers.
struct PartRequest {
  std::string case_file = {};              ///< absolute path, or that of a map
  std::vector<std::string> overrides = {}; ///< "key.path=value", with quick.set
  std::vector<std::string> methods = {};   ///< names or kinds; empty: all
  bool is_exact = false;                   ///< `methods` lists names only
  std::string contact_modulus = {};        ///< E* for a map, "2 GPa"

  bool operator==(const PartRequest&) const = default;
};

struct PartRecord {
  std::string case_name;
  PartRequest request;
  bool is_sweep = false; ///< members are its points, otherwise realisations
  std::vector<std::string> case_hashes; ///< of the case, or of every point
  Part part;
  std::vector<std::size_t> members; ///< indices in ascending order

  bool operator==(const PartRecord&) const = default;
};

/// Returns the records of all parts of a run.
///
/// @param named    one case or one sweep
/// @param n_parts  number of parts; 0: one per member
/// @throws input::InputError  there are fewer members than parts; the message
///                            says how many there are
std::vector<PartRecord> part_records(const NamedCases& named,
                                     const PartRequest& request, int n_parts);

/// Returns the folder of a part below that of the run: "parts/3-of-8".
std::filesystem::path part_folder(const Part& part);

/// Returns a word as a POSIX shell reads it: 'it'\''s' for it's.
std::string quoted_word(const std::string& word);

/// Returns the arguments of the program that compute the whole run into a
/// folder: "run", the case and the options.
std::vector<std::string> run_arguments(const PartRecord& record,
                                       const std::filesystem::path& folder);

/// Returns the same as a command, quoted for a shell.
std::string run_command(const PartRecord& record,
                        const std::filesystem::path& program,
                        const std::filesystem::path& folder);

/// Returns the command that computes a part.
/// @param folder  of the whole run
std::string part_command(const PartRecord& record,
                         const std::filesystem::path& folder);

/// Writes part.json into the folder of the part, which must exist.
/// @return  whether there was none
bool write_part_record(const PartRecord& record,
                       const std::filesystem::path& folder);
void remove_part_record(const PartRecord& record,
                        const std::filesystem::path& folder);

/// Reads the records of all parts below the folder of a run, in ascending order
/// of their counts and numbers; none if there is no part.
///
/// @throws input::InputError  a part.json is not what write_part_record()
///                            writes
std::vector<PartRecord> read_part_records(const std::filesystem::path& folder);

} // namespace asperity::run
