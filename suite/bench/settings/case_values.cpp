#include "suite/bench/settings/case_values.hpp"

#include "base/plain_text.hpp"
#include "input/reader/vocabulary.hpp"
#include "input/text/toml_text.hpp"
#include "input/types/units.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::bench {
namespace {

using cases::Node;
using cases::NodeType;

void add_without_spacings(const Node& table, const std::string& path,
                          double spacing, std::vector<std::string>& overrides) {
  for (const cases::NodeEntry& entry : table.entries) {
    if (entry.node.is_table()) {
      add_without_spacings(entry.node, path + "." + entry.key, spacing,
                           overrides);
      continue;
    }
    const cases::Key* key =
        cases::find_key(cases::kind_of_method(path), entry.key);
    if (key == nullptr || entry.node.type != NodeType::text ||
        (key->dimension != cases::Dimension::length &&
         key->dimension != cases::Dimension::wavevector))
      continue;
    const cases::QuantityReading reading =
        cases::read_quantity(entry.node.text, cases::Dimension::length,
                             {mechanics::ReferenceUnit::spacing});
    if (reading.quantity &&
        reading.quantity->reference == mechanics::ReferenceUnit::spacing)
      overrides.push_back(
          fmt::format("{}.{}={}", path, entry.key,
                      cases::write_quantity({reading.quantity->value * spacing},
                                            cases::Dimension::length)));
  }
}

} // namespace

CaseValues::CaseValues(const cases::Case& contact_case)
    : file_(contact_case.file) {}

std::optional<Node> CaseValues::value(const std::string& table,
                                      const std::string& key) const {
  for (std::string path = table;; path = path.substr(0, path.rfind('.'))) {
    if (const Node* home = file_->at(path))
      if (const Node* found = home->find(key))
        return *found;
    if (path.find('.') == std::string::npos)
      break;
  }
  const cases::Key* known = cases::find_key(cases::kind_of_method(table), key);
  if (known == nullptr || known->fallback.empty())
    return std::nullopt;
  return cases::parse_toml_value(known->fallback, {"the vocabulary", 0}, key);
}

bool CaseValues::is_set(const std::string& table,
                        const std::string& key) const {
  const Node* home = file_->at(table);
  return home != nullptr && home->find(key) != nullptr;
}

std::vector<std::string> CaseValues::without_spacings(double spacing) const {
  std::vector<std::string> overrides;
  for (const cases::NodeEntry& entry : file_->entries)
    if (entry.node.is_table() && entry.key != "mesh")
      add_without_spacings(entry.node, entry.key, spacing, overrides);
  return overrides;
}

double leading_number(const Node& value) {
  return value.is_number() ? value.number() : number_and_rest(value.text).first;
}

std::string scaled_value(const Node& value, double factor) {
  if (value.type == NodeType::integer)
    return fmt::format(
        "{}", std::llround(static_cast<double>(value.integer) * factor));
  if (value.type == NodeType::floating)
    return fmt::format("{}", value.floating * factor);
  const auto [number, unit] = number_and_rest(value.text);
  return std::isfinite(number) ? fmt::format("{}{}", number * factor, unit)
                               : "";
}

} // namespace asperity::bench
