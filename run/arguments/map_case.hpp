#pragma once

// The case of a measured map that a user names instead of a case file: its
// text, with the settings that suit any map.

#include "input/input_error.hpp"
#include "mechanics/surface_spec.hpp"
#include "run/arguments/case_options.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity::run {

/// Returns true if the word names a regular file that is no case file: a map.
bool is_map_file(const std::string& word);

/// Returns the text of a case that presses the map on a half-space, beside
/// Persson's theory, with loads from light to nearly full contact.
/// @param file     as the case names it
/// @param entries  "table.key=value" in TOML, which are written into the case;
///                 an empty value removes the key. Without a modulus in them
///                 the case has none, which its reader refuses.
std::string map_case_text(const std::filesystem::path& file,
                          const std::vector<std::string>& entries);

/// The path by which a case names its map.
/// @param folder  of the case file; "": the map is named by its absolute path
std::filesystem::path path_of_map(const std::string& file,
                                  const std::string& folder = "");

/// Reads what the options and the overrides of keys say about map files.
/// @throws input::InputError  a mistake in them
mechanics::SurfaceSpec map_surface(const std::string& file,
                                   const CaseOptions& options,
                                   const std::vector<std::string>& overrides);

/// E* [Pa] of the bodies that the options describe; nothing if they describe
/// none.
/// @throws input::InputError  a mistake in them
std::optional<double> contact_modulus_of(const CaseOptions& options);

/// The maps that the words of a command name.
struct NamedMaps {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> folders;  ///< words that stand for all their files
  std::vector<std::string> left_out; ///< case files and folders in them
  std::string origin = {}; ///< comment at the head of the case of one map
};

/// Returns the maps that a command names, by themselves or as all files of a
/// folder that has no case; nothing unless all words are such. A folder of the
/// name of a shipped case is not meant.
/// @throws input::InputError  a folder has no map, or an entry that may be
///                            meant as one and is no file: a link to nothing
NamedMaps maps_among(const std::vector<std::string>& words);

/// Calls read(file) for every map. Files of a folder that are no maps are moved
/// from `maps.files` to `maps.left_out`, with the reason; all other refusals
/// are thrown at once.
/// @throws input::InputError  a map that was named by itself cannot be read, a
///                            key or option is missing for one, or no file of
///                            a folder is a map
void read_each(NamedMaps& maps,
               const std::function<void(const std::filesystem::path&)>& read);

/// Names what is left out on standard error.
void print_left_out(const NamedMaps& maps);

/// Reads every map in this way.
/// @param surface  what the case of each map says about it
/// @return  the smallest and the largest rms slope
std::pair<double, double> examine_maps(NamedMaps& maps,
                                       mechanics::SurfaceSpec surface);

/// Returns a refusal without the lines of the case that was made for maps,
/// because the user has no such file.
/// @param made  path that the case was read under; "": there is none
std::string refusal_without_lines(const std::string& refusal,
                                  const std::string& made);

/// The same of the refusals of some work.
template <class Work>
auto without_lines_of(const std::filesystem::path& made, const Work& work) {
  try {
    return work();
  } catch (const input::InputError& error) {
    throw input::InputError(refusal_without_lines(error.what(), made.string()));
  }
}

/// Returns the text of a sweep over the files of several maps, each as by
/// map_case_text().
std::string maps_sweep_text(const std::vector<std::filesystem::path>& files,
                            const std::vector<std::string>& entries);

} // namespace asperity::run
