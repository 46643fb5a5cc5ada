#include "input/text/node.hpp"

#include <fmt/format.h>

#include <sstream>

namespace asperity::cases {

double Node::number() const {
  return type == NodeType::integer ? static_cast<double>(integer) : floating;
}

const Node* Node::find(const std::string& key) const {
  for (const NodeEntry& entry : entries)
    if (entry.key == key)
      return &entry.node;
  return nullptr;
}

Node* Node::find(const std::string& key) {
  for (NodeEntry& entry : entries)
    if (entry.key == key)
      return &entry.node;
  return nullptr;
}

const Node* Node::at(const std::string& key_path) const {
  const Node* node = this;
  std::istringstream keys(key_path);
  for (std::string key; node != nullptr && std::getline(keys, key, '.');)
    node = node->find(key);
  return node;
}

std::string written(const Node& node) {
  switch (node.type) {
  case NodeType::boolean:
    return node.boolean ? "true" : "false";
  case NodeType::integer:
    return std::to_string(node.integer);
  case NodeType::floating:
    return fmt::format("{}", node.floating);
  case NodeType::text:
    return "\"" + node.text + "\"";
  case NodeType::list: {
    std::string text = "[";
    for (const Node& element : node.list)
      text += (text.size() > 1 ? ", " : "") + written(element);
    return text + "]";
  }
  case NodeType::table:
    return "a table";
  case NodeType::other:
    return node.text;
  }
  return "";
}

} // namespace asperity::cases
