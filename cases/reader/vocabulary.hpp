#pragma once

// The one table of the case file's vocabulary: reader, JSON Schema, template
// and docs/case.md all come from it. Rows in vocabulary*.cpp.

#include "cases/types/case.hpp"
#include "cases/types/units.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

enum class ValueType {
  quantity,  ///< number, of the dimension none; else number (SI) or "14 nm"
  target,    ///< quantity of the key that the table is the value of
  integer,   ///< whole number
  boolean,   ///< true or false
  text,      ///< any string
  path,      ///< of a file, relative to the case file's folder
  word,      ///< one of `words`, in the order of the enumeration in case.hpp
  program,   ///< quantity, list of quantities, or a sweep (see "load.sweep")
  fields,    ///< whole number, "none" or "all"
  tolerance, ///< number, or "5 %" of another key
  names,     ///< list of strings
  band,      ///< see "expect.band"
  layers,    ///< list of tables, see "material.layer"
};

/// What a number must satisfy.
struct Range {
  double low;
  double high;
  bool is_low_allowed = true;
  bool is_high_allowed = true;

  bool contains(double value) const;
  /// "> 0 [m]", "between -1 and 0.5 [1]"; "" if any number will do.
  std::string limits(const std::string& unit) const;
  /// "must be > 0 [m]".
  std::string sentence(const std::string& unit) const;
};

Range any_number();
Range positive();
Range at_least(double low);
Range between(double low, double high);
Range inside(double low, double high); ///< both ends excluded

enum class Need {
  always,      ///< wherever the table is, or its `kinds` if it has some
  conditional, ///< `when` says it, the reader's code checks it
  never,
};

/// How the template of `asperity new` shows a key.
enum class Show { yes, as_comment, no };

struct Key {
  std::string name;
  ValueType type = ValueType::quantity;
  Dimension dimension = Dimension::none;
  Range range = any_number();
  std::vector<Yardstick> yardsticks = {}; ///< offered besides SI
  std::vector<std::string> words = {};
  Need need = Need::never;
  std::string when = {};               ///< the condition, for docs
  std::vector<std::string> kinds = {}; ///< surface kinds; empty: all
  std::string fallback = {}; ///< the default, as TOML; empty: there is none
  std::string example = {};  ///< as TOML
  Show show = Show::as_comment;
  std::string description = {}; ///< one sentence
};

struct Table {
  std::string name; ///< "surface", "material.counter"; "" for the file's top
  std::string when = {};  ///< a sentence: whether it is needed
  bool is_method = false; ///< may hold variants
  bool is_part = false;   ///< of a value, not written as [name]
  std::string description;
  std::vector<Key> keys;
};

/// All tables in the order of a case file; "load.sweep" and "expect.band" are
/// the tables inside values.
const std::vector<Table>& vocabulary();

/// @throws std::domain_error  there is no such table or key
const Table& vocabulary_table(const std::string& name);
const Key& vocabulary_key(const Table& table, const std::string& name);

/// The key's words, or units, or type, as messages say it: "clamped | sliding".
std::string allowed_text(const Key& key);

/// Why a key of another kind means nothing for this surface; may be "".
std::string reason_of_kind(const std::string& kind);

/// The rows, by file.
Table surface_table();
Table md_table();
std::vector<Table> block_tables();
std::vector<Key> whole_block_keys(); ///< of [fem]
std::vector<Table> method_tables();
std::vector<Table> study_tables();

} // namespace asperity::cases
