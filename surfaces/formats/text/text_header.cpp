#include "surfaces/formats/text/text_header.hpp"

#include "base/plain_text.hpp"
#include "surfaces/formats/length_units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace asperity::surfaces {
namespace {

/// "key: content", both without blanks at their ends.
struct HeaderEntry {
  int line = 0;
  std::string key;
  std::string content;
};

std::vector<HeaderEntry> entries_of(const NumberTable& table, char separator) {
  std::vector<HeaderEntry> entries;
  for (const CommentLine& comment : table.comments) {
    const std::size_t end = comment.text.find(separator);
    if (end != std::string::npos && end > 0)
      entries.push_back({comment.line, trimmed(comment.text.substr(0, end)),
                         trimmed(comment.text.substr(end + 1))});
  }
  return entries;
}

GwyddionHeader english_header(const std::vector<HeaderEntry>& entries) {
  GwyddionHeader header;
  const auto take = [](CommentLine& line, const HeaderEntry& entry) {
    if (line.line == 0)
      line = {entry.line, entry.content};
  };
  for (const HeaderEntry& entry : entries) {
    if (entry.key == "Channel")
      take(header.channel, entry);
    else if (entry.key == "Width")
      take(header.width, entry);
    else if (entry.key == "Height")
      take(header.height, entry);
    else if (entry.key == "Value units")
      take(header.value_units, entry);
  }
  return header;
}

GwyddionHeader translated_header(const std::vector<HeaderEntry>& entries) {
  GwyddionHeader header;
  for (const HeaderEntry& entry : entries) {
    const CommentLine line{entry.line, entry.content};
    if (length_of_text(entry.content)) {
      (header.width.line == 0 ? header.width : header.height) = line;
    } else if (header.width.line == 0) {
      header.channel = line;
    } else if (header.height.line != 0) {
      header.value_units = line;
      break;
    }
  }
  return header.height.line == 0 ? GwyddionHeader() : header;
}

double positive_number(const NumberTable& table, const HeaderEntry& entry,
                       double number) {
  if (!std::isfinite(number) || number <= 0.0)
    refuse_line(table.name, entry.line,
                fmt::format("{}: found '{}', but must be > 0",
                            printable(entry.key), printable(entry.content)));
  return number;
}

/// Checks "h=650 w=650" against the rows and columns that are there.
void check_counts(const NumberTable& table) {
  for (const CommentLine& comment : table.comments) {
    std::string_view rest = comment.text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      const std::string_view word = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      const bool is_rows = word.starts_with("h=");
      if (!is_rows && !word.starts_with("w="))
        continue;
      const std::size_t found = is_rows ? table.rows() : table.columns;
      if (number_of_text(word.substr(2)) != static_cast<double>(found))
        refuse_line(table.name, comment.line,
                    fmt::format("found '{}', but the file has {} {}",
                                printable(word), found,
                                is_rows ? "rows" : "columns"));
    }
  }
}

} // namespace

GwyddionHeader gwyddion_header(const NumberTable& table) {
  const std::vector<HeaderEntry> entries = entries_of(table, ':');
  const GwyddionHeader english = english_header(entries);
  return english.width.line != 0 ? english : translated_header(entries);
}

MatrixHeader matrix_header(const NumberTable& table) {
  check_counts(table);
  MatrixHeader header;
  std::optional<double> data_unit;
  for (const HeaderEntry& entry : entries_of(table, '=')) {
    if (entry.key == "pixel size")
      header.pixel_size = positive_number(
          table, entry, length_of_text(entry.content).value_or(0.0));
    else if (entry.key == "height conversion factor (-> m)")
      header.height_unit =
          positive_number(table, entry, number_of_text(entry.content));
    else if (entry.key == "data unit")
      data_unit = length_unit(entry.content);
  }
  if (!header.height_unit)
    header.height_unit = data_unit;
  return header;
}

} // namespace asperity::surfaces
