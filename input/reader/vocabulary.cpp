#include "input/reader/vocabulary.hpp"

#include "base/special_numbers.hpp"
#include "input/reader/bound_key.hpp"
#include "input/reader/read_parts.hpp"
#include "input/reader/study_keys.hpp"
#include "input/types/expectations.hpp"
#include "mechanics/limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::cases {
namespace {

Table top_table() {
  return {
      .name = "",
      .when = "Always needed.",
      .description = "Keys at the top of the file, before the first table.",
      .keys = hidden({
          key("base", ValueType::path,
              "Base case; every other key here overrides it, and a key or "
              "table set to \"\" is removed.",
              eg("../polymer/case.toml", "optional; must be the first key")),
          key("schema", {ValueType::integer, between(1, 1)},
              "Version of the case format.", needed("1"))
              .shown(),
          key<&Case::title>("title", ValueType::text,
                            "Title of the report, one line.",
                            eg("A rough block", "default: the case's name"))
              .shown(),
      })};
}

Table report_table() {
  return {.name = "report",
          .when = "Optional.",
          .description = "Fields that are saved in the result for the report.",
          .keys = {
              read_by<ReportSpec>(
                  read_fields,
                  key<&ReportSpec::fields>(
                      "fields", {ValueType::fields, between(0, 1000000)},
                      "Number of load steps, spread over the loading path, "
                      "whose pressure and gap fields are saved."))
                  .shown(),
              key<&ReportSpec::has_double_maps>(
                  "precision", {"single", "double"},
                  "Precision of the saved pressure and gap fields. In single "
                  "precision, `asperity certify` finds errors of some 1e-7 of "
                  "the rms height in them, whatever the tolerance of the "
                  "solver.",
                  eg("double", "default: single")),
              key<&ReportSpec::stress_inside>(
                  "stress_inside", ValueType::boolean,
                  "Compute the subsurface stress under each saved pressure "
                  "field, by continuum elasticity or from the cells of a full "
                  "3-D block: the maximum von Mises stress, its location, and "
                  "a section through it.",
                  eg("true")),
              key<&ReportSpec::vtu>(
                  "vtu", ValueType::boolean,
                  "The full 3-D block ([fem] with solver = \"full\") writes "
                  "displacement and stress, and on the contact surface gap, "
                  "pressure and contact status, of the steps whose fields are "
                  "saved, for ParaView.",
                  eg("true"))
                  .hidden(),
          }};
}

Table expect_table() {
  Table table{
      .name = "expect",
      .when = "Optional.",
      .description =
          "Expectations: each key is a quantity and holds the band that its "
          "value must lie in, or a list of bands where methods differ. "
          "`asperity check` tests results against them. A key in quotes, "
          "`\"area_fraction@p=0.01 E*\"`, is a quantity at one load.",
      .keys = {}};
  for (const ExpectationName& entry : expectation_names(QuantityOf::curve))
    table.keys.push_back(
        {.name = entry.name,
         .type = ValueType::band,
         .example = "{ value = 0.40, within = 0.05 }",
         .show = entry.name == "gamma_matched" ? Show::as_comment : Show::no,
         .description = entry.description});
  return table;
}

Table band_table() {
  return {
      .name = "expect.band",
      .when = "The value of a key of [expect].",
      .is_part = true,
      .description = "A band: value and within, or below, above or both.",
      .keys = {
          key("value", ValueType::quantity, "Centre of the band.",
              needed("0.40", "with within")),
          key("within", {ValueType::tolerance, at_least(0.0)},
              "Half-width of the band: a number, or \"5 %\" of value.",
              needed("0.05", "with value")),
          key("below", ValueType::quantity, "Upper bound.", eg("0.3")),
          key("above", ValueType::quantity, "Lower bound.", eg("0.2")),
          key("methods", ValueType::names,
              "Methods whose values must lie in the band.",
              eg("[\"fem\", \"theory\"]",
                 "default: every method of the case that yields the quantity")),
          key<&Expectation::passes_if_undecided>(
              "if_undecided", {"fail", "pass"},
              "Verdict on an undecided value: one whose 95 % confidence "
              "interval contains an end of the band."),
      }};
}

std::vector<Table> all_tables() {
  std::vector<Table> tables = {top_table(), surface_table()};
  for (Table& table : block_tables())
    tables.push_back(std::move(table));
  for (Table& table : method_tables())
    tables.push_back(std::move(table));
  for (const StudyKeys* const study : known_studies())
    tables.insert(tables.end(), study->tables.begin(), study->tables.end());
  tables.push_back(report_table());
  tables.push_back(expect_table());
  tables.push_back(band_table());
  tables.push_back(case_sweep_table());
  return tables;
}

std::vector<Table>& mutable_vocabulary() {
  static std::vector<Table> tables = all_tables();
  return tables;
}

} // namespace

bool Range::contains(double value) const {
  const bool is_above = is_low_allowed ? value >= low : value > low;
  const bool is_below = is_high_allowed ? value <= high : value < high;
  return std::isfinite(value) && is_above && is_below;
}

std::string Range::limits(const std::string& unit) const {
  const std::string above =
      fmt::format("{} {}", is_low_allowed ? ">=" : ">", low);
  const std::string below =
      fmt::format("{} {}", is_high_allowed ? "<=" : "<", high);
  if (std::isinf(low) && std::isinf(high))
    return "";
  if (std::isinf(high))
    return fmt::format("{} [{}]", above, unit);
  if (low == high)
    return fmt::format("{} [{}]", low, unit);
  if (is_low_allowed == is_high_allowed)
    return fmt::format("between {} and {}{} [{}]", low, high,
                       is_low_allowed ? "" : ", ends excluded", unit);
  return fmt::format("{} and {} [{}]", above, below, unit);
}

std::string Range::sentence(const std::string& unit) const {
  const std::string text = limits(unit);
  return "must be " + (text.empty() ? "finite [" + unit + "]" : text) + reason;
}

Range magnitudes(Dimension dimension, mechanics::ReferenceUnit reference) {
  if (reference != mechanics::ReferenceUnit::si)
    return between(1e-15, 1e9);
  switch (dimension) {
  case Dimension::none:
    return any_number();
  case Dimension::length:
  case Dimension::wavevector:
    return between(mechanics::least_length, mechanics::largest_length);
  case Dimension::pressure:
    return between(1e-15, 1e21);
  default:
    return between(1e-40, 1e40);
  }
}

Range any_number() {
  return {-infinity, infinity};
}

Range positive() {
  return {0.0, infinity, false, true};
}

Range at_least(double low) {
  return {low, infinity};
}

Range between(double low, double high) {
  return {low, high};
}

Range inside(double low, double high) {
  return {low, high, false, false};
}

bool Key::applies_to(const std::string& surface_kind) const {
  return kinds.empty() || std::ranges::count(kinds, surface_kind) > 0;
}

Key Key::of(std::vector<std::string> surface_kinds) const {
  Key key = *this;
  key.kinds = std::move(surface_kinds);
  return key;
}

Key Key::hidden() const {
  Key key = *this;
  key.show = Show::no;
  return key;
}

Key Key::shown() const {
  Key key = *this;
  key.show = Show::yes;
  return key;
}

const std::vector<Table>& vocabulary() {
  return mutable_vocabulary();
}

AddedKey::AddedKey(const std::string& table, const Key& key)
    : table_(*std::ranges::find(mutable_vocabulary(), table, &Table::name)) {
  table_.keys.push_back(key);
}

AddedKey::~AddedKey() {
  table_.keys.pop_back();
}

const Table& vocabulary_table(const std::string& name) {
  for (const Table& table : vocabulary())
    if (table.name == name)
      return table;
  throw std::domain_error("table " + name + " is not in the vocabulary");
}

const Key& vocabulary_key(const Table& table, const std::string& name) {
  for (const Key& key : table.keys)
    if (key.name == name)
      return key;
  throw std::domain_error("key " + name + " is not in the vocabulary of [" +
                          table.name + "]");
}

const Key* find_key(const std::string& table, const std::string& name) {
  for (const Table& known : vocabulary())
    for (const Key& key : known.keys)
      if (known.name == table && key.name == name)
        return &key;
  return nullptr;
}

bool is_variant(const NodeEntry& entry, const std::string& kind) {
  return entry.node.is_table() && find_key(kind, entry.key) == nullptr;
}

Node method_table(const Node& table, const std::string& kind,
                  const Node* variant) {
  Node whole = variant == nullptr ? table : *variant;
  if (variant == nullptr)
    std::erase_if(whole.entries, [&](const NodeEntry& entry) {
      return is_variant(entry, kind);
    });
  else
    for (const NodeEntry& entry : table.entries)
      if (!is_variant(entry, kind) && !whole.find(entry.key))
        whole.entries.push_back(entry);
  return whole;
}

void append_keys(std::vector<Key>& keys, const std::vector<Key>& more) {
  keys.insert(keys.end(), more.begin(), more.end());
}

std::string allowed_text(const Key& key) {
  switch (key.type) {
  case ValueType::quantity:
    if (key.dimension == Dimension::none)
      return "a number";
    return fmt::format(
        "a number [{}] or a string with one of: {}{}", si_unit(key.dimension),
        fmt::join(unit_symbols(key.dimension, key.references), ", "),
        key.words.empty() ? "" : "; or \"" + key.words.front() + '"');
  case ValueType::target:
    return "a quantity in the units of its key";
  case ValueType::integer:
    return "a whole number";
  case ValueType::boolean:
    return "true | false";
  case ValueType::text:
    return "a string";
  case ValueType::path:
    return "the path of a file";
  case ValueType::word:
    return fmt::format("{}", fmt::join(key.words, " | "));
  case ValueType::program:
    return "a quantity, a list of them, or { from, to, steps, spacing }";
  case ValueType::fields:
    return "a whole number, \"none\" or \"all\"";
  case ValueType::tolerance:
    return "a number or a string like \"5 %\"";
  case ValueType::names:
    return "a list of strings";
  case ValueType::band:
    return "{ value, within } or { below } or { above }, or a list of such "
           "bands";
  case ValueType::layers:
    return "a list of { thickness, youngs_modulus, poisson_ratio }";
  }
  return "";
}

} // namespace asperity::cases
