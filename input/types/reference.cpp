#include "input/types/reference.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/types/quantity_at_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace asperity::cases {
namespace {

constexpr std::size_t needed_fields = 5;
const std::string header = "quantity,value,unit,uncertainty,source";
// The valid headers: the required columns, followed by the optional ones. An
// optional column requires those before it.
const std::array<std::string, 3> headers = {header, header + ",why",
                                            header + ",why,input"};

// Returns the fields of a line, or nothing if a quote is not closed.
std::optional<std::vector<std::string>> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_quote = line[i] == '"';
    if (is_quote && is_quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (is_quote)
      is_quoted = !is_quoted;
    else if (line[i] == ',' && !is_quoted)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  if (is_quoted)
    return std::nullopt;
  return fields;
}

double number_in(const std::string& field, const std::string& column,
                 const input::Place& place, input::Mistakes& mistakes) {
  const auto [number, rest] = number_and_rest(field);
  if (!rest.empty() || !std::isfinite(number) ||
      (column != "value" && number < 0.0))
    mistakes.add(place, fmt::format("{} = {}, but must be a number{}", column,
                                    field, column == "value" ? "" : " >= 0"));
  return number;
}

/// Reads one line of values.
///
/// @param optional_columns  number of optional columns
void read_line(const std::string& line, const input::Place& place,
               std::size_t optional_columns,
               std::vector<ReferenceValue>& values, input::Mistakes& mistakes) {
  const auto fields = fields_of(line);
  if (!fields || fields->size() != needed_fields + optional_columns) {
    mistakes.add(place,
                 "must have the fields " + headers[optional_columns] +
                     (fields ? fmt::format(", but has {}", fields->size())
                             : ", but a quote is not closed"));
    return;
  }
  const std::vector<std::string>& field = *fields;
  const auto optional = [&](std::size_t column) {
    return column < optional_columns ? field[needed_fields + column] : "";
  };
  for (const std::size_t column : {0U, 2U, 4U})
    if (field[column].empty())
      mistakes.add(place, "has no " + std::string(column == 0U   ? "quantity"
                                                  : column == 2U ? "unit"
                                                                 : "source"));
  if (names_a_load(field[0]))
    if (const auto reading = read_quantity_at_load(field[0]); !reading.at_load)
      mistakes.add(place, field[0] + " " + reading.mistake);
  values.push_back({field[0], number_in(field[1], "value", place, mistakes),
                    field[2],
                    number_in(field[3], "uncertainty", place, mistakes),
                    field[4], optional(0), optional(1)});
}

} // namespace

std::vector<ReferenceValue> read_reference(const std::string& path) {
  return read_reference_text(
      input::read_input_file(path, input::largest_text_file), path);
}

std::vector<ReferenceValue> read_reference_text(const std::string& text,
                                                const std::string& path) {
  std::vector<ReferenceValue> values;
  input::Mistakes mistakes;
  std::istringstream lines(text);
  int line_number = 0;
  bool has_header = false;
  std::size_t optional_columns = 0;
  for (std::string line; std::getline(lines, line);) {
    const input::Place place{fmt::format("{}:{}", path, ++line_number),
                             line_number};
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    if (find_not_plain(line) != line.npos) {
      mistakes.add(place, "is not UTF-8 text without control characters");
      continue;
    }
    if (line.empty() || line.front() == '#')
      continue;
    if (has_header) {
      read_line(line, place, optional_columns, values, mistakes);
      continue;
    }
    has_header = true;
    const auto known = std::find(headers.begin(), headers.end(), line);
    if (known == headers.end())
      mistakes.add(place, fmt::format("\"{}\", but the first line must be {}",
                                      line, header));
    else
      optional_columns = static_cast<std::size_t>(known - headers.begin());
  }
  if (!has_header)
    mistakes.add({path + ":1", 1}, "is empty, but must begin with " + header);
  mistakes.throw_if_any();
  return values;
}

} // namespace asperity::cases
