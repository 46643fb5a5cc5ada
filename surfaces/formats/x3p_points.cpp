#include "surfaces/formats/x3p_points.hpp"

#include "base/plain_text.hpp"
#include "surfaces/formats/byte_reader.hpp"
#include "surfaces/formats/known_file.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/own_readers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace asperity::surfaces {
namespace {

constexpr double x3p_missing = std::numeric_limits<double>::quiet_NaN();

/// Points that are decoded at a time.
constexpr std::size_t points_at_a_time = std::size_t{1} << 14;

double take_coordinate(const X3pAxis& axis, ByteReader& bytes) {
  const double number = axis.type == 'I'   ? bytes.take<std::int16_t>()
                        : axis.type == 'L' ? bytes.take<std::int32_t>()
                        : axis.type == 'F'
                            ? static_cast<double>(bytes.take<float>())
                            : bytes.take<double>();
  return axis.offset + axis.increment * number;
}

} // namespace

/// The points one after the other: of a member of the archive, with the bits of
/// those that are valid, or of main.xml itself.
class X3pStream {
public:
  explicit X3pStream(const X3pFile& file) : file_(&file) {
    if (file.are_points_listed()) {
      take_list();
      return;
    }
    points_.emplace(file, "PointDataLink", "MD5ChecksumPointData");
    if (!file.document.text_at(x3p_link_path + "ValidPointsLink").empty())
      valid_.emplace(file, "ValidPointsLink", "MD5ChecksumValidPoints");
  }

  /// Number of the next point.
  std::size_t next() const { return next_; }

  /// Whether all points are there, by the sizes that the archive states.
  bool is_complete() const {
    return are_sizes_sound(file_->header.size_x, file_->header.size_y) &&
           (!points_ || points_->size() / point_bytes() >= file_->count()) &&
           (!valid_ || valid_->size() >= valid_bytes());
  }

  void skip_to(std::size_t point) {
    while (next_ < point) {
      const std::size_t n = std::min(point - next_, points_at_a_time);
      points_->read(n * point_bytes());
      next_ += n;
    }
  }

  /// Returns some of the points.
  std::vector<X3pPoint> take(std::size_t most) {
    std::vector<X3pPoint> taken(std::min(most, points_at_a_time));
    if (!points_) {
      for (X3pPoint& point : taken)
        point = listed_point(listed_[next_++]);
      return taken;
    }
    ByteReader bytes(points_->read(taken.size() * point_bytes()),
                     points_->full_name(), next_ * point_bytes());
    for (X3pPoint& point : taken) {
      point = stored_point(bytes);
      if (valid_ && !is_valid(next_))
        point.z = x3p_missing;
      ++next_;
    }
    return taken;
  }

  /// Reads to the end and compares sizes and checksums.
  void finish() {
    if (!points_)
      return;
    points_->finish();
    require_sound_grid(points_->full_name(), file_->header.size_x,
                       file_->header.size_y, static_cast<double>(point_bytes()),
                       points_->size());
    points_->compare_sum();
    if (!valid_)
      return;
    valid_->finish();
    if (valid_->size() < valid_bytes())
      file_->document.refuse(fmt::format(
          "{} has {} bytes, but {} points need {}", printable(valid_->name()),
          valid_->size(), file_->count(), valid_bytes()));
    valid_->compare_sum();
  }

private:
  std::size_t point_bytes() const {
    const X3pHeader& header = file_->header;
    return header.x.stored_bytes() + header.y.stored_bytes() +
           header.z.stored_bytes();
  }

  std::size_t valid_bytes() const { return (file_->count() + 7) / 8; }

  /// Takes the numbers in main.xml itself.
  void take_list() {
    listed_ = file_->document.texts_in("Record3/DataList");
    if (listed_.empty())
      file_->document.refuse(
          "Record3 has neither a PointDataLink nor a DataList");
    require_sound_grid(file_->name + ": main.xml", file_->header.size_x,
                       file_->header.size_y, 1.0, listed_.size());
    if (listed_.size() != file_->count())
      file_->document.refuse(fmt::format("{} points in DataList, but {} in "
                                         "MatrixDimension",
                                         listed_.size(), file_->count()));
  }

  X3pPoint stored_point(ByteReader& bytes) const {
    const X3pHeader& header = file_->header;
    X3pPoint point;
    if (header.x.is_absolute)
      point.x = take_coordinate(header.x, bytes);
    if (header.y.is_absolute)
      point.y = take_coordinate(header.y, bytes);
    point.z = take_coordinate(header.z, bytes);
    return point;
  }

  /// The absolute coordinates, separated by semicolons; an empty text is a
  /// missing point.
  X3pPoint listed_point(const std::string& text) const {
    const X3pHeader& header = file_->header;
    if (text.empty() && !header.x.is_absolute && !header.y.is_absolute)
      return {0.0, 0.0, x3p_missing};
    std::vector<double> numbers;
    std::string_view rest = text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(';'), rest.size());
      numbers.push_back(number_of_text(trimmed(rest.substr(0, end))));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const std::size_t stored =
        1 + (header.x.is_absolute ? 1U : 0U) + (header.y.is_absolute ? 1U : 0U);
    if (numbers.size() != stored)
      file_->document.refuse(
          fmt::format("found the point '{}', but must be {} number(s)",
                      printable(text), stored));
    std::size_t at = 0;
    const auto next = [&](const X3pAxis& axis) {
      return axis.offset + axis.increment * numbers[at++];
    };
    X3pPoint point;
    if (header.x.is_absolute)
      point.x = next(header.x);
    if (header.y.is_absolute)
      point.y = next(header.y);
    point.z = next(header.z);
    return point;
  }

  /// Bit i of the file of valid points, from the least significant one of each
  /// byte, is 0 if point i is missing. The bits are asked for in their order.
  bool is_valid(std::size_t point) {
    while (point / 8 >= bits_begin_ + bits_.size()) {
      bits_begin_ += bits_.size();
      bits_ = valid_->read(std::size_t{1} << 16);
      if (bits_.empty())
        FileStamp::refuse_changed(file_->name); // is_complete() was true
    }
    const auto byte =
        static_cast<unsigned char>(bits_[point / 8 - bits_begin_]);
    return (byte >> (point % 8) & 1) != 0;
  }

  const X3pFile* file_;
  std::optional<X3pMember> points_;
  std::optional<X3pMember> valid_;
  std::vector<std::string> listed_; ///< if there is no member
  std::size_t next_ = 0;
  std::string bits_; ///< of the valid points, from the byte bits_begin_
  std::size_t bits_begin_ = 0;
};

X3pPoints::X3pPoints(const X3pFile& file) : file_(&file) {}

X3pPoints::~X3pPoints() = default;

Grid X3pPoints::read_all(
    const std::function<void(std::span<const double>)>& take) {
  const X3pHeader& header = file_->header;
  const auto width = static_cast<std::size_t>(header.size_x);
  X3pStream stream(*file_);
  std::vector<X3pPoint> corners(3); // first, end of first row, of first column
  std::vector<double> heights;
  while (stream.is_complete() && stream.next() < file_->count()) {
    std::size_t at = stream.next();
    heights.clear();
    for (const X3pPoint& point : stream.take(file_->count() - at)) {
      if (at == 0)
        corners[0] = point;
      if (at == width - 1)
        corners[1] = point;
      if (at == file_->count() - width)
        corners[2] = point;
      heights.push_back(point.z);
      ++at;
    }
    take(heights);
  }
  stream.finish();
  return grid(corners);
}

Grid X3pPoints::grid(const std::vector<X3pPoint>& corners) const {
  const X3pHeader& header = file_->header;
  Grid grid;
  grid.points_x = static_cast<int>(header.size_x);
  grid.points_y = static_cast<int>(header.size_y);
  const double step_x = (corners[1].x - corners[0].x) / (grid.points_x - 1);
  const double step_y = (corners[2].y - corners[0].y) / (grid.points_y - 1);
  if (header.x.is_absolute || header.y.is_absolute)
    check_positions(step_x, step_y);
  grid.length_x = grid.points_x * (header.x.is_absolute ? std::abs(step_x)
                                                        : header.x.increment);
  grid.length_y = grid.points_y * (header.y.is_absolute ? std::abs(step_y)
                                                        : header.y.increment);
  require_sound_lengths(file_->name, grid);
  return grid;
}

/// The positions of absolute axes must be equidistant within 2 % of their
/// spacing. The first mistake along x is named, else the first along y.
void X3pPoints::check_positions(double step_x, double step_y) const {
  const X3pHeader& header = file_->header;
  const auto width = static_cast<std::size_t>(header.size_x);
  X3pPoint first;
  std::optional<std::size_t> bad_x, bad_y;
  const auto is_bad = [](double found, double regular, double step) {
    return !(std::abs(found - regular) <= 0.02 * std::abs(step));
  };
  X3pStream stream(*file_);
  while (stream.next() < file_->count()) {
    std::size_t at = stream.next();
    for (const X3pPoint& point : stream.take(file_->count() - at)) {
      if (at == 0)
        first = point;
      const std::size_t row = at / width;
      const auto x = static_cast<double>(at % width);
      const auto y = static_cast<double>(row);
      if (header.x.is_absolute && !bad_x &&
          is_bad(point.x, first.x + x * step_x, step_x))
        bad_x = at;
      if (header.y.is_absolute && !bad_y &&
          is_bad(point.y, first.y + y * step_y, step_y))
        bad_y = at;
      ++at;
    }
  }
  if (const auto bad = bad_x ? bad_x : bad_y)
    file_->document.refuse(fmt::format("the absolute positions along {} are "
                                       "not regular at point ({}, {})",
                                       bad_x ? "x" : "y", *bad % width,
                                       *bad / width));
}

std::vector<double> X3pPoints::rows(int first, int count) {
  const auto width = static_cast<std::size_t>(file_->header.size_x);
  const std::size_t begin = static_cast<std::size_t>(first) * width;
  const std::size_t end = begin + static_cast<std::size_t>(count) * width;
  if (!stream_ || stream_->next() > begin)
    stream_ = std::make_unique<X3pStream>(*file_);
  stream_->skip_to(begin);
  std::vector<double> heights;
  heights.reserve(end - begin);
  while (stream_->next() < end)
    for (const X3pPoint& point : stream_->take(end - stream_->next()))
      heights.push_back(point.z);
  return heights;
}

} // namespace asperity::surfaces
