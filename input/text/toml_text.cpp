#include "input/text/toml_text.hpp"

#include "base/plain_text.hpp"
#include "input/text/toml_limits.hpp"

#include <fmt/format.h>
#include <toml.hpp>

#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace asperity::cases {
namespace {

// Shortens an error message of toml11, which has several lines. The first is
// like "[error] toml::parse_table: invalid line format", a later one like "
// ^--- expected newline".
std::string short_reason(const std::string& explanation) {
  std::istringstream lines(explanation);
  std::string reason;
  std::string line;
  std::getline(lines, reason);
  reason.erase(0, std::min(reason.find(' ') + 1, reason.size()));
  if (reason.rfind("toml::", 0) == 0)
    reason.erase(0, reason.find(": ") + 2);
  std::string hint;
  while (std::getline(lines, line))
    if (const auto caret = line.find("^--- "); caret != std::string::npos)
      hint = " (" + line.substr(caret + 5) + ")";
  return reason + hint;
}

/// The file from which values are read, with the positions of its line ends.
/// The library would count the lines from the start of the text and copy the
/// line for each value.
class Source {
public:
  Source(const std::string& text, std::string name) : name_(std::move(name)) {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n')
        line_ends_.push_back(i);
  }

  Place place_of(const toml::value& value) const {
    const auto* const region = dynamic_cast<const toml::detail::region*>(
        toml::detail::get_region(value));
    const int line = region == nullptr
                         ? static_cast<int>(value.location().line())
                         : line_at(region->first() - region->begin());
    return {name_ + ":" + std::to_string(line), line};
  }

private:
  int line_at(std::ptrdiff_t offset) const {
    const auto end = std::lower_bound(line_ends_.begin(), line_ends_.end(),
                                      static_cast<std::size_t>(offset));
    return 1 + static_cast<int>(end - line_ends_.begin());
  }

  std::string name_;
  std::vector<std::size_t> line_ends_;
};

Node node_from(const toml::value& value, const Source& file,
               const std::string& path);

/// An escape such as \\u0000 can put into a text what the file must not
/// contain.
void require_plain(const std::string& text, const Place& place,
                   const std::string& what) {
  if (find_not_plain(text) != text.npos)
    input::throw_mistake(place,
                         fmt::format("{} = \"{}\", but must be UTF-8 text "
                                     "without control characters",
                                     what, printable(text)));
}

void fill_table(Node& node, const toml::value& value, const Source& file) {
  for (const auto& [key, entry] : value.as_table()) {
    const std::string path = node.path.empty() ? key : node.path + "." + key;
    require_plain(key, file.place_of(entry), "a key");
    node.entries.push_back({key, node_from(entry, file, path)});
  }
  std::sort(node.entries.begin(), node.entries.end(),
            [](const NodeEntry& a, const NodeEntry& b) {
              return std::pair(a.node.place.line, a.key) <
                     std::pair(b.node.place.line, b.key);
            });
}

void fill_integer(Node& node, std::int64_t integer) {
  // toml11 returns the largest integer for all values that exceed it.
  if (integer == std::numeric_limits<std::int64_t>::max()) {
    node.text = "an integer beyond 64 bits";
    return;
  }
  node.type = NodeType::integer;
  node.integer = integer;
}

Node node_from(const toml::value& value, const Source& file,
               const std::string& path) {
  Node node;
  node.path = path;
  node.place = file.place_of(value);
  if (value.is_boolean()) {
    node.type = NodeType::boolean;
    node.boolean = value.as_boolean();
  } else if (value.is_integer()) {
    fill_integer(node, value.as_integer());
  } else if (value.is_floating()) {
    node.type = NodeType::floating;
    node.floating = value.as_floating();
  } else if (value.is_string()) {
    node.type = NodeType::text;
    node.text = value.as_string().str;
    require_plain(node.text, node.place, path);
  } else if (value.is_array()) {
    node.type = NodeType::list;
    for (const toml::value& element : value.as_array())
      node.list.push_back(node_from(element, file, path));
  } else if (value.is_table()) {
    node.type = NodeType::table;
    fill_table(node, value, file);
  } else {
    node.text = "a date or time";
  }
  return node;
}

void move_to(Node& node, const Place& place, const std::string& path) {
  node.place = place;
  node.path = path;
  for (Node& element : node.list)
    move_to(element, place, path);
  for (NodeEntry& entry : node.entries)
    move_to(entry.node, place, path + "." + entry.key);
}

Node value_or_text(const std::string& text, const Place& place,
                   const std::string& path) {
  try {
    return parse_toml_value(text, place, path);
  } catch (const input::InputError&) { // not TOML: a string without quotes
    Node node;
    node.type = NodeType::text;
    node.text = text;
    move_to(node, place, path);
    return node;
  }
}

// Returns the position of `letter` outside quotes, searched from `start`; npos
// if there is none.
std::size_t find_unquoted(const std::string& text, char letter,
                          std::size_t start = 0) {
  bool is_quoted = false;
  for (std::size_t i = start; i < text.size(); ++i) {
    if (text[i] == '"')
      is_quoted = !is_quoted;
    else if (text[i] == letter && !is_quoted)
      return i;
  }
  return std::string::npos;
}

std::string without_quotes(const std::string& key) {
  const bool is_quoted =
      key.size() >= 2 && key.front() == '"' && key.back() == '"';
  return is_quoted ? key.substr(1, key.size() - 2) : key;
}

std::vector<std::string> split_at_dots(const std::string& path) {
  std::vector<std::string> keys;
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t dot =
        std::min(find_unquoted(path, '.', start), path.size());
    keys.push_back(without_quotes(trimmed(path.substr(start, dot - start))));
    start = dot + 1;
  }
  return keys;
}

void put(Node& table, const std::string& key, Node node) {
  if (Node* const present = table.find(key))
    *present = std::move(node);
  else
    table.entries.push_back({key, std::move(node)});
}

// Returns the table that holds the last key of the path. Missing tables are
// created; nullptr is returned after reporting a mistake.
Node* table_for(Node& file, const std::vector<std::string>& keys,
                const Place& place, Mistakes& mistakes) {
  Node* table = &file;
  for (std::size_t level = 0; level + 1 < keys.size(); ++level) {
    const std::string path =
        table->path.empty() ? keys[level] : table->path + "." + keys[level];
    if (!table->find(keys[level])) {
      Node made;
      made.type = NodeType::table;
      move_to(made, place, path);
      put(*table, keys[level], std::move(made));
    }
    table = table->find(keys[level]);
    if (!table->is_table()) {
      mistakes.add(place, path + " is not a table, but " + written(*table));
      return nullptr;
    }
  }
  return table;
}

} // namespace

Node parse_toml(const std::string& text, const std::string& path,
                const std::string& name) {
  if (const auto broken = broken_limit(text))
    input::throw_mistake(
        {broken->line == 0 ? path : path + ":" + std::to_string(broken->line),
         broken->line},
        broken->what, name);
  std::istringstream stream(text);
  try {
    return node_from(toml::parse(stream, path), Source(text, path), "");
  } catch (const toml::syntax_error& error) {
    const int line = static_cast<int>(error.location().line());
    input::throw_mistake({path + ":" + std::to_string(line), line},
                         "is not TOML: " + short_reason(error.what()), name);
  }
}

Node parse_toml_value(const std::string& text, const Place& place,
                      const std::string& path) {
  const Node file = parse_toml("value = " + text, place.text);
  if (file.entries.size() != 1)
    input::throw_mistake(place, "more than one value: " + text);
  Node node = file.entries.front().node;
  move_to(node, place, path);
  return node;
}

std::string toml_key(const std::string& key) {
  const bool is_bare =
      !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-';
      });
  return is_bare ? key : "\"" + key + "\"";
}

std::string toml_value(const Node& node) {
  switch (node.type) {
  case NodeType::text: {
    std::string quoted = "\"";
    for (const char letter : node.text) {
      const auto code = static_cast<unsigned char>(letter);
      if (code < 0x20 || code == 0x7f)
        quoted += fmt::format("\\u{:04x}", code);
      else
        quoted +=
            (letter == '"' || letter == '\\' ? "\\" : "") + std::string{letter};
    }
    return quoted + "\"";
  }
  case NodeType::floating: {
    const std::string digits = fmt::format("{}", node.floating);
    const bool is_whole =
        digits.find_first_not_of("-0123456789") == digits.npos;
    return is_whole ? digits + ".0" : digits;
  }
  case NodeType::list: {
    std::string list;
    for (const Node& element : node.list)
      list += (list.empty() ? "" : ", ") + toml_value(element);
    return "[" + list + "]";
  }
  case NodeType::table: {
    std::string table;
    for (const NodeEntry& entry : node.entries)
      table += (table.empty() ? " " : ", ") + toml_key(entry.key) + " = " +
               toml_value(entry.node);
    return "{" + table + " }";
  }
  default:
    return written(node);
  }
}

std::string toml_value(const std::string& text) {
  Node node;
  node.type = NodeType::text;
  node.text = text;
  return toml_value(node);
}

void apply_override(Node& file, const std::string& override_text,
                    Mistakes& mistakes, const Place& place) {
  if (const auto broken = broken_limit(override_text)) {
    mistakes.add(place,
                 "\"" + override_text.substr(0, 40) + "...\" " + broken->what);
    return;
  }
  const auto equals = find_unquoted(override_text, '=');
  const std::string path = trimmed(override_text.substr(0, equals));
  const std::vector<std::string> keys = split_at_dots(path);
  const bool has_empty_key =
      keys.empty() || std::find(keys.begin(), keys.end(), "") != keys.end();
  if (equals == std::string::npos || has_empty_key ||
      override_text.find('\n') != std::string::npos) {
    mistakes.add(place, "\"" + override_text +
                            "\" must have the form key.path=value on one line");
    return;
  }
  Node* const table = table_for(file, keys, place, mistakes);
  if (!table)
    return;
  const std::string value = trimmed(override_text.substr(equals + 1));
  if (value.empty())
    std::erase_if(table->entries, [&](const NodeEntry& entry) {
      return entry.key == keys.back();
    });
  else {
    Node node = value_or_text(value, place, path);
    if (node.type == NodeType::boolean || node.is_number())
      node.text = value; // for a key whose value is a text
    put(*table, keys.back(), std::move(node));
  }
}

} // namespace asperity::cases
