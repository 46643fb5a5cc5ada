#pragma once

// The notation of the rows of the vocabulary. A row binds a key to the member
// of the settings that holds its value:
//
//     key<&MdSettings::mass>("mass", Dimension::mass, "Mass of an atom.",
//                            needed("197 u", "with dynamics"))
//
// The type of the member says how the value is read. Its initialiser is the
// default, unless it is a std::optional or the row says that the key is needed
// or what its default is.

#include "input/reader/table_reader.hpp"
#include "input/reader/vocabulary.hpp"

#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace asperity::cases {

/// What values a key may have: numbers in a range, with or without a unit,
/// words in the order of the enumeration (or false, true), or of a member that
/// is a text in any order, or any of a type.
struct Values {
  Values(std::initializer_list<const char*> all_words)
      : type(ValueType::word), words(all_words.begin(), all_words.end()) {}

  Values(const std::vector<const char*>& all_words)
      : type(ValueType::word), words(all_words.begin(), all_words.end()) {}

  Values(Range numbers) : range(numbers) {}

  Values(Dimension unit, Range numbers = positive(),
         std::vector<mechanics::ReferenceUnit> units_of_problem = {})
      : dimension(unit),
        range(numbers),
        references(std::move(units_of_problem)) {}

  Values(ValueType any_of, Range numbers = any_number())
      : type(any_of), range(numbers) {}

  ValueType type = ValueType::quantity;
  Dimension dimension = Dimension::none;
  Range range = any_number();
  std::vector<mechanics::ReferenceUnit> references;
  std::vector<std::string> words;
};

/// A length > 0 in SI, in multiples of the side length or in node spacings.
Values by_the_grid();

/// Whether a key must be given, and an example: TOML, or a string without its
/// quotes. Without it the default is the example.
struct Given {
  Need need = Need::never;
  std::string example;
  std::string when;     ///< the condition or the default in words
  std::string fallback; ///< of a key without a member, as TOML
};

Given needed(std::string example, std::string condition = "");
Given eg(std::string example, std::string default_in_words = "");
Given or_else(const std::string& fallback, const std::string& example = "");

/// A key without a member, which the reader of its table reads.
Key key(std::string name, Values values, std::string description,
        Given given = {});

using Targets = std::vector<mechanics::Quantity>;

/// Reads a key that is a quantity, a list of quantities, or a sweep of them.
Targets read_targets(TableReader& table, const Key& key);

template <class Owner, class Value>
Owner owner_of(Value Owner::*);

template <class Value>
constexpr bool is_optional = false;
template <class Value>
constexpr bool is_optional<std::optional<Value>> = true;

/// Reads a key that is given into the member.
template <class Value>
void read_value(TableReader& table, const Key& key, Value& value) {
  if constexpr (is_optional<Value>) {
    read_value(table, key, value.emplace());
  } else if constexpr (std::is_same_v<Value, std::string>) {
    if (key.type == ValueType::word)
      value = key.words.at(
          static_cast<std::size_t>(table.word(key.name).value_or(0)));
    else
      value = key.type == ValueType::path ? table.path(key.name)
                                          : table.text(key.name);
  } else if constexpr (std::is_same_v<Value, mechanics::Quantity>) {
    value = table.quantity(key.name);
  } else if constexpr (std::is_same_v<Value, Targets>) {
    value = read_targets(table, key);
  } else if constexpr (std::is_same_v<Value, double>) {
    value = table.number(key.name);
  } else if constexpr (std::is_enum_v<Value>) {
    value = table.choice(key.name, value);
  } else if constexpr (std::is_same_v<Value, bool>) {
    value = key.type == ValueType::word ? table.choice(key.name, value)
                                        : table.boolean(key.name);
  } else {
    value = static_cast<Value>(table.integer(key.name));
  }
}

/// @throws std::logic_error  the key is not a member of this struct
void require_owner(const Key& key, std::type_index owner);

/// A default as TOML.
std::string default_text(double value);
std::string default_text(const mechanics::Quantity& value);

/// Adds to a key what the member tells: the type of a number, and the default.
template <class Value>
void describe(Key& key, const Value& value) {
  std::string fallback;
  if constexpr (is_optional<Value>) {
    describe(key, typename Value::value_type{});
  } else if constexpr (std::is_same_v<Value, double> ||
                       std::is_same_v<Value, mechanics::Quantity>) {
    fallback = default_text(value);
  } else if constexpr (std::is_same_v<Value, Targets>) {
    key.type = ValueType::program;
  } else if constexpr (std::is_same_v<Value, std::string>) {
    if (key.type == ValueType::word)
      fallback = '"' + value + '"';
  } else {
    if (key.type == ValueType::quantity)
      key.type = ValueType::integer;
    const auto number = static_cast<long long>(value);
    fallback = key.type == ValueType::word
                   ? '"' + key.words.at(static_cast<std::size_t>(number)) + '"'
               : key.type != ValueType::boolean ? std::to_string(number)
               : number != 0                    ? "true"
                                                : "false";
  }
  key.fallback = key.need == Need::never && key.when.empty() ? fallback : "";
  if (key.example.empty())
    key.example = key.fallback;
}

/// Lets a function read a key that is given, for values that are converted
/// before they become a member.
template <class Settings>
Key read_by(void (*read)(TableReader&, const Key&, Settings&), Key key) {
  key.owner = typeid(Settings);
  key.read = [read](TableReader& table, const Key& own, void* settings) {
    if (table.has(own.name))
      read(table, own, *static_cast<Settings*>(settings));
    else if (own.need == Need::always)
      table.complain_missing(own.name);
  };
  return key;
}

/// A key whose value is the member.
template <auto member>
Key key(std::string name, Values values, std::string description,
        Given given = {}) {
  using Settings = decltype(owner_of(member));
  Key bound = key(std::move(name), std::move(values), std::move(description),
                  std::move(given));
  describe(bound, Settings{}.*member);
  return read_by<Settings>(
      [](TableReader& table, const Key& own, Settings& settings) {
        read_value(table, own, settings.*member);
      },
      std::move(bound));
}

/// Lets a key be read only if this holds for the settings, as far as their
/// other keys come before it. A key with a condition is needed then.
/// @throws std::logic_error  the key is a member of another struct
template <class Settings>
Key where(bool (*holds)(const Settings&), Key key) {
  require_owner(key, typeid(Settings));
  key.read = [holds, read = std::move(key.read)](
                 TableReader& table, const Key& own, void* settings) {
    if (!holds(*static_cast<const Settings*>(settings)))
      return;
    if (own.need == Need::conditional && !table.has(own.name))
      table.complain_missing(own.name);
    else
      read(table, own, settings);
  };
  return key;
}

/// Says that only surfaces of these kinds have the keys, unless one says so
/// itself.
std::vector<Key> of(const std::vector<std::string>& kinds,
                    std::vector<Key> keys);

/// Leaves all keys but those that are shown() out of `asperity new`.
std::vector<Key> hidden(std::vector<Key> keys);

} // namespace asperity::cases
