#include "run/arguments/map_case.hpp"

#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/reader/read_case.hpp"
#include "input/text/toml_text.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "run/arguments/case_library.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/measured_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <sstream>
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
poisson_ratio = 0.3 # needed by [fem] and [friction] only

[load]
nominal_pressure = {{ from = "0.01 E* h'", to = "1 E* h'", steps = 12, spacing = "area" }}

# Persson's theory with the spectrum of the map.
[theory]
gamma = 0.4

[halfspace]

# The elastic block by finite elements takes longer:
# [fem]
)";

/// A case as lines of text, of which keys are replaced.
class CaseLines {
public:
  explicit CaseLines(const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
      lines_.push_back(line);
  }

  /// @param entry  "table.key=value"; an empty value removes the key, and
  ///               "table=" the table
  void put(const std::string& entry) {
    const std::size_t equals = entry.find('=');
    const std::size_t dot = entry.rfind('.', equals);
    if (dot == entry.npos)
      return remove_table("[" + entry.substr(0, equals) + "]");
    const std::string value = entry.substr(equals + 1);
    const std::string key = entry.substr(dot + 1, equals - dot - 1) + " = ";
    const auto table = table_called("[" + entry.substr(0, dot) + "]");
    auto end =
        std::find_if(table + 1, lines_.end(), [](const std::string& line) {
          return line.starts_with('[');
        });
    const auto found =
        std::find_if(table + 1, end, [&](const std::string& line) {
          return line.starts_with(key);
        });
    if (found != end && value.empty())
      lines_.erase(found);
    else if (found != end)
      *found = key + value;
    else if (!value.empty()) {
      while (end[-1].empty() || end[-1].starts_with('#'))
        --end;
      lines_.insert(end, key + value);
    }
  }

  std::string text() const {
    return fmt::format("{}\n", fmt::join(lines_, "\n"));
  }

private:
  /// Removes a table with the comment before it and the empty line behind it.
  void remove_table(const std::string& head) {
    auto begin = std::ranges::find(lines_, head);
    if (begin == lines_.end())
      return;
    const auto end = std::find(begin, lines_.end(), "") + 1;
    while (begin[-1].starts_with('#'))
      --begin;
    lines_.erase(begin, end);
  }

  std::vector<std::string>::iterator table_called(const std::string& head) {
    if (const auto found = std::ranges::find(lines_, head);
        found != lines_.end())
      return found;
    lines_.insert(lines_.end(), {"", head});
    return lines_.end() - 1;
  }

  std::vector<std::string> lines_;
};

bool is_of(const std::vector<std::string>& entries, const std::string& key) {
  return std::ranges::any_of(entries, [&](const std::string& entry) {
    return entry.starts_with(key + "=");
  });
}

std::string titled_case_text(const fs::path& file, const std::string& title,
                             const std::vector<std::string>& entries) {
  CaseLines lines(fmt::format(
      fmt::runtime(text_of_case), fmt::arg("title", cases::toml_value(title)),
      fmt::arg("file", cases::toml_value(file.string()))));
  if (is_of(entries, "material.youngs_modulus")) // nu is part of its E*
    lines.put("material.poisson_ratio=");
  for (const std::string& entry : entries)
    lines.put(entry);
  return lines.text();
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
      maps.left_out.push_back(path.string() +
                              (fs::is_directory(path, unreadable)
                                   ? ": is a folder"
                                   : ": is a case file"));
    else
      refuse_entry(path);
  }
  std::ranges::sort(maps.files.begin() + static_cast<std::ptrdiff_t>(n_before),
                    maps.files.end());
  if (maps.files.size() == n_before)
    throw input::InputError(folder + ": is a folder without maps");
  maps.folders.push_back(folder);
}

/// Whether a refusal to read a map names what the map needs; otherwise it is
/// none.
bool is_of_a_map(const std::string& refusal) {
  return refusal.starts_with("surface.") ||
         std::ranges::any_of(std::array{"--missing-value",
                                        "surface.max_missing", "surface.fill",
                                        "surface.cut_off"},
                             [&](const char* key) {
                               return refusal.find(key) != refusal.npos;
                             });
}

} // namespace

bool is_map_file(const std::string& word) {
  std::error_code unreadable;
  return fs::is_regular_file(word, unreadable) &&
         fs::path(word).extension() != ".toml";
}

fs::path path_of_map(const std::string& file, const std::string& folder) {
  return folder.empty()
             ? fs::absolute(file).lexically_normal()
             : fs::relative(fs::absolute(file), fs::absolute(folder));
}

std::string map_case_text(const fs::path& file,
                          const std::vector<std::string>& entries) {
  return titled_case_text(file, file.filename().string(), entries);
}

mechanics::SurfaceSpec map_surface(const std::string& file,
                                   const CaseOptions& options,
                                   const std::vector<std::string>& overrides) {
  input::Refusals refusals;
  std::vector<std::string> entries = options.overrides(
      {.are_maps = true, .group = input::OptionGroup::map}, refusals);
  refusals.throw_if_any();
  entries.emplace_back("material.contact_modulus=1.0");
  std::vector<std::string> of_surface;
  for (const std::string& entry : overrides)
    if (entry.starts_with("surface"))
      of_surface.push_back(entry);
  return cases::read_case_text(map_case_text(path_of_map(file), entries), file,
                               of_surface)
      .surface;
}

std::optional<double> contact_modulus_of(const CaseOptions& options) {
  input::Refusals refusals;
  const std::vector<std::string> entries = options.overrides(
      {.are_maps = true, .group = input::OptionGroup::body}, refusals);
  refusals.throw_if_any();
  if (entries.empty())
    return std::nullopt;
  try {
    return cases::read_case_text(map_case_text("map", entries), "map")
        .material.contact_modulus;
  } catch (const input::InputError& error) {
    throw input::InputError(
        options.with_options(refusal_without_lines(error.what(), "map"), true));
  }
}

NamedMaps maps_among(const std::vector<std::string>& words) {
  NamedMaps maps;
  for (const std::string& word : words) {
    std::error_code unreadable;
    if (is_map_file(word))
      maps.files.push_back(fs::absolute(word).lexically_normal());
    else if (fs::is_directory(word, unreadable) && !is_folder_of_cases(word) &&
             !is_shipped(word))
      add_maps_in(word, maps);
    else
      return {};
  }
  return maps;
}

void read_each(NamedMaps& maps,
               const std::function<void(const fs::path&)>& read) {
  std::vector<std::string> refusals;
  std::vector<std::string> no_maps;
  std::vector<fs::path> found;
  for (const fs::path& file : maps.files)
    try {
      read(file);
      found.push_back(file);
    } catch (const input::InputError& error) {
      const std::string refusal = error.what();
      const bool may_be_left = !maps.folders.empty() && !is_of_a_map(refusal);
      (may_be_left ? no_maps : refusals).push_back(refusal);
    }
  if (found.empty() && refusals.empty())
    refusals = std::exchange(no_maps, {});
  if (!refusals.empty())
    throw input::InputError(fmt::format("{}", fmt::join(refusals, "\n")));
  maps.files = std::move(found);
  std::ranges::move(no_maps, std::back_inserter(maps.left_out));
}

void print_left_out(const NamedMaps& maps) {
  for (const std::string& one : maps.left_out)
    fmt::print(stderr, "left out, no map: {}\n", one);
}

std::pair<double, double> examine_maps(NamedMaps& maps,
                                       mechanics::SurfaceSpec surface) {
  std::pair<double, double> slopes{std::numeric_limits<double>::infinity(),
                                   0.0};
  read_each(maps, [&](const fs::path& file) {
    surface.file = file.string();
    const double slope =
        surfaces::statistics(
            surfaces::with_edges(surfaces::levelled_map(surface),
                                 surfaces::continuation_of(surface)))
            .rms_slope;
    slopes.first = std::min(slopes.first, slope);
    slopes.second = std::max(slopes.second, slope);
  });
  return slopes;
}

std::string maps_sweep_text(const std::vector<fs::path>& files,
                            const std::vector<std::string>& entries) {
  std::string text =
      titled_case_text(files.front(),
                       fmt::format("{} measured maps", files.size()), entries) +
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
