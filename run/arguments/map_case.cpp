#include "run/arguments/map_case.hpp"

#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/text/toml_text.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "run/arguments/case_library.hpp"
#include "run/arguments/physics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;

constexpr const char* text_of_case =
    R"(# A measured map, pressed on an elastic block. docs/reference/case.md has all keys.
schema = 1
title = {title}

[surface]
kind = "measured"
file = {file}
# What is removed from the map: "none", "plane" or "bow" (second order).
level = "plane"
# Beyond its border the map continues by its mirror images; "free" presses it
# once on an infinite half-space.
edges = "mirror"

[material]
contact_modulus = {modulus}
poisson_ratio = 0.3 # needed by [fem] and [friction] only

[load]
# Twelve steps of equal ratios of the contact area; h' is the rms slope.
nominal_pressure = {{ from = "0.01 E* h'", to = "1 E* h'", steps = 12, spacing = "area" }}

# Persson's theory with the spectrum of the map.
[theory]
gamma = 0.4

[halfspace]

# The elastic block by finite elements takes longer:
# [fem]
)";

fs::path map_path(const MapOfCase& map) {
  return map.folder.empty()
             ? fs::absolute(map.file).lexically_normal()
             : fs::relative(fs::absolute(map.file), fs::absolute(map.folder));
}

std::string titled_case_text(const MapOfCase& map, const std::string& title) {
  if (map.contact_modulus.empty())
    throw input::InputError(fmt::format(
        "{} is not a case file (.toml); to press it as a measured map, please "
        "add "
        "--contact-modulus, for example --contact-modulus \"2 GPa\"",
        map.file));
  (void)positive_quantity("--contact-modulus", map.contact_modulus,
                          input::Dimension::pressure);
  return fmt::format(
      fmt::runtime(text_of_case), fmt::arg("title", cases::toml_value(title)),
      fmt::arg("file", cases::toml_value(map_path(map).string())),
      fmt::arg("modulus", cases::toml_value(map.contact_modulus)));
}

/// Refuses an entry of a folder that is neither a file nor a folder. Left out,
/// a map would be missing from the means over the maps.
void refuse_entry(const fs::path& path) {
  try {
    input::read_input_file(path, 0);
  } catch (const input::InputError& error) {
    throw input::InputError(fmt::format(
        "{}; every file of a folder of maps is read: please remove it, or name "
        "the maps one by one",
        error.what()));
  }
}

/// Adds the maps of a folder in the order of their names.
void add_maps_in(const std::string& folder, NamedMaps& maps) {
  const std::size_t n_before = maps.files.size();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& path = entry.path();
    std::error_code unreadable;
    if (path.filename().string().starts_with('.'))
      continue;
    if (is_map_file(path.string()))
      maps.files.push_back(fs::absolute(path).lexically_normal());
    else if (fs::is_directory(path, unreadable) ||
             fs::is_regular_file(path, unreadable))
      maps.left_out.push_back(path.string());
    else
      refuse_entry(path);
  }
  std::ranges::sort(maps.files.begin() + static_cast<std::ptrdiff_t>(n_before),
                    maps.files.end());
  if (maps.files.size() == n_before)
    throw input::InputError(folder + ": is a folder without maps");
  maps.folders.push_back(folder);
}

} // namespace

bool is_map_file(const std::string& word) {
  std::error_code unreadable;
  return fs::is_regular_file(word, unreadable) &&
         fs::path(word).extension() != ".toml";
}

std::vector<std::string> map_overrides(const std::string& length,
                                       const std::string& height_unit) {
  std::vector<std::string> overrides;
  if (!length.empty()) {
    (void)positive_quantity("--length", length, input::Dimension::length);
    overrides.push_back("surface.length=" + cases::toml_value(length));
  }
  if (!height_unit.empty())
    overrides.push_back(
        "surface.height_unit=" +
        cases::toml_value(length_unit_text("--height-unit", height_unit)));
  return overrides;
}

std::string map_case_text(const MapOfCase& map) {
  return titled_case_text(map, fs::path(map.file).filename().string());
}

NamedMaps maps_among(const std::vector<std::string>& words) {
  NamedMaps maps;
  for (const std::string& word : words) {
    std::error_code unreadable;
    if (is_map_file(word))
      maps.files.push_back(fs::absolute(word).lexically_normal());
    else if (fs::is_directory(word, unreadable) && !is_folder_of_cases(word))
      add_maps_in(word, maps);
    else
      return {};
  }
  return maps;
}

std::string maps_sweep_text(const std::vector<fs::path>& files,
                            const std::string& contact_modulus) {
  std::string text =
      titled_case_text({files.front().string(), contact_modulus},
                       fmt::format("{} measured maps", files.size())) +
      fmt::format("\n{}\n[sweep]\n\"surface.file\" = [\n", reports::maps_mark);
  for (const fs::path& file : files)
    text += "  " + cases::toml_value(file.string()) + ",\n";
  return text + "]\n";
}

std::string refusal_without_lines(const std::string& refusal,
                                  const std::string& made) {
  if (made.empty())
    return refusal;
  const bool has_folder = made.find('/') != std::string::npos;
  std::string text;
  std::size_t begin = 0;
  for (std::size_t at = refusal.find(made); at != std::string::npos;
       at = refusal.find(made, at + 1)) {
    const std::size_t end = at + made.size();
    const bool begins_a_word =
        at == 0 || refusal[at - 1] == ' ' || refusal[at - 1] == '\n';
    const bool is_path = // a map may be called "area"
        refusal.compare(end, 1, ":") == 0 ||
        (has_folder && refusal.compare(end, 1, " ") == 0);
    if (!begins_a_word || !is_path)
      continue;
    text += refusal.substr(begin, at - begin) + "the case of the map";
    begin = end;
    const std::size_t after = refusal.find_first_not_of("0123456789", end + 1);
    if (refusal[end] == ':' && after > end + 1) // the number of a line
      begin = std::min(after, refusal.size());
  }
  return text + refusal.substr(begin);
}

} // namespace asperity::run
