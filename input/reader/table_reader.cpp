#include "input/reader/table_reader.hpp"

#include "input/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace asperity::cases {
namespace {

/// Returns where a key belongs that is unknown in a table: inside a value of
/// this table, or in other tables; empty if there is no such key.
std::string home_of_key(const std::string& key, const std::string& path) {
  std::string homes;
  for (const Table& table : vocabulary()) {
    if (table.name.empty() || find_key(table.name, key) == nullptr)
      continue;
    if (!table.is_part)
      homes += (homes.empty() ? "[" : " or [") + table.name + "]";
    else if (table.name.rfind(path + ".", 0) == 0) {
      std::string place = table.when.substr(0, table.when.find('.'));
      place.front() = static_cast<char>(std::tolower(place.front()));
      return place;
    }
  }
  return homes;
}

} // namespace

TableReader::TableReader(const Node& node, const Table& vocabulary,
                         Mistakes& mistakes, std::string folder)
    : node_(node),
      vocabulary_(vocabulary),
      mistakes_(mistakes),
      folder_(std::move(folder)) {}

TableReader TableReader::part(const Node& node,
                              const std::string& vocabulary) const {
  TableReader reader(node, vocabulary_table(vocabulary), mistakes_, folder_);
  reader.refuse_unknown();
  return reader;
}

void TableReader::read_members(std::type_index owner, void* settings) {
  const std::string& kind = said_by("kind").text;
  bool has_any = false;
  for (const Key& key : vocabulary_.keys)
    if (key.owner == owner) {
      has_any = true;
      if (key.applies_to(kind))
        key.read(*this, key, settings);
    }
  if (!has_any)
    throw std::logic_error(
        fmt::format("no key of [{}] is a member of the settings {}",
                    vocabulary_.name, owner.name()));
}

std::string TableReader::path_of(const std::string& key) const {
  return node_.path.empty() ? key : node_.path + "." + key;
}

const Key& TableReader::key_called(const std::string& name) const {
  return vocabulary_key(vocabulary_, name);
}

bool TableReader::has(const std::string& key) const {
  return node_.find(key) != nullptr;
}

const Node* TableReader::entry(const std::string& name) {
  if (const Node* const present = node_.find(name))
    return present;
  complain_missing(name);
  return nullptr;
}

mechanics::Quantity TableReader::quantity_in(const Node& node, const Key& key) {
  mechanics::Quantity quantity;
  if (node.is_number()) {
    quantity.value = node.number();
  } else if (node.type == NodeType::text && key.dimension != Dimension::none) {
    const QuantityReading reading =
        read_quantity(node.text, key.dimension, key.references);
    if (!reading.quantity) {
      complain(node, "= " + written(node) + " " + reading.mistake +
                         (key.words.empty()
                              ? ""
                              : "; or it is \"" + key.words.front() + '"'));
      return {};
    }
    quantity = *reading.quantity;
  } else {
    refuse(node, "must be " + allowed_text(key));
    return {};
  }
  const bool is_si = quantity.reference == mechanics::ReferenceUnit::si;
  const std::string unit =
      is_si ? si_unit(key.dimension) : reference_symbol(quantity.reference);
  if (!key.range.contains(quantity.value)) {
    refuse(node, key.range.sentence(unit));
    return {};
  }
  const Range limits = magnitudes(key.dimension, quantity.reference);
  if (quantity.value != 0.0 && !limits.contains(std::abs(quantity.value))) {
    refuse(node, fmt::format("must {}have a magnitude {}",
                             key.range.contains(0.0) ? "be 0 or " : "",
                             limits.limits(unit)));
    return {};
  }
  return quantity;
}

mechanics::Quantity TableReader::quantity(const std::string& key) {
  const Node* const found = entry(key);
  return found ? quantity_in(*found, key_called(key)) : mechanics::Quantity{};
}

double TableReader::number(const std::string& key) {
  return quantity(key).value;
}

int TableReader::integer(const std::string& name) {
  const Node* const found = entry(name);
  if (!found)
    return 0;
  const Key& key = key_called(name);
  if (found->type != NodeType::integer) {
    refuse(*found, "must be " + allowed_text(key));
    return 0;
  }
  if (!key.range.contains(found->number())) {
    refuse(*found, key.range.sentence("1"));
    return 0;
  }
  return static_cast<int>(found->integer);
}

bool TableReader::boolean(const std::string& key) {
  const Node* const found = entry(key);
  if (found && found->type != NodeType::boolean)
    refuse(*found, "must be " + allowed_text(key_called(key)));
  return found && found->boolean;
}

std::string TableReader::text(const std::string& key) {
  const Node* const found = entry(key);
  if (!found)
    return "";
  const bool is_text = found->type == NodeType::text || found->is_number() ||
                       found->type == NodeType::boolean;
  if (!is_text || found->text.empty()) // only an override has both
    refuse(*found, "must be " + allowed_text(key_called(key)));
  return found->text;
}

std::optional<int> TableReader::word(const std::string& name) {
  const Node* const found = entry(name);
  if (!found)
    return std::nullopt;
  const Key& key = key_called(name);
  if (found->type != NodeType::text) {
    refuse(*found, "must be " + allowed_text(key));
    return std::nullopt;
  }
  const auto match = std::find(key.words.begin(), key.words.end(), found->text);
  if (match == key.words.end()) {
    refuse(*found, "must be " + allowed_text(key) +
                       "; nearest: " + input::nearest(found->text, key.words));
    return std::nullopt;
  }
  return static_cast<int>(match - key.words.begin());
}

std::vector<std::string> TableReader::names(const std::string& key) {
  std::vector<std::string> texts;
  const Node* const found = entry(key);
  if (!found)
    return texts;
  for (const Node& element : found->list)
    texts.push_back(element.text);
  const bool is_good =
      found->type == NodeType::list && !found->list.empty() &&
      std::none_of(texts.begin(), texts.end(),
                   [](const std::string& text) { return text.empty(); });
  if (!is_good)
    refuse(*found, "must be " + allowed_text(key_called(key)));
  return texts;
}

std::string TableReader::path(const std::string& key) {
  const std::string file = text(key);
  return file.empty() ? file : (std::filesystem::path(folder_) / file).string();
}

const Node* TableReader::sub_table(const std::string& name) {
  const Node* const found = node_.find(name);
  if (found && !found->is_table())
    refuse(*found, "must be a table: [" + found->path + "]");
  return found && found->is_table() ? found : nullptr;
}

const Node& TableReader::said_by(const std::string& key) const {
  const Node* const found = node_.find(key);
  return found ? *found : node_;
}

void TableReader::complain(const Node& where, const std::string& what) {
  mistakes_.add(where.place, where.path + " " + what);
}

void TableReader::complain_missing(const std::string& name,
                                   const std::string& why) {
  const Key& key = key_called(name);
  mistakes_.add(node_.place, fmt::format("{} is missing{}: {}", path_of(name),
                                         why, allowed_text(key)));
}

void TableReader::require(const std::string& name, const std::string& why) {
  if (!has(name))
    complain_missing(name, why);
}

void TableReader::refuse(const Node& found, const std::string& rule) {
  complain(found, "= " + written(found) + ", but " + rule);
}

void TableReader::refuse_both(const std::string& first,
                              const std::string& second) {
  complain(*node_.find(second),
           "and " + path_of(first) + " are both given; give only one of them");
}

void TableReader::refuse_unknown(const std::vector<std::string>& also_known) {
  std::vector<std::string> known = also_known;
  const std::string prefix =
      vocabulary_.name.empty() ? "" : vocabulary_.name + ".";
  for (const Table& table : vocabulary())
    if (!table.is_part && table.name.size() > prefix.size() &&
        table.name.starts_with(prefix) &&
        table.name.find('.', prefix.size()) == std::string::npos)
      known.push_back(table.name.substr(prefix.size()));
  for (const Key& key : vocabulary_.keys)
    known.push_back(key.name);
  for (const NodeEntry& candidate : node_.entries) {
    if (std::find(known.begin(), known.end(), candidate.key) != known.end())
      continue;
    const std::string home = home_of_key(candidate.key, node_.path);
    std::string what = "is not a key of this table; ";
    if (node_.path.empty())
      what = candidate.node.is_table()
                 ? "is not a table of a case file; "
                 : "is not a key at the top of a case file; ";
    if (candidate.key == "gamma_theory" && node_.path == "expect")
      what += "since version 0.2 it is gamma_curve";
    else
      what += home.empty() ? "nearest: " + input::nearest(candidate.key, known)
                           : "it belongs to " + home;
    complain(candidate.node, what);
  }
}

} // namespace asperity::cases
