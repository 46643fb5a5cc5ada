#pragma once

// One table of a case read key by key against the vocabulary. Owns the wording
// of what is wrong with a single key.

#include "cases/reader/vocabulary.hpp"
#include "cases/text/node.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::cases {

/// Every read complains into `mistakes` and then returns a harmless value, so
/// that one pass finds every mistake. A missing key gives its default if the
/// vocabulary has one.
class TableReader {
public:
  /// @param node  of type table; outlives the reader, as `mistakes` does
  TableReader(const Node& node, const Table& vocabulary, Mistakes& mistakes);

  /// The table was opened with "[name]" or values on the way; its place.
  const Node& node() const { return node_; }

  bool has(const std::string& key) const;

  double number(const std::string& key);
  /// In its yardstick; {0, si} after a complaint.
  Quantity quantity(const std::string& key);
  int integer(const std::string& name);
  bool boolean(const std::string& key);
  std::string text(const std::string& key);
  std::vector<std::string> names(const std::string& key);
  std::vector<Quantity> program(const std::string& name);

  /// The word's index in the vocabulary, which is the enumeration's order;
  /// empty after a complaint.
  std::optional<int> word(const std::string& name);

  /// The word as an enumerator, `otherwise` after a complaint.
  template <class Enumeration>
  Enumeration choice(const std::string& key, Enumeration otherwise) {
    const std::optional<int> index = word(key);
    return index ? static_cast<Enumeration>(*index) : otherwise;
  }

  /// The entry itself or its default, nullptr after saying that it is missing.
  const Node* entry(const std::string& name);

  /// A quantity or number that stands somewhere inside the key's value.
  Quantity quantity_in(const Node& node, const Key& key);

  void complain_missing(const std::string& name, const std::string& why = "");
  void complain(const Node& where, const std::string& what);
  /// "surface.points = 7, but must be even"
  void refuse(const Node& found, const std::string& rule);
  /// "first and second are both given: ..."
  void refuse_both(const std::string& first, const std::string& second);

  /// Complain of every key that the vocabulary does not know, naming the
  /// nearest, or the table it belongs to.
  /// @param also_known  names that are no keys: sub-tables
  void refuse_unknown(const std::vector<std::string>& also_known = {});

private:
  std::vector<Quantity> sweep(const Node& node, const Key& key);
  const Key& key_called(const std::string& name) const;
  std::string path_of(const std::string& key) const;

  const Node& node_;
  const Table& vocabulary_;
  Mistakes& mistakes_;
  std::vector<Node> defaults_;
};

} // namespace asperity::cases
