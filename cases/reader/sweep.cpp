#include "cases/reader/sweep.hpp"

#include "cases/reader/base_case.hpp"
#include "cases/reader/read_case.hpp"
#include "cases/reader/table_reader.hpp"
#include "cases/text/nearest.hpp"
#include "cases/text/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace asperity::cases {
namespace {

/// A swept key as it is written, before its values are combined.
struct WrittenKey {
  std::string key;
  std::vector<Node> values;
  Place place;
};

StackedText stacked_with(const std::string& path,
                         const std::vector<std::string>& overrides) {
  StackedText stacked = read_stacked(path);
  for (const std::string& entry : overrides)
    stacked.overrides.push_back({entry, {"--set", 0}});
  return stacked;
}

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
    return nearest(key, words);
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

std::string value_text(const Node& node) {
  return node.type == NodeType::text && node.text.empty() ? ""
                                                          : toml_value(node);
}

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

/// Returns the number of points; more than most_sweep_points if there are too
/// many of them.
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

void check_together(const Node& table, const std::vector<WrittenKey>& keys,
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

std::vector<std::vector<std::size_t>>
choices_of(const std::vector<WrittenKey>& keys, Combine combine) {
  std::vector<std::vector<std::size_t>> choices(n_points(keys, combine));
  for (std::size_t point = 0; point < choices.size(); ++point) {
    std::size_t rest = point;
    choices[point].assign(keys.size(), point);
    if (combine == Combine::product)
      for (std::size_t k = keys.size(); k-- > 0;
           rest /= keys[k].values.size() == 0 ? 1 : keys[k].values.size())
        choices[point][k] = rest % keys[k].values.size();
  }
  return choices;
}

std::string title_text(const std::string& title) {
  Node text;
  text.type = NodeType::text;
  text.text = title;
  return toml_value(text);
}

/// The words of an error after its first line, "1 mistake in the case file:".
std::string mistakes_in(const CaseError& error) {
  const std::string whole = error.what();
  const std::size_t end = whole.find('\n');
  return end == std::string::npos ? whole : whole.substr(end + 1);
}

/// Reads the points. The mistakes of the first point that is no valid case are
/// reported, and how many others there are.
class PointReader {
public:
  PointReader(CaseSweep& sweep, const std::vector<WrittenKey>& written_keys,
              const StackedText& stacked)
      : sweep_(sweep), written_(written_keys), stacked_(stacked) {}

  void read() {
    const auto choices = choices_of(written_, sweep_.combine);
    for (const std::vector<std::size_t>& choice : choices)
      read_point(choice);
    if (bad_points_ > 0)
      throw CaseError(fmt::format(
          "{}: {} of the {} points of [sweep] {} not a valid case. {}",
          sweep_.path, bad_points_, choices.size(),
          bad_points_ == 1 ? "is" : "are", first_mistake_));
  }

private:
  void read_point(const std::vector<std::size_t>& choice) {
    SweptPoint point{choice, {}, {}};
    StackedText whole = stacked_;
    const auto add = [&](const std::string& entry, const Place& place) {
      whole.overrides.push_back({entry, place});
      point.overrides.push_back(entry);
    };
    add("sweep=", {sweep_.path, 0});
    for (std::size_t k = 0; k < written_.size(); ++k)
      add(sweep_.keys[k].key + "=" + sweep_.keys[k].values[choice[k]],
          written_[k].values[choice[k]].place);
    const std::string label = point_label(sweep_.keys, choice);
    add("title=" + title_text(sweep_.title + ": " + label), {sweep_.path, 0});
    try {
      point.contact_case = read_stacked_case(whole, sweep_.path);
    } catch (const CaseError& error) {
      if (bad_points_++ == 0)
        first_mistake_ = fmt::format("Point {}, {}:\n{}", sweep_.points.size(),
                                     label, mistakes_in(error));
    }
    sweep_.points.push_back(std::move(point));
  }

  CaseSweep& sweep_;
  const std::vector<WrittenKey>& written_;
  const StackedText& stacked_;
  std::size_t bad_points_ = 0;
  std::string first_mistake_;
};

Combine read_combine(const Node& table, Mistakes& mistakes) {
  Node own =
      table; // without the swept keys, which the vocabulary does not list
  std::erase_if(own.entries,
                [](const NodeEntry& entry) { return entry.key != "combine"; });
  TableReader reader(own, vocabulary_table("sweep"), mistakes);
  return reader.choice("combine", Combine::product);
}

} // namespace

std::string point_label(const std::vector<SweptKey>& keys,
                        const std::vector<std::size_t>& choice) {
  std::string label;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const std::string& value = keys[k].values[choice[k]];
    label += fmt::format("{}{} {}", k == 0 ? "" : ", ", keys[k].key,
                         value.empty() ? "removed" : "= " + value);
  }
  return label;
}

std::string point_content(const std::string& text) {
  Node file = parsed({text, "point", {}});
  std::erase_if(file.entries,
                [](const NodeEntry& entry) { return entry.key == "sweep"; });
  return toml_value(file);
}

bool is_sweep(const std::string& path,
              const std::vector<std::string>& overrides) {
  return parsed(stacked_with(path, overrides)).find("sweep") != nullptr;
}

CaseSweep read_sweep(const std::string& path,
                     const std::vector<std::string>& overrides) {
  const StackedText stacked = stacked_with(path, overrides);
  const Node file = parsed(stacked);
  const Node* const table = file.find("sweep");
  if (table == nullptr)
    throw_mistake({path, 0}, "the table [sweep] is missing");
  if (!table->is_table())
    throw_mistake(table->place, "sweep = " + written(*table) +
                                    ", but must be a table: [sweep]");
  Mistakes mistakes;
  CaseSweep sweep;
  sweep.path = path;
  sweep.name = case_name(path);
  const Node* const title = file.find("title");
  sweep.title = title != nullptr && title->type == NodeType::text ? title->text
                                                                  : sweep.name;
  sweep.combine = read_combine(*table, mistakes);
  KeyReader keys(mistakes);
  keys.read(*table, "");
  mistakes.throw_if_any();
  check_together(*table, keys.keys, sweep.combine, mistakes);
  check_overrides(keys.keys, overrides, mistakes);
  mistakes.throw_if_any();
  for (const WrittenKey& key : keys.keys) {
    sweep.keys.push_back({key.key, {}});
    for (const Node& value : key.values)
      sweep.keys.back().values.push_back(value_text(value));
  }
  PointReader(sweep, keys.keys, stacked).read();
  return sweep;
}

} // namespace asperity::cases
