#include "input/reader/resolved_keys.hpp"

#include "input/reader/vocabulary.hpp"
#include "input/text/toml_text.hpp"

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace asperity::cases {
namespace {

using mechanics::Quantity;
using mechanics::ReferenceUnit;
using mechanics::Scales;

Node number_node(double number) {
  Node node;
  node.type = NodeType::floating;
  node.floating = number;
  return node;
}

/// Converts the values of a case to SI units.
class Resolver {
public:
  Resolver(const Case& read, const Scales& scales)
      : case_(read), scales_(scales) {}

  /// Returns the value of a key; tables and lists are converted throughout.
  Node value(const Node& given, const Key& key) const {
    switch (key.type) {
    case ValueType::quantity:
    case ValueType::target:
      return key.dimension == Dimension::none ? given : quantity(given, key);
    case ValueType::program:
      return program();
    case ValueType::layers:
      return layers(given);
    default:
      return given;
    }
  }

private:
  Node quantity(const Node& given, const Key& key) const {
    if (given.type != NodeType::text)
      return given;
    const QuantityReading reading =
        read_quantity(given.text, key.dimension, key.references);
    if (!reading.quantity)
      return given;
    const std::optional<double> in_si = value_in_si(*reading.quantity);
    return in_si ? number_node(*in_si) : given;
  }

  /// Returns nothing if the scale of the quantity is not known.
  std::optional<double> value_in_si(const Quantity& quantity) const {
    try {
      return quantity.in_si(scales_);
    } catch (const std::domain_error&) {
      return std::nullopt;
    }
  }

  /// Returns the loads of all steps.
  Node program() const {
    Node list;
    list.type = NodeType::list;
    for (const Quantity& target : case_.load.targets) {
      const std::optional<double> in_si = value_in_si(target);
      Node node = number_node(in_si.value_or(0.0));
      if (!in_si) {
        std::ostringstream text;
        text << target.value << ' ' << reference_symbol(target.reference);
        node.type = NodeType::text;
        node.text = text.str();
      }
      list.list.push_back(std::move(node));
    }
    return list;
  }

  Node layers(const Node& given) const {
    const Table& table = vocabulary_table("material.layer");
    Node list = given;
    for (Node& layer : list.list)
      for (NodeEntry& entry : layer.entries)
        for (const Key& key : table.keys)
          if (key.name == entry.key)
            entry.node = value(entry.node, key);
    return list;
  }

  const Case& case_;
  const Scales& scales_;
};

std::string unit_of(const Key& key, const Node& value) {
  const Node& one = value.type == NodeType::list && !value.list.empty()
                        ? value.list.front()
                        : value;
  const bool is_measured = key.type == ValueType::quantity ||
                           key.type == ValueType::target ||
                           key.type == ValueType::program;
  return is_measured && one.is_number() && key.dimension != Dimension::none
             ? si_unit(key.dimension)
             : "";
}

/// Lists the keys of one table of the case after another.
class KeyLister {
public:
  KeyLister(const Case& read, const Scales& scales)
      : file_(*read.file), resolver_(read, scales) {
    const Node* const kind = file_.at("surface.kind");
    kind_ = kind ? kind->text : "";
  }

  std::vector<ResolvedKey> list() {
    for (const Table& table : vocabulary()) {
      if (table.is_part)
        continue;
      const Node* const node = file_.at(table.name);
      const bool is_always = std::ranges::all_of(
          table.keys, [](const Key& key) { return !key.fallback.empty(); });
      if (node == nullptr && is_always)
        add_table(table, Node{}, table.name);
      if (node == nullptr)
        continue;
      add_table(table, *node, table.name);
      if (table.is_method)
        add_variants(table, *node);
    }
    return std::move(keys_);
  }

private:
  void add(const std::string& path, Node value, const std::string& unit,
           const std::string& written) {
    keys_.push_back({path, std::move(value), unit, written});
  }

  void add_table(const Table& table, const Node& node,
                 const std::string& path) {
    const std::string prefix = path.empty() ? "" : path + ".";
    for (const Key& key : table.keys) {
      const Node* const given = node.find(key.name);
      if (given == nullptr && (key.fallback.empty() || !key.applies_to(kind_)))
        continue;
      const Node value = resolver_.value(
          given ? *given : parse_toml_value(key.fallback, {"default", 0}, path),
          key);
      add(prefix + key.name, value, unit_of(key, value),
          given ? toml_value(*given) : "");
    }
    for (const NodeEntry& entry : node.entries) // quantities at a load
      if (!entry.node.is_table() || path == "expect")
        if (!path.empty() && find_key(table.name, entry.key) == nullptr)
          add(prefix + toml_key(entry.key), entry.node, "",
              toml_value(entry.node));
  }

  /// Adds the keys of each variant, [fem.hard], with those it inherits.
  void add_variants(const Table& table, const Node& base) {
    for (const NodeEntry& entry : base.entries)
      if (is_variant(entry, table.name))
        add_table(table, method_table(base, table.name, &entry.node),
                  table.name + "." + entry.key);
  }

  const Node& file_;
  Resolver resolver_;
  std::string kind_;
  std::vector<ResolvedKey> keys_;
};

} // namespace

std::vector<ResolvedKey> resolved_keys(const Case& read,
                                       const mechanics::Scales& scales) {
  return KeyLister(read, scales).list();
}

} // namespace asperity::cases
