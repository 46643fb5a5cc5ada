// Formats the difference of two results or cases as text and as JSON.
#include "base/json.hpp"
#include "run/difference.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::run {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::size_t most_rows = 20; ///< listed for one method

std::string or_none(const std::string& text) {
  return text.empty() ? "(none)" : text;
}

std::string texts_lines(const std::string& title,
                        const std::vector<TextDifference>& texts) {
  if (texts.empty())
    return "";
  std::string lines = title + "\n";
  for (const TextDifference& text : texts)
    lines += fmt::format("  {:<32} {} | {}\n", text.name, or_none(text.one),
                         or_none(text.other));
  return lines;
}

std::string row_line(const NumberDifference& row) {
  return fmt::format(
      "  {:<14} realization {} step {:>2}  {} {:.10g} | {:.10g}, relative "
      "{:.2g}\n",
      row.method, row.realization, row.step, row.column, row.one, row.other,
      row.relative);
}

std::string method_lines(const MethodDifference& method, double tolerance) {
  if (method.largest.relative == 0.0)
    return fmt::format("{:<16} {} rows are equal\n", method.method,
                       method.rows);
  std::string lines = fmt::format(
      "{:<16} {} of {} rows differ by more than {:g}; largest relative "
      "difference {:.2g} ({})\n",
      method.method, method.rows_that_differ, method.rows, tolerance,
      method.largest.relative, method.largest.column);
  for (std::size_t i = 0; i < method.rows_listed.size(); ++i) {
    if (i == most_rows) {
      lines += fmt::format("  ... and {} more rows\n",
                           method.rows_listed.size() - most_rows);
      break;
    }
    lines += row_line(method.rows_listed[i]);
  }
  return lines;
}

OrderedJson number_or_null(double number) {
  return std::isfinite(number) ? OrderedJson(number) : OrderedJson(nullptr);
}

OrderedJson texts_json(const std::vector<TextDifference>& texts) {
  OrderedJson list = OrderedJson::array();
  for (const TextDifference& text : texts)
    list.push_back({{"name", text.name},
                    {"one", text.one.empty() ? OrderedJson(nullptr)
                                             : OrderedJson(text.one)},
                    {"other", text.other.empty() ? OrderedJson(nullptr)
                                                 : OrderedJson(text.other)}});
  return list;
}

OrderedJson row_json(const NumberDifference& row) {
  return {{"realization", row.realization},
          {"step", row.step},
          {"column", row.column},
          {"one", number_or_null(row.one)},
          {"other", number_or_null(row.other)},
          {"relative", number_or_null(row.relative)}};
}

} // namespace

std::string difference_text(const Difference& difference, double tolerance) {
  std::string text =
      texts_lines("keys of the case, in SI units:", difference.keys) +
      texts_lines("input files (SHA-256):", difference.inputs) +
      texts_lines("build and machine (not counted):", difference.build) +
      texts_lines("only on one side:", difference.missing);
  for (const MethodDifference& method : difference.methods)
    text += method_lines(method, tolerance);
  if (!difference.has_numbers)
    text += "only cases are compared: numbers need two results\n";
  return text + (difference.is_any() ? "different\n" : "equal\n");
}

std::string difference_json(const Difference& difference, double tolerance) {
  OrderedJson json = {{"format", "asperity-diff"},
                      {"format_version", 1},
                      {"is_different", difference.is_any()},
                      {"tolerance", tolerance},
                      {"keys", texts_json(difference.keys)},
                      {"inputs", texts_json(difference.inputs)},
                      {"build", texts_json(difference.build)},
                      {"missing", texts_json(difference.missing)},
                      {"methods", OrderedJson::array()}};
  for (const MethodDifference& method : difference.methods) {
    OrderedJson rows = OrderedJson::array();
    for (const NumberDifference& row : method.rows_listed)
      rows.push_back(row_json(row));
    json["methods"].push_back(
        {{"name", method.method},
         {"rows", method.rows},
         {"rows_that_differ", method.rows_that_differ},
         {"largest", method.largest.relative > 0.0 ? row_json(method.largest)
                                                   : OrderedJson(nullptr)},
         {"differences", rows}});
  }
  return text_of_json(json, 2) + "\n";
}

} // namespace asperity::run
