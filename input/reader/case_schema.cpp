#include "input/reader/case_schema.hpp"

#include "base/json.hpp"
#include "input/reader/vocabulary.hpp"
#include "input/types/quantity_at_load.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <cmath>
#include <string_view>
#include <vector>

namespace asperity::cases {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* number_pattern =
    R"(^ *-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)? *)";

void bound(Json& schema, const Range& range) {
  if (std::isfinite(range.low))
    schema[range.is_low_allowed ? "minimum" : "exclusiveMinimum"] = range.low;
  if (std::isfinite(range.high))
    schema[range.is_high_allowed ? "maximum" : "exclusiveMaximum"] = range.high;
}

// Returns the pattern of a unit in the spellings that are most common.
std::string unit_pattern(std::string_view symbol) {
  constexpr std::string_view angstrom = "angstrom";
  const auto is_letter = [&](std::size_t at) {
    return at < symbol.size() &&
           std::isalpha(static_cast<unsigned char>(symbol[at])) != 0;
  };
  std::string pattern;
  for (std::size_t i = 0; i < symbol.size(); ++i) {
    const char letter = symbol[i];
    if (letter == 'u' && is_letter(i + 1) && (i == 0 || !is_letter(i - 1))) {
      pattern += "[u\u00b5\u03bc]";
    } else if (symbol.substr(i).starts_with(angstrom)) {
      pattern += "(angstrom|\u00c5)";
      i += angstrom.size() - 1;
    } else if (letter == '^' && i + 1 < symbol.size()) {
      pattern += symbol[++i] == '2' ? "(\\^?2|\u00b2)" : "(\\^?3|\u00b3)";
    } else {
      if (std::string_view("*/()").find(letter) != std::string_view::npos)
        pattern += '\\';
      pattern += letter;
    }
  }
  return pattern;
}

// Returns the schema of a number in SI within its range, or a string that ends
// in an allowed unit.
Json quantity_schema(const Key& key) {
  Json number = {{"type", "number"}};
  bound(number, key.range);
  if (key.dimension == Dimension::none)
    return number;
  std::vector<std::string> symbols;
  for (const input::Unit& unit : input::units())
    if (unit.dimension == key.dimension)
      symbols.push_back(unit_pattern(unit.symbol));
  for (const mechanics::ReferenceUnit reference : key.references)
    if (reference_dimension(reference) == key.dimension)
      symbols.push_back(unit_pattern(reference_symbol(reference)));
  const Json text = {{"type", "string"},
                     {"pattern", fmt::format("{}({}) *$", number_pattern,
                                             fmt::join(symbols, "|"))}};
  Json schema = {{"anyOf", {number, text}}};
  if (!key.words.empty())
    schema["anyOf"].push_back({{"enum", key.words}});
  return schema;
}

Json program_schema(const Key& key) {
  const Json quantity = quantity_schema(key);
  Json sweep = {{"type", "object"}, {"additionalProperties", false}};
  sweep["required"] = Json::array();
  for (const Key& part : vocabulary_table("load.sweep").keys) {
    Json& property = sweep["properties"][part.name];
    if (part.type == ValueType::integer) {
      property["type"] = "integer";
      bound(property, part.range);
    } else if (part.type == ValueType::word) {
      property["enum"] = part.words;
    } else {
      property = quantity;
    }
    property["description"] = part.description;
    sweep["required"].push_back(part.name);
  }
  const Json list = {{"type", "array"}, {"minItems", 1}, {"items", quantity}};
  return {{"anyOf", {quantity, list, sweep}}};
}

Json value_schema(const Key& key) {
  switch (key.type) {
  case ValueType::quantity:
  case ValueType::target:
    return quantity_schema(key);
  case ValueType::integer: {
    Json schema = {{"type", "integer"}};
    bound(schema, key.range);
    return schema;
  }
  case ValueType::boolean:
    return {{"type", "boolean"}};
  case ValueType::text:
  case ValueType::path:
    return {{"type", "string"}, {"minLength", 1}};
  case ValueType::word:
    return {{"enum", key.words}};
  case ValueType::program:
    return program_schema(key);
  case ValueType::fields:
    return {
        {"anyOf",
         {{{"type", "integer"}, {"minimum", 0}}, {{"enum", {"none", "all"}}}}}};
  case ValueType::tolerance:
    return {{"anyOf",
             {{{"type", "number"}, {"minimum", 0}},
              {{"type", "string"}, {"pattern", "^[0-9.eE+-]+ ?%$"}}}}};
  case ValueType::names:
    return {
        {"type", "array"}, {"minItems", 1}, {"items", {{"type", "string"}}}};
  case ValueType::layers:
    return {{"type", "array"},
            {"minItems", 1},
            {"items", {{"$ref", "#/$defs/material.layer"}}}};
  case ValueType::band: {
    const Json one = {{"$ref", "#/$defs/expect.band"}};
    return {
        {"anyOf", {one, {{"type", "array"}, {"minItems", 1}, {"items", one}}}}};
  }
  }
  return {};
}

// Returns a pattern that excludes the keys of the table, because they cannot be
// names of variants.
std::string variant_name_pattern(const Table& table) {
  std::string keys;
  for (const Key& key : table.keys)
    keys += (keys.empty() ? "" : "|") + key.name;
  return "^(?!(" + keys + ")$)[a-z0-9-]+$";
}

// Returns the pattern of a quantity at a load, which is also a valid key:
// "area_fraction@p=0.01 E*".
std::string at_load_pattern() {
  std::string names;
  for (const ExpectationName& entry : expectation_names(QuantityOf::load))
    names += (names.empty() ? "" : "|") + entry.name;
  for (const ExpectationName& entry :
       expectation_names(QuantityOf::magnification))
    names += "|" + entry.name;
  return "^ *(" + names + ") *@ *p *=";
}

Json table_schema(const Table& table, bool is_variant) {
  Json schema = {{"type", "object"},
                 {"description", table.description},
                 {"properties", Json::object()},
                 {"additionalProperties", false}};
  for (const Key& key : table.keys) {
    Json property = value_schema(key);
    property["description"] = key.description +
                              (key.when.empty() ? "" : " Needed or default: ") +
                              key.when;
    if (!key.fallback.empty())
      property["default"] = json_of_text(key.fallback);
    schema["properties"][key.name] = property;
    if (key.need == Need::always && key.kinds.empty() && !is_variant)
      schema["required"].push_back(key.name);
  }
  if (table.name == "expect")
    schema["patternProperties"][at_load_pattern()] =
        value_schema(table.keys.front());
  if (table.name == "sweep") // any key of the case, in quotes or as a table
    schema["additionalProperties"] = {
        {"anyOf",
         {{{"type", "array"}, {"minItems", 1}}, {{"type", "object"}}}}};
  if (table.is_method && !is_variant)
    schema["patternProperties"][variant_name_pattern(table)] = {
        {"$ref", "#/$defs/" + table.name + ".variant"}};
  return schema;
}

} // namespace

std::string json_schema() {
  Json schema = table_schema(vocabulary_table(""), false);
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "Asperity case";
  schema.erase("required"); // nothing is required in a case with a base
  const Json whole = {{"required", {"schema", "surface", "material", "load"}}};
  const Json changes = {{"required", {"base"}}};
  schema["anyOf"] = {whole, changes};
  Json& tables = schema["properties"];
  for (const Table& table : vocabulary()) {
    if (table.is_part)
      schema["$defs"][table.name] = table_schema(table, false);
    else if (const auto dot = table.name.find('.'); dot != std::string::npos)
      tables[table.name.substr(0, dot)]["properties"]
            [table.name.substr(dot + 1)] = table_schema(table, false);
    else if (!table.name.empty())
      tables[table.name] = table_schema(table, false);
    if (table.is_method)
      schema["$defs"][table.name + ".variant"] = table_schema(table, true);
  }
  schema["$defs"].erase("load.sweep"); // inlined in its keys, with units
  return text_of_json(schema, 2) + "\n";
}

} // namespace asperity::cases
