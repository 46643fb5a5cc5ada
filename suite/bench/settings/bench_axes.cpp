#include "suite/bench/settings/bench_axes.hpp"

#include "base/special_numbers.hpp"
#include "input/reader/vocabulary.hpp"
#include "input/text/toml_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace asperity::bench {
namespace {

/// A condition on the values of other keys under which a key has an effect.
using Condition =
    std::function<bool(const CaseValues& values, const std::string& method)>;

bool always(const CaseValues&, const std::string&) {
  return true;
}

Condition is(const std::string& key, const std::string& word) {
  return [=](const CaseValues& values, const std::string& method) {
    const auto found = values.value(method, key);
    return found && found->text == word;
  };
}

Condition is_not(const std::string& key, const std::string& word) {
  return [=](const CaseValues& values, const std::string& method) {
    const auto found = values.value(method, key);
    return !found || found->text != word;
  };
}

/// The variation of a key: its values are the case's own value times these
/// factors, coarse to fine. For the grading ratio, only the part above 1 is
/// multiplied.
struct Rule {
  std::string key;
  std::string title;
  std::vector<double> factors; ///< empty: the keywords of the key
  double order = not_a_number;
  std::string source;
  double power =
      not_a_number; ///< the coordinate is factor^power; NaN: no coordinate
  Condition acts = always;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all{
      {"element", "element", {}, not_a_number, "another element: no order"},
      {"growth",
       "grading ratio of the layers",
       {2.0, 1.0, 0.5},
       2.0,
       "Q1: second order in the logarithm of the grading ratio "
       "(docs/numerics/fem.md); "
       "Q2: fourth",
       1.0},
      {"surface_cell_depth",
       "depth of the surface cells",
       {2.0, 1.0, 0.5},
       not_a_number,
       "changes only the cells at the contact surface: no limit of its own"},
      {"depth",
       "depth of the block",
       {0.5, 1.0, 2.0},
       not_a_number,
       "exponential in the depth over the longest wavelength: no order",
       not_a_number,
       is_not("bulk", "explicit")},
      {"thickness",
       "thickness of the slab",
       {0.5, 1.0, 2.0},
       not_a_number,
       "exponential in the thickness over the longest wavelength: no order"},
      {"penalty",
       "penalty",
       {0.1, 1.0, 10.0},
       1.0,
       "penetration p/k: first order in 1/k",
       -1.0,
       is_not("contact", "hard")},
      {"tolerance",
       "tolerance",
       {1e4, 1e2, 1.0},
       1.0,
       "remaining residual: at most first order",
       1.0},
      {"layers",
       "layers of cells per level",
       {0.5, 1.0, 2.0},
       not_a_number,
       "exponential in the depth: no order",
       not_a_number,
       is("bulk", "explicit")},
      {"cutoff",
       "cut-off of the interaction",
       {0.75, 1.0, 1.5},
       not_a_number,
       "by the decay of the potential: no order"}};
  return all;
}

std::string multiplied(const cases::Node& own, const Rule& rule,
                       double factor) {
  if (rule.key == "growth")
    return fmt::format("{}", 1.0 + (own.number() - 1.0) * factor);
  return scaled_value(own, factor);
}

double coordinate_of(const cases::Node& own, const Rule& rule, double factor) {
  if (rule.key == "growth")
    return std::log1p((own.number() - 1.0) * factor);
  return std::pow(factor, rule.power); // NaN without a power
}

std::vector<AxisValue> numbers_of(const cases::Node& own, const Rule& rule,
                                  const cases::Key& key) {
  std::vector<AxisValue> values;
  if (!std::isfinite(leading_number(own)))
    return values;
  for (const double factor : rule.factors) {
    const bool is_own = factor == 1.0;
    const std::string text = multiplied(own, rule, factor);
    const bool is_bare = own.is_number();
    if (!is_own && is_bare && !key.range.contains(std::stod(text)))
      continue;
    if (!values.empty() && values.back().text == text)
      continue; // integers that round to the same value
    values.push_back({text, coordinate_of(own, rule, factor), is_own});
  }
  return values;
}

std::vector<AxisValue> words_of(const cases::Node& own, const cases::Key& key) {
  std::vector<AxisValue> values;
  for (const std::string& word : key.words)
    values.push_back({word, not_a_number, word == own.text});
  return values;
}

} // namespace

std::vector<Axis> axes_of(const CaseValues& values, const std::string& method) {
  std::vector<Axis> axes;
  for (const Rule& rule : rules()) {
    const cases::Key* const key =
        cases::find_key(cases::kind_of_method(method), rule.key);
    if (key == nullptr || !rule.acts(values, method))
      continue;
    const auto own = values.value(method, rule.key);
    if (!own)
      continue; // no value around which to vary
    Axis axis{rule.key, rule.title,
              rule.factors.empty() ? words_of(*own, *key)
                                   : numbers_of(*own, rule, *key),
              rule.order, rule.source};
    if (axis.values.size() > 1)
      axes.push_back(std::move(axis));
  }
  return axes;
}

bool varies_with_points(const std::string& kind) {
  return kind == "halfspace" || kind == "fem";
}

} // namespace asperity::bench
