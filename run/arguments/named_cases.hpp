#pragma once

// Resolves the arguments of the command line to cases. All cases, and the files
// that belong to them, are read before anything runs.

#include "input/sweeps/sweep.hpp"
#include "input/types/case.hpp"
#include "run/arguments/case_library.hpp"
#include "run/arguments/case_options.hpp"
#include "run/arguments/map_case.hpp"
#include "run/output_folder.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity::run {

/// A case together with the contents of the files beside its case file.
struct ReadCase {
  FoundCase found;
  cases::Case contact_case;
  std::string reference; ///< text of reference.csv
  std::vector<std::string> overrides = {};
};

/// A case file with a [sweep] and all of its points.
struct NamedSweep {
  FoundCase found;
  cases::CaseSweep sweep;
  std::vector<std::string> overrides; ///< including those of quick.set
  /// Of a sweep over several maps, whose points have reports of their own: the
  /// case file that is written when it runs.
  std::string text = {};
};

/// The cases that one argument of the command line refers to.
struct NamedCases {
  FoundCases found;
  std::vector<ReadCase> cases; ///< empty for a sweep
  std::optional<NamedSweep> sweep = {};
};

/// Finds and reads the cases that an argument refers to.
///
/// @param word       case file, folder, shipped case, collection or map file
/// @param overrides  "key.path=value" entries that are applied to every case
/// @param is_quick   if true, the case's quick.set is applied before
///                   `overrides`
/// @param options    of the command, which go before `overrides`
/// @throws input::InputError  the argument matches no case, a case is invalid,
///                            or a map needs an option; everything that is
///                            wrong is named at once
NamedCases read_named_cases(const std::string& word,
                            const std::vector<std::string>& overrides = {},
                            bool is_quick = false,
                            const CaseOptions& options = {});

/// Does the same for commands that also accept a sweep.
NamedCases read_named_cases_or_sweep(
    const std::string& word, const std::vector<std::string>& overrides = {},
    bool is_quick = false, const CaseOptions& options = {});

/// Reads one map as a case, or several as one sweep over their files. Without
/// loads in the options and overrides, all are pressed with the same ones, from
/// a contact area of at most 1.6 % of the map of the smallest slope to at least
/// 89 % of that of the largest (Persson's theory), and below a hardness.
///
/// @param maps    of which the files that are no maps are left out
/// @param folder  of the sweep, into which its case file will be written; not
///                used for one map that is named by itself
/// @throws input::InputError  as read_named_cases()
NamedCases read_maps(NamedMaps& maps, const std::vector<std::string>& overrides,
                     const CaseOptions& options,
                     const std::filesystem::path& folder = {});

/// Returns the text of a case that presses a map, with the loads of
/// read_maps().
/// @param path  of the case file that is made
std::string text_of_map(const std::string& file, const CaseOptions& options,
                        const std::vector<std::string>& overrides,
                        const std::filesystem::path& path);

/// Returns true for the case file of several maps, of which each point gets a
/// report of its own; such a sweep has the name of its folder.
bool is_of_maps(const NamedSweep& sweep);

/// Returns the path of the case that was made for a map or for several, if
/// there is no such file yet; otherwise an empty one.
std::filesystem::path made_case_of(const NamedCases& named);

/// Names of a sweep that is run, with the case file if the run writes it.
OutputNames outputs_of(const NamedSweep& sweep);

/// Writes the case file of several maps, unless the sweep was read from it.
void write_made_case(const NamedSweep& sweep);

/// The name of the folder into which an argument is written below out/.
std::string output_name(const NamedCases& named);

/// Lets no two arguments of a command write into one folder: cases or maps of
/// one name in different folders get the name of their folder, too, as in
/// s1-heights and s2-heights.
/// @param words  the arguments of which `all` were read
/// @throws input::InputError  two of them still have one name
void name_apart(std::vector<NamedCases>& all,
                const std::vector<std::string>& words);

} // namespace asperity::run
