#include "input/reader/bound_key.hpp"

#include "base/plain_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <stdexcept>

namespace asperity::cases {
std::vector<Key> of(const std::vector<std::string>& kinds,
                    std::vector<Key> keys) {
  for (Key& key : keys)
    if (key.kinds.empty())
      key.kinds = kinds;
  return keys;
}

std::vector<Key> hidden(std::vector<Key> keys) {
  for (Key& key : keys)
    if (key.show != Show::yes)
      key.show = Show::no;
  return keys;
}

Values by_the_grid() {
  return {
      Dimension::length,
      positive(),
      {mechanics::ReferenceUnit::length, mechanics::ReferenceUnit::spacing}};
}

Given needed(std::string example, std::string condition) {
  return {condition.empty() ? Need::always : Need::conditional,
          std::move(example), std::move(condition), ""};
}

Given eg(std::string example, std::string default_in_words) {
  return {Need::never, std::move(example), std::move(default_in_words), ""};
}

Given or_else(const std::string& fallback, const std::string& example) {
  return {Need::never, example.empty() ? fallback : example, "", fallback};
}

Key key(std::string name, Values values, std::string description, Given given) {
  const bool has_strings =
      values.dimension != Dimension::none || values.type == ValueType::target ||
      values.type == ValueType::text || values.type == ValueType::path ||
      values.type == ValueType::word;
  const std::string& text = given.example;
  const bool is_string = has_strings && !text.empty() && text[0] != '[' &&
                         text[0] != '{' && text[0] != '"' &&
                         !number_and_rest(text).second.empty();
  return {.name = std::move(name),
          .type = values.type,
          .dimension = values.dimension,
          .range = values.range,
          .references = std::move(values.references),
          .words = std::move(values.words),
          .need = given.need,
          .when = std::move(given.when),
          .fallback = std::move(given.fallback),
          .example = is_string ? '"' + text + '"' : text,
          .description = std::move(description)};
}

void require_owner(const Key& key, std::type_index owner) {
  if (key.owner != owner)
    throw std::logic_error(
        fmt::format("the key {} is a member of {}, not of {}", key.name,
                    key.owner.name(), owner.name()));
}

std::string default_text(double value) {
  std::array<char, 32> digits{};
  std::to_chars(digits.data(), digits.data() + digits.size() - 1, value);
  std::string text = digits.data(); // "1e-08"; "1e-8" is easier to read
  if (const auto zero = text.find("e-0"); zero != text.npos)
    text.erase(zero + 2, 1);
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

std::string default_text(const mechanics::Quantity& value) {
  return value.reference == mechanics::ReferenceUnit::si
             ? default_text(value.value)
             : fmt::format("\"{:g} {}\"", value.value,
                           reference_symbol(value.reference));
}

} // namespace asperity::cases
