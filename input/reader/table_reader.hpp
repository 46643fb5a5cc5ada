#pragma once

// Reads one table of a case key by key according to the vocabulary. Defines the
// error messages for single keys.

#include "input/reader/vocabulary.hpp"
#include "input/text/node.hpp"

#include <optional>
#include <string>
#include <typeindex>
#include <vector>

namespace asperity::cases {

/// Reads the keys of one table. Each read function reports its mistake in
/// `mistakes` and then returns a harmless value, so that one pass finds all
/// mistakes. read() reads keys into the members of settings; the functions that
/// name a key read one without a member, which must be given.
class TableReader {
public:
  /// @param node        node of type table; must outlive the reader
  /// @param vocabulary  the valid keys; must outlive the reader
  /// @param mistakes    list of mistakes; must outlive the reader
  /// @param folder      to which file paths are relative
  TableReader(const Node& node, const Table& vocabulary, Mistakes& mistakes,
              std::string folder = "");

  /// Returns a reader of a table inside this one, such as "mesh.counter", after
  /// reporting the keys that it does not have.
  TableReader part(const Node& node, const std::string& vocabulary) const;

  /// Reads all keys whose values are members of these settings.
  /// @throws std::logic_error  the table has no key with such a member
  template <class Settings>
  void read(Settings& settings) {
    read_members(typeid(Settings), &settings);
  }

  /// Returns the table itself, with its place.
  const Node& node() const { return node_; }

  bool has(const std::string& key) const;

  double number(const std::string& key);
  /// Returns a quantity in its reference unit; {0, si} after reporting a
  /// mistake.
  mechanics::Quantity quantity(const std::string& key);
  int integer(const std::string& name);
  bool boolean(const std::string& key);
  std::string text(const std::string& key);
  std::vector<std::string> names(const std::string& key);

  /// Returns the index of the word in the vocabulary, which is also the order
  /// of the enumeration; empty after reporting a mistake.
  std::optional<int> word(const std::string& name);

  /// Returns the word as an enumerator; `otherwise` after reporting a mistake,
  /// or if it is not given and has a default.
  template <class Enumeration>
  Enumeration choice(const std::string& key, Enumeration otherwise) {
    if (!has(key) && !key_called(key).fallback.empty())
      return otherwise;
    const std::optional<int> index = word(key);
    return index ? static_cast<Enumeration>(*index) : otherwise;
  }

  /// Returns the entry, or nullptr after reporting that it is missing.
  const Node* entry(const std::string& name);

  /// Returns the path in a key, in the folder unless it is absolute; empty
  /// after reporting a mistake.
  std::string path(const std::string& key);

  /// Returns the sub-table of that name, or nullptr if there is none or after
  /// reporting that it is no table.
  const Node* sub_table(const std::string& name);

  /// Returns the entry, or the table if the key is not given.
  const Node& said_by(const std::string& key) const;

  /// Returns what the vocabulary says of a key.
  const Key& key_called(const std::string& name) const;

  /// Reads a quantity or number that is part of the value of the key.
  mechanics::Quantity quantity_in(const Node& node, const Key& key);

  void complain_missing(const std::string& name, const std::string& why = "");
  /// Reports a key that is missing, and why it is needed.
  void require(const std::string& name, const std::string& why = "");
  void complain(const Node& where, const std::string& what);
  /// Reports "surface.points = 7, but must be even".
  void refuse(const Node& found, const std::string& rule);
  /// Reports "first and second are both given: ...".
  void refuse_both(const std::string& first, const std::string& second);

  /// Reports all keys that are not in the vocabulary, with the nearest valid
  /// key or the table to which the key belongs.
  ///
  /// @param also_known  valid names that are neither keys nor tables inside
  void refuse_unknown(const std::vector<std::string>& also_known = {});

private:
  void read_members(std::type_index owner, void* settings);
  std::string path_of(const std::string& key) const;

  const Node& node_;
  const Table& vocabulary_;
  Mistakes& mistakes_;
  std::string folder_;
};

} // namespace asperity::cases
