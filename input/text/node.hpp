#pragma once

// The parsed syntax tree of a case file before it is interpreted: plain values
// with their place in the file. It does not depend on the TOML library.

#include "input/input_error.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity::cases {

using input::Mistakes;
using input::Place;

enum class NodeType { boolean, integer, floating, text, list, table, other };

struct NodeEntry;

/// One value. Only the member for its type is set.
struct Node {
  NodeType type = NodeType::other;
  bool boolean = false;
  std::int64_t integer = 0;
  double floating = 0.0;
  /// Of `other`, the text for messages (dates and times); of a number or a
  /// boolean that an override gives, what was written.
  std::string text;
  std::vector<Node> list;
  std::vector<NodeEntry> entries; ///< entries of a table, in the order of the
                                  ///< file
  Place place;
  std::string path; ///< "surface.length"; "" for the whole file

  bool is_table() const { return type == NodeType::table; }

  bool is_number() const {
    return type == NodeType::integer || type == NodeType::floating;
  }

  /// Returns the number of an integer or floating-point node.
  double number() const;

  /// Returns the entry of a table, or nullptr if there is none or if this is
  /// not a table.
  const Node* find(const std::string& key) const;
  Node* find(const std::string& key);

  /// Returns the node at a path such as "material.variation"; nullptr if there
  /// is none, this node for "".
  const Node* at(const std::string& key_path) const;
};

struct NodeEntry {
  std::string key;
  Node node;
};

/// Returns the node in TOML notation for messages: 14, "14 nm", [1, 2] or "a
/// table".
std::string written(const Node& node);

} // namespace asperity::cases
