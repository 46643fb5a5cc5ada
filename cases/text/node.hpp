#pragma once

// A case file after its syntax is understood and before its meaning is: plain
// values, each knowing where it was written. Nothing of TOML's library.

#include "cases/text/case_error.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity::cases {

enum class NodeType { boolean, integer, floating, text, list, table, other };

struct NodeEntry;

/// One value. Only the member its type names is filled.
struct Node {
  NodeType type = NodeType::other;
  bool boolean = false;
  std::int64_t integer = 0;
  double floating = 0.0;
  std::string text; ///< also what to print of an `other` (dates and times)
  std::vector<Node> list;
  std::vector<NodeEntry> entries; ///< of a table, in the order of the file
  Place place;
  std::string path; ///< "surface.length"; "" for the whole file

  bool is_table() const { return type == NodeType::table; }

  bool is_number() const {
    return type == NodeType::integer || type == NodeType::floating;
  }

  /// The number of an integer or a floating node.
  double number() const;

  /// The entry of a table, nullptr if there is none (or this is no table).
  const Node* find(const std::string& key) const;
  Node* find(const std::string& key);
};

struct NodeEntry {
  std::string key;
  Node node;
};

/// The node as TOML would write it, for messages: 14, "14 nm", [1, 2], a table.
std::string written(const Node& node);

} // namespace asperity::cases
