#include "run/arguments/map_case.hpp"

#include "cases/text/node.hpp"
#include "cases/text/toml_text.hpp"
#include "input/input_error.hpp"
#include "run/arguments/option_quantity.hpp"

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

std::string quoted(const std::string& text) {
  cases::Node node;
  node.type = cases::NodeType::text;
  node.text = text;
  return cases::toml_value(node);
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
  return fmt::format(fmt::runtime(text_of_case),
                     fmt::arg("title", quoted(title)),
                     fmt::arg("file", quoted(map_path(map).string())),
                     fmt::arg("modulus", quoted(map.contact_modulus)));
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
    overrides.push_back("surface.length=" + quoted(length));
  }
  if (!height_unit.empty())
    overrides.push_back("surface.height_unit=" +
                        quoted(length_unit_text("--height-unit", height_unit)));
  return overrides;
}

std::string map_case_text(const MapOfCase& map) {
  return titled_case_text(map, fs::path(map.file).filename().string());
}

std::vector<fs::path> maps_among(const std::vector<std::string>& words) {
  std::vector<fs::path> files;
  for (const std::string& word : words) {
    std::error_code unreadable;
    if (is_map_file(word)) {
      files.push_back(fs::absolute(word).lexically_normal());
      continue;
    }
    if (!fs::is_directory(word, unreadable))
      return {};
    std::vector<fs::path> inside;
    for (const fs::directory_entry& entry : fs::directory_iterator(word)) {
      const fs::path& path = entry.path();
      if (path.extension() == ".toml")
        return {}; // the folder of a case
      if (is_map_file(path.string()) &&
          !path.filename().string().starts_with('.'))
        inside.push_back(fs::absolute(path).lexically_normal());
    }
    std::ranges::sort(inside);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

std::string maps_sweep_text(const std::vector<fs::path>& files,
                            const std::string& contact_modulus) {
  std::string text =
      titled_case_text({files.front().string(), contact_modulus},
                       fmt::format("{} measured maps", files.size())) +
      "\n# Each map is a point: docs/reference/sweeps.md.\n[sweep]\n"
      "\"surface.file\" = [\n";
  for (const fs::path& file : files)
    text += "  " + quoted(file.string()) + ",\n";
  return text + "]\n";
}

} // namespace asperity::run
