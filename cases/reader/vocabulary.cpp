#include "cases/reader/vocabulary.hpp"

#include "base/special_numbers.hpp"
#include "cases/types/expectations.hpp"
#include "mechanics/limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>

namespace asperity::cases {
namespace {

Table top_table() {
  return {.name = "",
          .when = "Always needed.",
          .description = "Keys at the top of the file, before the first table.",
          .keys = {
              {.name = "base",
               .type = ValueType::path,
               .when = "optional; must be the first key",
               .example = "\"../polymer/case.toml\"",
               .show = Show::no,
               .description = "Base case; every other key here overrides it, "
                              "and a key or table set to \"\" is removed."},
              {.name = "schema",
               .type = ValueType::integer,
               .range = between(1, 1),
               .need = Need::always,
               .example = "1",
               .show = Show::yes,
               .description = "Version of the case format."},
              {.name = "title",
               .type = ValueType::text,
               .when = "default: the case's name",
               .example = "\"A rough block\"",
               .show = Show::yes,
               .description = "Title of the report, one line."},
          }};
}

Table report_table() {
  return {
      .name = "report",
      .when = "Optional.",
      .description = "Fields that are saved in the result for the report.",
      .keys = {
          {.name = "fields",
           .type = ValueType::fields,
           .range = between(0, 1000000),
           .fallback = "3",
           .example = "3",
           .show = Show::yes,
           .description = "Number of load steps, spread over the loading path, "
                          "whose pressure and gap fields are saved."},
          {.name = "stress_inside",
           .type = ValueType::boolean,
           .fallback = "false",
           .example = "true",
           .description = "Compute the subsurface stress under each saved "
                          "pressure field, by continuum elasticity or from the "
                          "cells of a full 3-D block: the maximum von Mises "
                          "stress, its location, and a section through it."},
          {.name = "vtu",
           .type = ValueType::boolean,
           .fallback = "false",
           .example = "true",
           .show = Show::no,
           .description = "The full 3-D block ([fem] with solver = \"full\") "
                          "writes displacement and stress, and on the contact "
                          "surface gap, pressure and contact status, of the "
                          "steps whose fields are saved, for ParaView."},
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
  for (const ExpectationName& entry : expectation_names())
    table.keys.push_back(
        {.name = entry.name,
         .type = ValueType::band,
         .example = "{ value = 0.40, within = 0.05 }",
         .show = entry.name == "gamma_slope" ? Show::as_comment : Show::no,
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
          {.name = "value",
           .need = Need::conditional,
           .when = "with within",
           .example = "0.40",
           .description = "Centre of the band."},
          {.name = "within",
           .type = ValueType::tolerance,
           .range = at_least(0.0),
           .need = Need::conditional,
           .when = "with value",
           .example = "0.05",
           .description =
               "Half-width of the band: a number, or \"5 %\" of value."},
          {.name = "below", .example = "0.3", .description = "Upper bound."},
          {.name = "above", .example = "0.2", .description = "Lower bound."},
          {.name = "methods",
           .type = ValueType::names,
           .when = "default: every method of the case that yields the quantity",
           .example = "[\"fem\", \"theory\"]",
           .description = "Methods whose values must lie in the band."},
          {.name = "if_undecided",
           .type = ValueType::word,
           .words = {"fail", "pass"},
           .fallback = "\"fail\"",
           .example = "\"fail\"",
           .description = "Verdict on an undecided value: one whose 95 % "
                          "confidence interval contains an end of the band."},
      }};
}

std::vector<Table> all_tables() {
  std::vector<Table> tables = {top_table(), surface_table()};
  for (Table& table : block_tables())
    tables.push_back(std::move(table));
  for (Table& table : method_tables())
    tables.push_back(std::move(table));
  for (Table& table : study_tables())
    tables.push_back(std::move(table));
  tables.push_back(report_table());
  tables.push_back(expect_table());
  tables.push_back(band_table());
  tables.push_back(case_sweep_table());
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
  return "must be " + (text.empty() ? "finite [" + unit + "]" : text);
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

const std::vector<Table>& vocabulary() {
  static const std::vector<Table> tables = all_tables();
  return tables;
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

void append_keys(std::vector<Key>& keys, const std::vector<Key>& more) {
  keys.insert(keys.end(), more.begin(), more.end());
}

std::string allowed_text(const Key& key) {
  switch (key.type) {
  case ValueType::quantity:
    if (key.dimension == Dimension::none)
      return "a number";
    return fmt::format(
        "a number [{}] or a string with one of: {}", si_unit(key.dimension),
        fmt::join(unit_symbols(key.dimension, key.references), ", "));
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
    return "{ value, within } or { below } or { above }, or a list of "
           "such bands";
  case ValueType::layers:
    return "a list of { thickness, youngs_modulus, poisson_ratio }";
  }
  return "";
}

} // namespace asperity::cases
