#pragma once

// A run that several machines share: part I of N computes every N-th
// realisation of a case into a folder of its own, or every N-th point of a
// sweep, and the results of all parts are joined.

#include "input/types/case.hpp"
#include "results/types/result.hpp"
#include "run/arguments/named_cases.hpp"

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace asperity::run {

/// One part of several, "3/8".
struct Part {
  int number = 1; ///< 1 <= number <= count
  int count = 1;

  bool operator==(const Part&) const = default;
};

/// Reads the value of --part.
/// @throws input::InputError  it is not I/N with 1 <= I <= N
Part read_part(const std::string& text);

/// Returns "3/8".
std::string part_text(const Part& part);

/// Returns the number of realisations of a case, or of points of a sweep.
std::size_t n_members(const NamedCases& named);

/// Returns the members of a part: the I-th one and every N-th after it.
/// @throws input::InputError  there are fewer members than parts
std::vector<std::size_t> members_of(const NamedCases& named, const Part& part);

/// Returns the folder of a part below that of the run: "parts/3-of-8".
std::filesystem::path part_folder(const Part& part);

/// Whether a folder has results of parts of a case.
bool has_parts_of_case(const std::filesystem::path& folder);

/// Removes the folders of parts in the folder of a run.
void remove_parts(const std::filesystem::path& folder);

/// Joins the results of the parts of a case to folder/result.h5, with the files
/// that their methods wrote, in place of an older output.
/// @throws input::InputError  there is no part; parts of different cases or
///                            numbers of parts; parts that are missing or
///                            incomplete
void merge_realizations(const std::filesystem::path& folder);

enum class RunState { missing, to_resume, complete };

struct EarlierRun {
  RunState state = RunState::missing;
  std::string case_hash = {}; ///< of the result
};

/// Returns whether every load step of a result has converged.
bool all_converged(const results::Result& result);

/// Reads the result in a folder. One of another case, of other input files or
/// of another program counts as missing, as does an incomplete one whose case
/// is written differently, because the run would refuse to resume it.
///
/// @param only  the realisations that are needed; empty: all
EarlierRun earlier_run(const cases::Case& contact_case,
                       const std::vector<cases::MethodSpec>& methods,
                       const std::filesystem::path& folder,
                       const std::set<int>& only = {});

} // namespace asperity::run
