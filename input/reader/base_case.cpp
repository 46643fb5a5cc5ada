#include "input/reader/base_case.hpp"

#include "base/read_file.hpp"
#include "input/input_file.hpp"
#include "input/reader/case_text.hpp"
#include "input/reader/vocabulary.hpp"
#include "input/text/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::cases {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 50; // in a chain of bases

std::string text_of_file(const std::string& path, const Place& asked_at) {
  try {
    return read_file(path, input::largest_text_file);
  } catch (const FileError& error) {
    const bool is_asked_for = asked_at.text == path;
    const std::string what = error.what();
    input::throw_mistake(asked_at, is_asked_for ? what.substr(path.size() + 2)
                                                : "base: " + what);
  }
}

// Returns true for a table that holds keys, such as [fem] or [fem.hard], and
// false for a value that is written as a table, such as a sweep or a band.
bool holds_keys(const Node& table, const NodeEntry& entry) {
  return table.path != "expect" &&
         is_variant(entry, table.path.substr(0, table.path.find('.')));
}

void flatten(const Node& table, const std::string& prefix,
             std::vector<LaidOver>& overrides) {
  for (const NodeEntry& entry : table.entries) {
    const std::string path = prefix + toml_key(entry.key);
    const bool is_gone =
        entry.node.type == NodeType::text && entry.node.text.empty();
    if (holds_keys(table, entry))
      flatten(entry.node, path + ".", overrides);
    else
      overrides.push_back({path + "=" + (is_gone ? "" : toml_value(entry.node)),
                           entry.node.place});
  }
}

// Adds overrides that rewrite the relative paths of the base as seen from the
// other folder.
void move_paths(const Node& base, const fs::path& base_folder,
                std::vector<LaidOver>& overrides) {
  for (const Table& table : vocabulary())
    for (const Key& key : table.keys) {
      const Node* const holder = base.at(table.name);
      const Node* const path =
          holder && key.type == ValueType::path && key.name != "base"
              ? holder->find(key.name)
              : nullptr;
      if (!path || path->type != NodeType::text || path->text.empty() ||
          fs::path(path->text).is_absolute())
        continue;
      Node moved = *path;
      moved.text = (base_folder / path->text).lexically_normal().string();
      overrides.push_back(
          {table.name + "." + key.name + "=" + toml_value(moved), path->place});
    }
}

/// @param above  the files that are based on this one, the case first
StackedText read_level(const std::string& path, const Place& asked_at,
                       std::vector<fs::path> above) {
  const fs::path file_path = fs::weakly_canonical(path);
  if (std::ranges::find(above, file_path) != above.end())
    input::throw_mistake(asked_at, "base refers back to itself in a cycle");
  if (above.size() == most_files)
    input::throw_mistake(
        asked_at, fmt::format("base: the chain of bases has more than {} files",
                              most_files));
  above.push_back(file_path);
  StackedText stacked{text_of_file(path, asked_at), path, {}};
  Node file = parsed_file(stacked.text, path);
  const Node* const base = file.find("base");
  if (!base)
    return stacked;
  if (base->type != NodeType::text || base->text.empty())
    input::throw_mistake(base->place, "base = " + written(*base) +
                                          ", but must be the path of a file");
  if (file.entries.front().key != "base")
    input::throw_mistake(base->place, "base must be the file's first key");
  const fs::path named(base->text);
  const fs::path base_path =
      named.is_absolute() ? named : fs::path(path).parent_path() / named;
  const Place place = base->place;
  const std::vector<std::string> own_lines = overrides_in(stacked.text);
  stacked = read_level(base_path.lexically_normal().string(), place,
                       std::move(above));
  move_paths(parsed(stacked), named.parent_path(), stacked.overrides);
  std::erase_if(file.entries,
                [](const NodeEntry& entry) { return entry.key == "base"; });
  flatten(file, "", stacked.overrides);
  for (const std::string& entry : own_lines)
    stacked.overrides.push_back({entry, {"--set", 0}});
  return stacked;
}

} // namespace

Node parsed_file(const std::string& text, const std::string& path) {
  struct Parsed {
    std::string text, path;
    Node file;
  };

  thread_local Parsed last;
  const std::string_view own = without_overrides(text);
  const bool has_long_strings = own.find("\"\"\"") != std::string_view::npos ||
                                own.find("'''") != std::string_view::npos;
  if (has_long_strings) // of which the last lines may be a part
    return parse_toml(text, path);
  if (own != last.text || path != last.path) {
    Node file = parse_toml(text, path);
    last = {std::string(own), path, std::move(file)};
  }
  return last.file;
}

Node parsed(const StackedText& stacked) {
  Node file = parsed_file(stacked.text, stacked.path);
  Mistakes ignored; // reported when the case is read
  for (const std::string& entry : overrides_in(stacked.text))
    apply_override(file, entry, ignored);
  for (const LaidOver& over : stacked.overrides)
    apply_override(file, over.entry, ignored, over.place);
  return file;
}

StackedText read_stacked(const std::string& path) {
  return read_level(path, {path, 0}, {});
}

} // namespace asperity::cases
