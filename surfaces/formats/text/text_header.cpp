#include "surfaces/formats/text/text_header.hpp"

#include "base/plain_text.hpp"
#include "surfaces/formats/length_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

/// Whether a word is "Width" in a language of Gwyddion.
bool is_width(const std::string& word) {
  static constexpr std::string_view words[] = {
      "\xC5\xA0\xC3\xAD\xC5\x99ka", // Czech
      "Breite",
      "Anchura",
      "Largeur",
      "Larghezza",
      "Largura",
      "\xE5\xB9\x85",                                      // Japanese
      "\xED\x8F\xAD",                                      // Korean
      "\xD0\xA8\xD0\xB8\xD1\x80\xD0\xB8\xD0\xBD\xD0\xB0"}; // Russian
  return std::ranges::find(words, word) != std::end(words);
}

GwyddionHeader translated_header(const std::vector<HeaderEntry>& entries) {
  GwyddionHeader header;
  for (const HeaderEntry& entry : entries) {
    const CommentLine line{entry.line, entry.content};
    if (length_of_text(entry.content)) {
      if (header.width.line == 0 && !is_width(entry.key))
        return {};
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

/// Keys of a grid of ESRI, which are separated from their numbers by blanks.
constexpr std::string_view grid_keys[] = {
    "ncols",     "nrows",     "cellsize",  "nodata_value",
    "xllcorner", "yllcorner", "xllcenter", "yllcenter"};

/// The key in lower case and the content of a header line, without quotes.
HeaderEntry entry_of(const CommentLine& comment) {
  std::string text = comment.text;
  std::erase(text, '"');
  std::size_t end = text.find_first_of(" \t");
  if (!is_grid_key(text.substr(0, end))) {
    end = text.find('=');
    if (end == std::string::npos)
      end = text.find_first_of(":\t,;");
  }
  const std::size_t rest = end == std::string::npos ? text.size() : end + 1;
  return {comment.line, lower_case(trimmed(text.substr(0, end))),
          trimmed(text.substr(rest))};
}

/// The number at the beginning of a text; NaN if there is none.
double first_number(const std::string& text) {
  return number_of_text(text.substr(0, text.find_first_of(" \t,;")));
}

/// Reads the header of a matrix line by line.
class MatrixHeaderReader {
public:
  explicit MatrixHeaderReader(const NumberTable& table) : table_(table) {
    for (const CommentLine& comment : table.comments) {
      const HeaderEntry entry = entry_of(comment);
      is_spip_ |= entry.key == "file format" && entry.content == "ASCII";
      is_keyence_ |= entry.key == "xy calibration";
    }
  }

  MatrixHeader read() {
    for (const CommentLine& comment : table_.comments)
      if (!take(entry_of(comment)) && !take_counts(comment) &&
          names_size(comment))
        header_.not_understood.push_back(comment);
    if (!header_.height_unit)
      header_.height_unit = weaker_unit_;
    return std::move(header_);
  }

private:
  /// @return  whether the line is understood
  bool take(const HeaderEntry& entry) {
    const std::string& key = entry.key;
    if (key == "pixel size")
      take_pixel(entry, entry.content);
    else if (key == "height conversion factor (-> m)")
      header_.height_unit =
          positive_number(table_, entry, number_of_text(entry.content));
    else if (key == "data unit")
      weaker_unit_ = length_unit(entry.content);
    else if (key == "ncols" || key == "x-pixels")
      check_count(entry, table_.columns, "columns");
    else if (key == "nrows" || key == "y-pixels")
      check_count(entry, table_.rows(), "rows");
    else if (key == "cellsize")
      header_.cell_size =
          positive_number(table_, entry, number_of_text(entry.content));
    else if (key == "nodata_value")
      header_.missing_value = number_of_text(entry.content);
    else
      return is_grid_key(key) || (is_spip_ && take_spip(entry)) ||
             (is_keyence_ && take_keyence(entry));
    return true;
  }

  /// Lengths of SPIP are in nm.
  bool take_spip(const HeaderEntry& entry) {
    const auto nanometres = [&] {
      return 1e-9 * positive_number(table_, entry, first_number(entry.content));
    };
    if (entry.key == "x-length")
      header_.length_x = nanometres();
    else if (entry.key == "y-length")
      header_.length_y = nanometres();
    else if (entry.key == "bit2nm")
      weaker_unit_ = nanometres();
    else if (entry.key == "z-unit")
      take_height_unit(entry);
    else if (entry.key == "voidpixels" && first_number(entry.content) != 0.0)
      refuse_line(table_.name, entry.line,
                  "the file marks missing points by a second matrix; format = "
                  "\"convert\" reads it by the program Gwyddion");
    else
      return entry.key == "voidpixels" || entry.key == "x-offset" ||
             entry.key == "y-offset" || entry.key == "file format";
    return true;
  }

  /// "XY Calibration","277","nm/pixel" and "Unit","um".
  bool take_keyence(const HeaderEntry& entry) {
    if (entry.key == "xy calibration") {
      std::string length = entry.content.substr(0, entry.content.find('/'));
      std::ranges::replace(length, ',', ' ');
      take_pixel(entry, length);
    } else if (entry.key == "unit") {
      take_height_unit(entry);
    } else if (entry.key == "horizontal") {
      check_count(entry, table_.columns, "columns");
    } else if (entry.key == "vertical") {
      check_count(entry, table_.rows(), "rows");
    } else {
      return entry.key == "minimum value" || entry.key == "maximum value";
    }
    return true;
  }

  void take_pixel(const HeaderEntry& entry, const std::string& text) {
    const std::optional<double> size = length_of_text(text);
    if (!size)
      refuse_line(table_.name, entry.line,
                  fmt::format("{}: found '{}', but must be a number > 0 and a "
                              "unit of {}",
                              printable(entry.key), printable(entry.content),
                              known_length_units()));
    const double pixel = positive_number(table_, entry, *size);
    header_.length_x = pixel * static_cast<double>(table_.columns);
    header_.length_y = pixel * static_cast<double>(table_.rows());
  }

  void take_height_unit(const HeaderEntry& entry) {
    std::string unit = entry.content;
    std::erase_if(unit, [](char letter) {
      return letter == '[' || letter == ']' || letter == '(' || letter == ')';
    });
    header_.height_unit = length_unit(unit);
    if (!header_.height_unit)
      refuse_line(table_.name, entry.line,
                  fmt::format("{}: found '{}', but must be one of {}",
                              printable(entry.key), printable(entry.content),
                              known_length_units()));
  }

  void check_count(const HeaderEntry& entry, std::size_t found,
                   const char* what) const {
    if (first_number(entry.content) != static_cast<double>(found))
      refuse_line(table_.name, entry.line,
                  fmt::format("found '{} {}', but the file has {} {}",
                              printable(entry.key), printable(entry.content),
                              found, what));
  }

  /// Checks "h=650 w=650" against the rows and columns that are there.
  /// @return  whether the line has no other words
  bool take_counts(const CommentLine& comment) const {
    bool is_complete = !comment.text.empty();
    for (const std::string_view word : words_of(comment.text, " ")) {
      const bool is_rows = word.starts_with("h=");
      if (!is_rows && !word.starts_with("w=")) {
        is_complete = false;
        continue;
      }
      const std::size_t found = is_rows ? table_.rows() : table_.columns;
      if (number_of_text(word.substr(2)) != static_cast<double>(found))
        refuse_line(table_.name, comment.line,
                    fmt::format("found '{}', but the file has {} {}",
                                printable(word), found,
                                is_rows ? "rows" : "columns"));
    }
    return is_complete;
  }

  const NumberTable& table_;
  bool is_spip_ = false, is_keyence_ = false;
  MatrixHeader header_;
  std::optional<double> weaker_unit_; ///< of heights, unless another is given
};

/// The words of a line, and units that follow their number directly apart from
/// it.
std::vector<std::string> words_of_header(const std::string& line) {
  std::vector<std::string> words;
  std::string_view rest = line;
  constexpr std::string_view between = " \t,;:=()[]{}\"'/|";
  while (true) {
    const std::size_t begin = rest.find_first_not_of(between);
    if (begin == std::string_view::npos)
      return words;
    rest.remove_prefix(begin);
    std::string word(rest.substr(0, rest.find_first_of(between)));
    rest.remove_prefix(word.size());
    const std::size_t unit = word.find_last_of("0123456789.") + 1;
    if (unit > 0 && unit < word.size() && length_of_text(word)) {
      words.push_back(word.substr(0, unit));
      word.erase(0, unit);
    }
    words.push_back(word);
  }
}

/// What a header line says of lengths.
struct NamedLengths {
  std::vector<double> lengths; ///< numbers with a unit [m]
  std::vector<double> units;   ///< without a number [m]
};

NamedLengths named_lengths(const CommentLine& comment) {
  NamedLengths found;
  double number = std::nan("");
  for (const std::string& word : words_of_header(comment.text)) {
    const bool is_bracketed =
        comment.text.find('[' + word + ']') != std::string::npos ||
        comment.text.find('(' + word + ')') != std::string::npos;
    // pm is a time of the day more often than a unit, and in a word. A letter
    // m is a unit behind a number or in brackets only.
    const bool is_prose = word == "pm" || (word == "in" && !is_bracketed);
    const std::optional<double> unit =
        is_prose ? std::nullopt : length_unit(word);
    if (unit && std::isfinite(number))
      found.lengths.push_back(number * *unit);
    else if (unit && (word != "m" || is_bracketed))
      found.units.push_back(*unit);
    number = number_of_text(word);
  }
  return found;
}

} // namespace

bool is_grid_key(std::string_view word) {
  return std::ranges::find(grid_keys, lower_case(word)) != std::end(grid_keys);
}

bool names_size(const CommentLine& comment) {
  const HeaderEntry entry = entry_of(comment);
  const NamedLengths named = named_lengths(comment);
  static constexpr std::string_view words[] = {
      "size",   "length",      "width",  "height",     "pitch",    "spacing",
      "scale",  "pixel",       "step",   "resolution", "unit",     "range",
      "extent", "calibration", "field",  "amplitude",  "sampling", "interval",
      "xreal",  "yreal",       "lateral"};
  static constexpr std::string_view axes[] = {"x",  "y",  "z",  "dx",
                                              "dy", "dz", "lx", "ly"};
  const std::string line = lower_case(comment.text);
  const bool has_word =
      std::ranges::any_of(words,
                          [&](std::string_view word) {
                            return line.find(word) != std::string::npos;
                          }) ||
      std::ranges::any_of(words_of_header(line), [&](const std::string& word) {
        return std::ranges::find(axes, word) != std::end(axes);
      });
  const std::vector<std::string> all = words_of_header(comment.text);
  constexpr std::size_t few_words = 4;
  const bool ends_with_number = !all.empty() && all.size() <= few_words &&
                                std::isfinite(number_of_text(all.back()));
  return !named.lengths.empty() ||
         (has_word && (!named.units.empty() || ends_with_number ||
                       std::isfinite(first_number(entry.content))));
}

namespace {

bool is_in(double value, const std::vector<double>& known) {
  constexpr double rounding = 0.01;
  return std::ranges::any_of(known, [&](double one) {
    return std::abs(value - one) <= rounding * one;
  });
}

[[noreturn]] void refuse_header(const std::string& name,
                                const CommentLine& line) {
  refuse_line(name, line.line,
              fmt::format("'{}' names a size or a unit, which this reader does "
                          "not understand and the case does not repeat; format "
                          "= \"plain\" (or \"xyz\" for a list) with the "
                          "lengths and units of the case reads the numbers "
                          "without this header",
                          printable(line.text)));
}

} // namespace

void require_understood(const std::vector<CommentLine>& lines,
                        const std::string& name,
                        const std::vector<double>& known_lengths,
                        const std::vector<double>& known_units) {
  for (const CommentLine& line : lines) {
    const NamedLengths named = named_lengths(line);
    const bool is_known =
        std::ranges::all_of(
            named.lengths,
            [&](double length) { return is_in(length, known_lengths); }) &&
        std::ranges::all_of(
            named.units, [&](double unit) { return is_in(unit, known_units); });
    if (!is_known || (named.lengths.empty() && named.units.empty()))
      refuse_header(name, line);
  }
}

void require_list_header(const NumberTable& table, const MapScale& scale) {
  const std::vector<double> units = {scale.length_unit.value_or(0.0),
                                     scale.length_unit.value_or(0.0),
                                     scale.height_unit.value_or(0.0)};
  for (const CommentLine& line : table.comments) {
    if (!names_size(line))
      continue;
    const NamedLengths named = named_lengths(line);
    const bool has_columns =
        named.lengths.empty() && named.units.size() == units.size();
    if (!has_columns)
      require_understood({line}, table.name, {}, units);
    for (std::size_t i = 0; has_columns && i < units.size(); ++i)
      if (!is_in(named.units[i], {units[i]}))
        refuse_header(table.name, line);
  }
}

GwyddionHeader gwyddion_header(const NumberTable& table) {
  const std::vector<HeaderEntry> entries = entries_of(table, ':');
  const GwyddionHeader english = english_header(entries);
  return english.width.line != 0 ? english : translated_header(entries);
}

MatrixHeader matrix_header(const NumberTable& table) {
  return MatrixHeaderReader(table).read();
}

} // namespace asperity::surfaces
