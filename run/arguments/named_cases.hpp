#pragma once

// Resolves the arguments of the command line to cases. All cases, and the files
// that belong to them, are read before anything runs.

#include "input/sweeps/sweep.hpp"
#include "input/types/case.hpp"
#include "run/arguments/case_library.hpp"
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
/// @param contact_modulus  E* for a measured map, which may stand for a case;
///                   "" if none is given
/// @throws input::InputError  the argument matches no case, a case is invalid,
///                            or a map has no contact modulus
NamedCases read_named_cases(const std::string& word,
                            const std::vector<std::string>& overrides = {},
                            bool is_quick = false,
                            const std::string& contact_modulus = "");

/// Does the same for commands that also accept a sweep.
NamedCases read_named_cases_or_sweep(
    const std::string& word, const std::vector<std::string>& overrides = {},
    bool is_quick = false, const std::string& contact_modulus = "");

/// Reads several maps as one sweep over their files.
///
/// @param files   at least two
/// @param folder  of the sweep, into which its case file will be written
/// @throws input::InputError  as read_named_cases()
NamedCases read_maps(const std::vector<std::filesystem::path>& files,
                     const std::vector<std::string>& overrides,
                     const std::string& contact_modulus,
                     const std::filesystem::path& folder);

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
