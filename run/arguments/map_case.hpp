#pragma once

// The case of a measured map that a user names instead of a case file: its
// text, with the settings that suit any map.

#include "input/input_error.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::run {

/// A map and what its file cannot contain.
struct MapOfCase {
  std::string file;            ///< path as the user gave it
  std::string contact_modulus; ///< E*, a quantity of a case file: "2 GPa"
  /// Folder of the case file, from which it names the map; "": the map is named
  /// by its absolute path.
  std::string folder = {};
};

/// Returns the overrides of a case by which a map gets what its file does not
/// state.
/// @param length       side length in x, "20 um"; "": stated
/// @param height_unit  unit of its numbers, "nm" or "2 nm"; "": stated
/// @throws input::InputError  one of them is no length with a unit
std::vector<std::string> map_overrides(const std::string& length,
                                       const std::string& height_unit);

/// Returns true if the word names a regular file that is no case file: a map.
bool is_map_file(const std::string& word);

/// Returns the text of a case that presses the map on a half-space, in steps of
/// equal ratios of the contact area from 1.6 % to 95 %, beside
/// Persson's theory.
/// @throws input::InputError  there is no valid contact modulus
std::string map_case_text(const MapOfCase& map);

/// The maps that the words of a command name.
struct NamedMaps {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> folders;  ///< words that stand for all their files
  std::vector<std::string> left_out; ///< case files and folders in them
};

/// Returns the maps that a command names, by themselves or as all files of a
/// folder that has no case; nothing unless all words are such.
/// @throws input::InputError  a folder has no map, or an entry that may be
///                            meant as one and is no file: a link to nothing
NamedMaps maps_among(const std::vector<std::string>& words);

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
/// @throws input::InputError  there is no valid contact modulus
std::string maps_sweep_text(const std::vector<std::filesystem::path>& files,
                            const std::string& contact_modulus);

} // namespace asperity::run
