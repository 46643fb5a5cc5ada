#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/known_file.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/sdf_header.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace asperity::surfaces {
namespace {

constexpr const char* text_reader = "own reader of SDF (ASCII)";

using SdfFields = std::map<std::string, double, std::less<>>;

double field_of(const SdfFields& fields, const char* key,
                const std::string& name) {
  const auto found = fields.find(key);
  if (found == fields.end() || !std::isfinite(found->second))
    throw input::InputError(
        fmt::format("{}: the header has no line '{} = number'", name, key));
  return found->second;
}

std::int64_t count_of(const SdfFields& fields, const char* key,
                      const std::string& name) {
  const double number = field_of(fields, key, name);
  if (number != std::floor(number) || std::abs(number) > 1e9)
    throw input::InputError(fmt::format(
        "{}: {} = {:.6g}, but must be a whole number", name, key, number));
  return static_cast<std::int64_t>(number);
}

double sdf_number(std::string_view word, const std::string& name, int line) {
  if (word == "BAD" || word == "bad" || word == "NaN" || word == "nan")
    return std::numeric_limits<double>::quiet_NaN();
  const double number = number_of_text(word);
  if (!std::isfinite(number))
    refuse_line(name, line,
                fmt::format("found '{}', but must be a finite number or BAD",
                            printable(word)));
  return number;
}

SdfHeader header_of(const SdfFields& fields, const std::string& name) {
  SdfHeader header;
  header.points = count_of(fields, "NumPoints", name);
  header.profiles = count_of(fields, "NumProfiles", name);
  header.scale_x = field_of(fields, "Xscale", name);
  header.scale_y = field_of(fields, "Yscale", name);
  header.scale_z = field_of(fields, "Zscale", name);
  if (fields.contains("Compression"))
    header.compression =
        static_cast<int>(count_of(fields, "Compression", name));
  header.check(name);
  return header;
}

/// A part of the line without the blanks at the end of the line.
std::string_view text_in(const LinePart& part) {
  const std::string_view text = part.text;
  if (!part.is_end)
    return text;
  const std::size_t last = text.find_last_not_of(" \t\r");
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// Calls take(word, its place in the text) until it returns false.
/// @return  whether it never did
template <class Take>
bool each_word(std::string_view text, const Take& take) {
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end =
        std::min(text.find_first_of(" \t", at), text.size());
    if (!take(text.substr(at, end - at), at))
      return false;
    at = end;
  }
  return true;
}

/// A number of the text, where it begins and in which line.
struct SdfWord {
  double number = 0.0;
  std::uint64_t begin = 0;
  int line = 0;
};

std::size_t count_of(const SdfHeader& header) {
  return static_cast<std::size_t>(header.points * header.profiles);
}

/// Takes the lines of a file by parts.
class SdfText {
public:
  using TakeWord = std::function<void(const SdfWord&, const SdfHeader&)>;

  /// @param bytes  size of the file
  SdfText(std::string name, std::uint64_t bytes, TakeWord take)
      : name_(std::move(name)), bytes_(bytes), take_(std::move(take)) {}

  const SdfHeader& header() const { return header_; }

  /// @return  whether numbers may follow
  bool take(const LinePart& part) {
    if (part.is_begin)
      ++line_;
    if (line_ == 1) // the version, which has been recognised
      return true;
    if (!is_header_)
      return take_numbers(part);
    header_line_ += part.text;
    if (part.is_end)
      take_header_line(part);
    return true;
  }

  void finish() const {
    if (is_header_)
      throw input::InputError(name_ + ": the header has no end, a line with *");
    if (found_ != count_of(header_))
      throw input::InputError(
          fmt::format("{}: has {} numbers, but the header says {}", name_,
                      found_, count_of(header_)));
  }

private:
  /// Takes a line "Key = number" or the line "*".
  void take_header_line(const LinePart& part) {
    const std::string line = std::exchange(header_line_, {});
    if (line.starts_with('*')) {
      is_header_ = false;
      header_ = header_of(fields_, name_);
      require_sound_grid(
          name_, header_.points, header_.profiles, 1.0,
          bytes_ - std::min(bytes_, part.begin + part.text.size() + 1));
      return;
    }
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos)
      fields_[trimmed(line.substr(0, equals))] = number_of_text(
          trimmed(text_in({line, 0, true, true}).substr(equals + 1)));
  }

  bool take_numbers(const LinePart& part) {
    if (part.is_begin && part.text.starts_with('*'))
      return false;
    return each_word(text_in(part), [&](std::string_view word, std::size_t at) {
      if (found_ == count_of(header_))
        refuse_line(name_, line_,
                    fmt::format("more than the {} numbers of the header",
                                count_of(header_)));
      take_({sdf_number(word, name_, line_), part.begin + at, line_}, header_);
      ++found_;
      return true;
    });
  }

  std::string name_;
  std::uint64_t bytes_ = 0;
  TakeWord take_;
  bool is_header_ = true;
  std::string header_line_; ///< its parts so far
  SdfFields fields_;
  SdfHeader header_;
  std::size_t found_ = 0; ///< numbers so far
  int line_ = 0;
};

/// Where the rows of a text are.
struct SdfIndex {
  SdfHeader header;
  std::vector<SdfWord> begins; ///< first number of each row
  std::size_t missing = 0;     ///< points without a number
  double largest = 0.0;        ///< magnitude of the numbers
};

SdfIndex index_of_sdf(const std::string& path) {
  SdfIndex index;
  std::size_t in_row = 0; // numbers of the last row
  SdfText text(path, std::filesystem::file_size(path),
               [&](const SdfWord& word, const SdfHeader& header) {
                 if (in_row == 0)
                   index.begins.push_back(word);
                 if (++in_row == static_cast<std::size_t>(header.points))
                   in_row = 0;
                 if (std::isnan(word.number))
                   ++index.missing;
                 else
                   index.largest =
                       std::max(index.largest, std::abs(word.number));
               });
  each_line_part(path, 0,
                 [&](const LinePart& part) { return text.take(part); });
  text.finish();
  index.header = text.header();
  return index;
}

std::vector<double> rows_of_sdf(const std::string& path, const SdfIndex& index,
                                int first, int count) {
  const SdfWord& begin = index.begins.at(static_cast<std::size_t>(first));
  const std::size_t size = static_cast<std::size_t>(index.header.points) *
                           static_cast<std::size_t>(count);
  std::vector<double> heights;
  heights.reserve(size);
  int line = begin.line;
  each_line_part(path, begin.begin, [&](const LinePart& part) {
    if (part.is_begin && part.text.starts_with('*'))
      return false;
    const bool is_wanted = each_word(text_in(part), [&](std::string_view word,
                                                        std::size_t) {
      heights.push_back(index.header.scale_z * sdf_number(word, path, line));
      return heights.size() < size;
    });
    if (part.is_end)
      ++line;
    return is_wanted;
  });
  if (heights.size() != size)
    throw input::InputError(path + ": has fewer rows than when the run began");
  return heights;
}

} // namespace

Scan read_sdf_text(std::string_view bytes, const std::string& name) {
  std::vector<double> numbers;
  SdfText text(name, bytes.size(),
               [&](const SdfWord& word, const SdfHeader& header) {
                 numbers.reserve(count_of(header));
                 numbers.push_back(word.number);
               });
  std::size_t at = 0;
  for (bool is_wanted = true; is_wanted && at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    is_wanted = text.take({bytes.substr(at, end - at), at, true, true});
    at = end + 1;
  }
  text.finish();
  return text.header().scan(std::move(numbers), name, text_reader);
}

RowFile sdf_text_rows(const std::string& path) {
  const auto index =
      known_of_file<SdfIndex>(path, 0, [&] { return index_of_sdf(path); });
  RowFile file{index->header.grid(), "", text_reader, {}};
  file.numbers = index->header.file_numbers();
  file.rows = [path, index](int first, int count) {
    return rows_of_sdf(path, *index, first, count);
  };
  if (std::isfinite(index->largest * index->header.scale_z))
    file.missing = index->missing;
  return file;
}

} // namespace asperity::surfaces
