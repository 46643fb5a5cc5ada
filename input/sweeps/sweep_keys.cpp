#include "input/sweeps/sweep_keys.hpp"

#include "input/nearest.hpp"
#include "input/reader/vocabulary.hpp"
#include "input/text/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace asperity::cases {
namespace {

/// Returns the file of "case.toml:12".
std::string_view file_of(const Place& place) {
  return std::string_view(place.text).substr(0, place.text.rfind(':'));
}

/// Reads the keys of [sweep], which may also be written as tables:
/// surface.hurst = [...] or "surface.hurst" = [...].
class KeyReader {
public:
  explicit KeyReader(Mistakes& mistakes) : mistakes_(mistakes) {}

  void read(const Node& table, const std::string& prefix) {
    for (const NodeEntry& entry : table.entries) {
      if (prefix.empty() && entry.key == "combine")
        continue;
      const bool is_path =
          prefix.empty() && entry.key.find('.') != entry.key.npos;
      const std::string key =
          prefix + (is_path ? entry.key : toml_key(entry.key));
      if (entry.node.is_table())
        read(entry.node, key + ".");
      else if (is_key(key, entry.node))
        add(key, entry.node);
    }
  }

  std::vector<WrittenKey> keys;

private:
  bool is_key(const std::string& key, const Node& node) {
    const std::string table = key.substr(0, key.find('.'));
    if (table == key)
      mistakes_.add(
          node.place,
          fmt::format("sweep.{} is unknown; [sweep] has the key "
                      "combine and keys of the case with their "
                      "tables, such as \"surface.hurst\"; nearest: {}",
                      key, nearest_key(key)));
    else if (table == "sweep" ||
             (key.find('"') == key.npos && key.find('=') != key.npos))
      mistakes_.add(node.place,
                    fmt::format("sweep has \"{}\", which is not a key of the "
                                "case, such as \"surface.hurst\"",
                                key));
    else if (node.type != NodeType::list)
      mistakes_.add(node.place,
                    fmt::format("sweep: {} = {}, but must be a list of values: "
                                "[{}]",
                                key, written(node), written(node)));
    else if (node.list.empty())
      mistakes_.add(node.place, fmt::format("sweep: the list of {} is empty; "
                                            "it must have at least one value",
                                            key));
    else
      return true;
    return false;
  }

  static std::string nearest_key(const std::string& key) {
    std::vector<std::string> words{"combine"};
    for (const Table& table : vocabulary())
      for (const Key& known : table.keys)
        if (known.name == key && !table.name.empty() && !table.is_part)
          return fmt::format("\"{}.{}\"", table.name, key);
        else if (!table.name.empty() && !table.is_part)
          words.push_back(known.name);
    return input::nearest(key, words);
  }

  /// A key that is given again replaces the first if it comes from --set or
  /// from a case that builds on the other.
  void add(const std::string& key, const Node& node) {
    const auto known = std::ranges::find(keys, key, &WrittenKey::key);
    if (known == keys.end())
      keys.push_back({key, node.list, node.place});
    else if (file_of(known->place) == file_of(node.place))
      mistakes_.add(node.place, fmt::format("sweep gives {} twice", key));
    else
      *known = {key, node.list, node.place};
  }

  Mistakes& mistakes_;
};

void check_distinct(const WrittenKey& key, Mistakes& mistakes) {
  std::vector<std::string> seen;
  for (const Node& value : key.values) {
    const std::string text = value_text(value);
    if (std::ranges::find(seen, text) != seen.end())
      mistakes.add(value.place, fmt::format("sweep: {} has the value {} twice",
                                            key.key, written(value)));
    seen.push_back(text);
  }
}

void check_lists(const Node& table, const std::vector<WrittenKey>& keys,
                 Combine combine, Mistakes& mistakes) {
  if (keys.empty()) {
    mistakes.add(table.place, "[sweep] has no key to sweep, such as "
                              "\"surface.hurst\" = [0.5, 0.8]");
    return;
  }
  for (const WrittenKey& key : keys)
    if (combine == Combine::product)
      check_distinct(key, mistakes);
    else if (key.values.size() != keys.front().values.size())
      mistakes.add(key.place,
                   fmt::format("sweep: combine = \"zip\" needs lists of equal "
                               "length, but {} has {} values and {} has {}",
                               keys.front().key, keys.front().values.size(),
                               key.key, key.values.size()));
  if (n_points(keys, combine) > most_sweep_points)
    mistakes.add(table.place,
                 fmt::format("[sweep] has more than {} points; use fewer "
                             "values, or combine = \"zip\"",
                             most_sweep_points));
}

/// A key whose value --set gives would be swept all the same.
void check_overrides(const std::vector<WrittenKey>& keys,
                     const std::vector<std::string>& overrides,
                     Mistakes& mistakes) {
  for (const WrittenKey& key : keys)
    for (const std::string& entry : overrides)
      if (entry.starts_with(key.key) && entry.size() > key.key.size() &&
          (entry[key.key.size()] == '=' || entry[key.key.size()] == ' '))
        mistakes.add({"--set", 0},
                     fmt::format("{}, but [sweep] sweeps this key; set "
                                 "sweep.\"{}\" to a list instead",
                                 entry, key.key));
}

} // namespace

std::vector<WrittenKey> read_swept_keys(const Node& table, Mistakes& mistakes) {
  KeyReader reader(mistakes);
  reader.read(table, "");
  return reader.keys;
}

std::string value_text(const Node& node) {
  return node.type == NodeType::text && node.text.empty() ? ""
                                                          : toml_value(node);
}

std::size_t n_points(const std::vector<WrittenKey>& keys, Combine combine) {
  if (combine == Combine::zip)
    return keys.front().values.size();
  std::size_t points = 1;
  for (const WrittenKey& key : keys)
    points =
        std::min(points * std::min(key.values.size(), most_sweep_points + 1),
                 most_sweep_points + 1);
  return points;
}

void check_swept_keys(const Node& table, const std::vector<WrittenKey>& keys,
                      Combine combine,
                      const std::vector<std::string>& overrides,
                      Mistakes& mistakes) {
  check_lists(table, keys, combine, mistakes);
  check_overrides(keys, overrides, mistakes);
}

} // namespace asperity::cases
