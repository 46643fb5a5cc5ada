#include "base/plain_text.hpp"
#include "base/special_numbers.hpp"
#include "input/nearest.hpp"
#include "input/reader/read_parts.hpp"
#include "input/reader/study_keys.hpp"
#include "input/types/expectations.hpp"
#include "input/types/quantity_at_load.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace asperity::cases {
namespace {

struct ReadSoFar {
  mechanics::SurfaceKind surface;
  const std::vector<MethodSpec>& methods;
  const Case& read;

  bool has(const std::string& study) const {
    return study.empty() || is_asked(read, study);
  }
};

bool is_theory(const MethodSpec& method) {
  return std::holds_alternative<mechanics::TheorySettings>(method.settings);
}

bool answers(const MethodSpec& method, const ExpectationName& quantity,
             const ReadSoFar& read_so_far) {
  if (!quantity.study.empty())
    return &method ==
           study_theory(read_so_far.read.surface, read_so_far.methods);
  const bool is_variant = method.name.find('.') != std::string::npos;
  return (is_theory(method) ? quantity.theory_answers
                            : !quantity.theory_only) &&
         (is_variant || !quantity.variants_only);
}

/// Returns the half-width of the band: a number, or a percentage of |value|
/// such as "5 %".
double half_width(TableReader& band, double value) {
  const Node* const within = band.entry("within");
  if (!within)
    return 0.0;
  if (within->is_number())
    return band.number("within");
  const auto [percent, unit] = number_and_rest(within->text);
  if ((unit != " %" && unit != "%") ||
      !(percent >= 0.0 && std::isfinite(percent))) {
    band.refuse(*within, "must be a number >= 0 or a string like \"5 %\"");
    return 0.0;
  }
  return std::abs(value) * percent / 100.0;
}

void read_ends(TableReader& band, Expectation& expectation) {
  const bool has_middle = band.has("value") || band.has("within");
  const bool has_end = band.has("below") || band.has("above");
  if (has_middle == has_end) {
    band.complain(band.node(), "must have value and within, or below, or above "
                               "(or both of these)");
    return;
  }
  if (has_middle) {
    const double middle = band.number("value");
    const double half = half_width(band, middle);
    expectation.low = middle - half;
    expectation.high = middle + half;
    return;
  }
  expectation.low = band.has("above") ? band.number("above") : -infinity;
  expectation.high = band.has("below") ? band.number("below") : infinity;
  if (expectation.low > expectation.high)
    band.complain(band.node(), "is empty: above exceeds below");
}

void check_surface(TableReader& band, const ExpectationName& quantity,
                   const ReadSoFar& read_so_far) {
  const auto& kinds = quantity.surfaces;
  if (!kinds.empty() && std::find(kinds.begin(), kinds.end(),
                                  read_so_far.surface) == kinds.end()) {
    const auto& words =
        vocabulary_key(vocabulary_table("surface"), "kind").words;
    std::vector<std::string> allowed;
    allowed.reserve(kinds.size());
    for (const mechanics::SurfaceKind kind : kinds)
      allowed.push_back(words[static_cast<std::size_t>(kind)]);
    band.complain(band.node(),
                  fmt::format("is defined only for the surfaces {}",
                              fmt::join(allowed, ", ")));
  }
  if (!read_so_far.has(quantity.study))
    band.complain(band.node(), "needs the table [" + quantity.study + "]");
  if (quantity.needs_theory &&
      std::none_of(read_so_far.methods.begin(), read_so_far.methods.end(),
                   is_theory))
    band.complain(
        band.node(),
        "is a comparison with theory, but the table [theory] is missing");
}

std::vector<std::string> answering(const ExpectationName& quantity,
                                   const ReadSoFar& read_so_far) {
  std::vector<std::string> names;
  for (const MethodSpec& method : read_so_far.methods)
    if (answers(method, quantity, read_so_far))
      names.push_back(method.name);
  return names;
}

void read_method_names(TableReader& band, const ExpectationName& quantity,
                       const ReadSoFar& read_so_far, Expectation& expectation) {
  const std::vector<std::string> allowed = answering(quantity, read_so_far);
  if (!band.has("methods")) {
    expectation.methods = allowed;
    if (allowed.empty() && !read_so_far.methods.empty())
      band.complain(band.node(), "is computed by none of the case's methods");
    return;
  }
  expectation.methods = band.names("methods");
  if (allowed.empty()) {
    band.complain(*band.node().find("methods"),
                  "names methods, but none of this case computes " +
                      quantity.name);
    return;
  }
  for (const std::string& name : expectation.methods)
    if (!name.empty() &&
        std::find(allowed.begin(), allowed.end(), name) == allowed.end())
      band.complain(*band.node().find("methods"),
                    fmt::format("names \"{}\", but the methods of this case "
                                "that compute {} are: {}; nearest: {}",
                                name, quantity.name, fmt::join(allowed, ", "),
                                input::nearest(name, allowed)));
}

/// Returns the keys that are quantities at a load, and reports the mistakes in
/// them.
std::vector<std::string> keys_at_load(TableReader& reader) {
  std::vector<std::string> keys;
  for (const NodeEntry& entry : reader.node().entries)
    if (names_a_load(entry.key)) {
      keys.push_back(entry.key);
      const std::string mistake = read_quantity_at_load(entry.key).mistake;
      if (!mistake.empty())
        reader.complain(entry.node, mistake);
    }
  return keys;
}

Expectation read_band(const Node& node, const std::string& name,
                      const ExpectationName& quantity,
                      const ReadSoFar& read_so_far, Mistakes& mistakes) {
  TableReader band(node, vocabulary_table("expect.band"), mistakes);
  band.refuse_unknown();
  Expectation expectation{.quantity = name, .methods = {}};
  read_ends(band, expectation);
  check_surface(band, quantity, read_so_far);
  read_method_names(band, quantity, read_so_far, expectation);
  band.read(expectation);
  return expectation;
}

} // namespace

std::vector<Expectation> read_expectations(const Node& table,
                                           mechanics::SurfaceKind kind,
                                           const Case& read,
                                           Mistakes& mistakes) {
  const ReadSoFar read_so_far{kind, read.methods, read};
  TableReader reader(table, vocabulary_table("expect"), mistakes);
  reader.refuse_unknown(keys_at_load(reader));
  std::vector<Expectation> expectations;
  for (const NodeEntry& entry : table.entries) {
    const ExpectationName* const quantity = expectation_called(entry.key);
    if (!quantity)
      continue; // reported above
    const bool is_list =
        entry.node.type == NodeType::list && !entry.node.list.empty();
    for (const Node& band :
         is_list ? entry.node.list : std::vector<Node>{entry.node})
      if (band.is_table())
        expectations.push_back(
            read_band(band, entry.key, *quantity, read_so_far, mistakes));
      else
        reader.refuse(band, "must be { value, within } or { below } or "
                            "{ above }, or a list of such bands");
  }
  return expectations;
}

} // namespace asperity::cases
