#pragma once

// The vocabulary of case files: each key with the member of the settings that
// holds its value. The reader, the JSON Schema, the template and
// docs/reference/case.md are all derived from this table. Its rows are in
// vocabulary*.cpp, in the notation of bound_key.hpp.

#include "input/text/node.hpp"
#include "input/types/case.hpp"
#include "input/types/units.hpp"

#include <functional>
#include <string>
#include <typeindex>
#include <vector>

namespace asperity::cases {

enum class ValueType {
  quantity, ///< number if the dimension is none, else number (SI) or "14 nm"
  target,  ///< quantity with the dimension of the key whose value is this table
  integer, ///< whole number
  boolean, ///< true or false
  text,    ///< any string
  path,    ///< file path relative to the folder of the case file
  word,    ///< one of `words`, in the order of the enumeration in case.hpp
  program, ///< quantity, list of quantities, or a sweep (see "load.sweep")
  fields,  ///< whole number, "none" or "all"
  tolerance, ///< number, or "5 %" of another key
  names,     ///< list of strings
  band,      ///< see "expect.band"
  layers,    ///< list of tables, see "material.layer"
};

/// The admissible range of a number.
struct Range {
  double low;
  double high;
  bool is_low_allowed = true;
  bool is_high_allowed = true;
  const char* reason = ""; ///< appended to the requirement: ", unless ..."

  bool contains(double value) const;
  /// Returns the range as text: "> 0 [m]", "between -1 and 0.5 [1]"; "" if any
  /// number is allowed.
  std::string limits(const std::string& unit) const;
  /// Returns the requirement as text: "must be > 0 [m]".
  std::string sentence(const std::string& unit) const;
};

Range any_number();
Range positive();
Range at_least(double low);
Range between(double low, double high);
Range inside(double low, double high); ///< both ends excluded

/// Magnitudes of quantities other than 0 with which the computations and the
/// maps of a result, which are in single precision, neither overflow nor
/// underflow. Any number without a unit is allowed.
Range magnitudes(Dimension dimension, mechanics::ReferenceUnit reference);

enum class Need {
  always,      ///< if the table is present, or only for its `kinds` if given
  conditional, ///< condition in `when`, checked by the reader
  never,
};

/// How the template of `asperity new` shows a key.
enum class Show { yes, as_comment, no };

class TableReader;

/// One key.
struct Key {
  std::string name;
  ValueType type = ValueType::quantity;
  Dimension dimension = Dimension::none;
  Range range = any_number();
  std::vector<mechanics::ReferenceUnit> references = {}; ///< reference units
                                                         ///< allowed besides SI
  std::vector<std::string> words = {}; ///< of a quantity: one in its place
  Need need = Need::never;
  std::string when = {}; ///< condition as text for the documentation
  std::vector<std::string> kinds = {}; ///< surface kinds; empty: all
  std::string fallback = {}; ///< the default, as TOML; empty: there is none
  std::string example = {};  ///< example as TOML
  Show show = Show::as_comment;
  std::string description = {}; ///< one sentence

  /// Reads the value into its member. A key that is not given leaves the member
  /// as it is, its default, and is a mistake if it is needed. Empty for a key
  /// that the reader of its table reads.
  /// @param settings  the struct that has the member, which is an `owner`
  using Read =
      std::function<void(TableReader& table, const Key& key, void* settings)>;
  Read read = {};
  std::type_index owner = typeid(void); ///< type of the struct

  /// Whether surfaces of this kind have the key.
  bool applies_to(const std::string& surface_kind) const;

  /// Only surfaces of these kinds have the key.
  Key of(std::vector<std::string> surface_kinds) const;
  Key shown() const;
  Key hidden() const;
};

struct Table {
  std::string name; ///< "surface", "material.counter"; "" for the top level
  std::string when = {};  ///< one sentence: whether the table is needed
  bool is_method = false; ///< whether it may have variants
  bool is_part = false;   ///< part of a value, not written as [name]
  std::string description;
  std::vector<Key> keys;
};

/// Returns all tables in the order of a case file. "load.sweep" and
/// "expect.band" are tables inside values.
const std::vector<Table>& vocabulary();

/// Adds a row to a table as long as this object lives. For a program or a test
/// that extends the vocabulary, while no case is being read.
class AddedKey {
public:
  AddedKey(const std::string& table, const Key& key);
  ~AddedKey();
  AddedKey(const AddedKey&) = delete;
  AddedKey& operator=(const AddedKey&) = delete;

private:
  Table& table_;
};

/// Return a table or a key of the vocabulary.
///
/// @throws std::domain_error  there is no such table or key
const Table& vocabulary_table(const std::string& name);
const Key& vocabulary_key(const Table& table, const std::string& name);

/// Returns the key of a table; null if there is no such table or key.
const Key* find_key(const std::string& table, const std::string& name);

/// Whether an entry of the table of a method is a variant: a table whose name
/// is no key, [fem.hard].
bool is_variant(const NodeEntry& entry, const std::string& kind);

/// The table of a method of a kind without its variants, or that of a variant
/// with the keys that it inherits. These keep their place and path, so that a
/// mistake in one of them is reported once, where it is written.
/// @param variant  in the table; null: the method itself
Node method_table(const Node& table, const std::string& kind,
                  const Node* variant = nullptr);

/// Returns the allowed words, units or type of a key as messages show them:
/// "clamped | sliding".
std::string allowed_text(const Key& key);

/// Returns why keys of other kinds do not apply to this kind of surface; may be
/// "".
std::string reason_of_kind(const std::string& kind);

void append_keys(std::vector<Key>& keys, const std::vector<Key>& more);

/// The rows of the vocabulary, one function per file.
Table surface_table();
std::vector<Key> map_keys(); ///< part of [surface]: files and measured maps
Table md_table();
std::vector<Table> mesh_tables();
std::vector<Table> block_tables();
std::vector<Table> method_tables();
Table case_sweep_table();

} // namespace asperity::cases
