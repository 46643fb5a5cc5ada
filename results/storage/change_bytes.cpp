// Serialises changes, with numbers in the byte order of the machine. One
// description of the layout serves both directions.
#include "input/input_error.hpp"
#include "results/storage/change.hpp"
#include "results/types/curve_columns.hpp"
#include "results/types/map_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

namespace asperity::results {
namespace {

/// The writer and the reader have the same functions.
class ByteWriter {
public:
  /// @param take  receives the bytes by pieces; null: they are only counted,
  ///              and no map is asked for
  explicit ByteWriter(TakeBytes take) : take_(std::move(take)) {}

  void number(const double& value) { raw(&value, sizeof value); }

  void number(const int& value) { number(static_cast<double>(value)); }

  void flag(const bool& value) { number(value ? 1 : 0); }

  void count(const std::size_t& value) {
    const std::uint64_t number = value;
    raw(&number, sizeof number);
  }

  void text(const std::string& value) {
    count(value.size());
    raw(value.data(), value.size());
  }

  void numbers(const std::vector<double>& values) {
    count(values.size());
    raw(values.data(), values.size() * sizeof(double));
  }

  template <class Number>
  void map(const ChangeMap& map, const Grid& grid) {
    const std::size_t size = map.rows ? grid.size() : 0;
    count(size);
    if (size > 0 && take_)
      require_size("map", pass<Number>(map.rows), size);
    else
      size_ += size * sizeof(Number);
  }

  /// Passes on the last bytes.
  /// @return  the number of all bytes
  std::uintmax_t finish() {
    if (take_ && !bytes_.empty())
      take_(bytes_);
    bytes_.clear();
    return size_;
  }

private:
  template <class Number>
  std::size_t pass(const MapRows& rows) {
    constexpr std::size_t piece = piece_bytes / sizeof(Number);
    std::size_t passed = 0;
    rows([&](std::span<const double> values) {
      passed += values.size();
      for (std::size_t at = 0; at < values.size(); at += piece) {
        const auto some =
            values.subspan(at, std::min(piece, values.size() - at));
        const std::vector<Number> numbers(some.begin(), some.end());
        raw(numbers.data(), numbers.size() * sizeof(Number));
      }
    });
    return passed;
  }

  void raw(const void* data, std::size_t size) {
    size_ += size;
    if (!take_)
      return;
    bytes_.append(static_cast<const char*>(data), size);
    if (bytes_.size() >= piece_bytes)
      finish();
  }

  TakeBytes take_;
  std::string bytes_; ///< that are not passed on yet
  std::uintmax_t size_ = 0;
};

/// A map at a place of a record.
template <class Number>
StoredMap map_in(const FileBytes& record, std::uintmax_t place,
                 const Grid& grid) {
  const auto columns = static_cast<std::size_t>(grid.points_x);
  return {static_cast<std::size_t>(grid.points_y), columns,
          [record, place, columns](std::size_t first, std::size_t count) {
            std::vector<Number> numbers(count * columns);
            record.read(place + first * columns * sizeof(Number),
                        {reinterpret_cast<char*>(numbers.data()),
                         numbers.size() * sizeof(Number)});
            return std::vector<double>(numbers.begin(), numbers.end());
          }};
}

/// Every function throws input::InputError if the data end too early.
class ByteReader {
public:
  explicit ByteReader(const FileBytes& record) : record_(record) {}

  void number(double& value) { raw(&value, sizeof value); }

  void number(int& value) {
    double read = 0.0;
    number(read);
    if (!(read >= -1e9 && read <= 1e9))
      refuse();
    value = static_cast<int>(read);
  }

  void flag(bool& value) {
    int read = 0;
    number(read);
    value = read != 0;
  }

  void count(std::size_t& value) { value = size_of_items(1); }

  void text(std::string& value) {
    value.resize(size_of_items(1));
    raw(value.data(), value.size());
  }

  void numbers(std::vector<double>& values) {
    values.resize(size_of_items(sizeof(double)));
    raw(values.data(), values.size() * sizeof(double));
  }

  template <class Number>
  void map(ChangeMap& map, const Grid& grid) {
    const std::size_t size = size_of_items(sizeof(Number));
    if (size == 0)
      return;
    if (grid.points_x <= 0 || grid.points_y <= 0 || size != grid.size())
      refuse();
    map.stored = map_in<Number>(record_, place_, grid);
    map.rows = [stored = map.stored](const TakeValues& take) {
      each_piece(MapView(stored), take);
    };
    place_ += size * sizeof(Number);
    bytes_.clear();
    used_ = 0;
  }

  bool is_at_end() const { return place_ == record_.size(); }

private:
  [[noreturn]] static void refuse() {
    throw input::InputError("a record of the journal has an unknown layout");
  }

  std::size_t size_of_items(std::size_t bytes_each) {
    std::uint64_t size = 0;
    raw(&size, sizeof size);
    if (size > (record_.size() - place_) / bytes_each)
      refuse();
    return size;
  }

  void raw(void* data, std::size_t size) {
    if (size > record_.size() - place_)
      refuse();
    if (size > bytes_.size() - used_) {
      constexpr std::size_t at_a_time = 4096;
      bytes_.resize(std::min<std::uintmax_t>(record_.size() - place_,
                                             std::max(size, at_a_time)));
      record_.read(place_, bytes_);
      used_ = 0;
    }
    if (size > 0)
      std::memcpy(data, bytes_.data() + used_, size);
    used_ += size;
    place_ += size;
  }

  FileBytes record_;
  std::uintmax_t place_ = 0; ///< of the next byte
  std::string bytes_;        ///< that have been read
  std::size_t used_ = 0;     ///< number of them that have been passed on
};

/// Passes the members of every part of a change to a ByteWriter, which stores
/// them, or to a ByteReader, which fills them.
template <class Stream>
class Layout {
public:
  explicit Layout(Stream& stream) : stream_(stream) {}

  void pass(Change& change) {
    all(change.status, change.provenance, change.surfaces, change.methods,
        change.tables, change.skipped);
  }

private:
  template <class... Parts>
  void all(Parts&... parts) {
    (pass(parts), ...);
  }

  void pass(MethodChange& method) {
    all(method.name, method.realization, method.kind, method.description,
        method.contact, method.setup_cpu_time, method.own_surface,
        method.fields, method.points);
  }

  void pass(SurfaceChange& change) {
    SurfaceRecord& surface = change.record;
    all(surface.grid, surface.map);
    stream_.template map<double>(change.heights, surface.grid);
    all(surface.rms_height, surface.rms_slope, surface.rms_curvature,
        surface.skewness, surface.kurtosis, surface.highest, surface.spectrum);
  }

  void pass(Grid& grid) {
    all(grid.points_x, grid.points_y, grid.length_x, grid.length_y);
  }

  void pass(MapInCell& map) { all(map.columns, map.rows); }

  void pass(SpectrumPoint& point) { all(point.wavevector, point.spectrum); }

  void pass(FieldsChange& fields) {
    all(fields.step, fields.nominal_pressure, fields.grid, fields.map,
        fields.has_double_maps);
    for (ChangeMap* const map : {&fields.pressure, &fields.gap})
      if (fields.has_double_maps)
        stream_.template map<double>(*map, fields.grid);
      else
        stream_.template map<float>(*map, fields.grid);
  }

  /// A row is the names of its columns with their numbers.
  void pass(CurvePoint& point) {
    std::vector<std::pair<std::string, double>> numbers;
    for (const CurveColumn& column : curve_columns())
      if (const double number = column.get(point);
          !std::isnan(number) || !std::isnan(column.blank()))
        numbers.emplace_back(column.name, number);
    pass(numbers);
    for (const CurveColumn& column : curve_columns())
      column.set(point, column.blank());
    for (const auto& [name, number] : numbers)
      if (const CurveColumn* const column = find_curve_column(name))
        column->set(point, number);
    stream_.text(point.note);
  }

  void pass(Table& table) { all(table.name, table.title, table.columns); }

  void pass(Column& column) { all(column.name, column.unit, column.values); }

  void pass(Skipped& skipped) { all(skipped.what, skipped.why); }

  void pass(std::string& text) { stream_.text(text); }

  void pass(double& number) { stream_.number(number); }

  void pass(int& number) { stream_.number(number); }

  void pass(bool& flag) { stream_.flag(flag); }

  void pass(std::vector<double>& numbers) { stream_.numbers(numbers); }

  template <class First, class Second>
  void pass(std::pair<First, Second>& both) {
    all(both.first, both.second);
  }

  template <class Item>
  void pass(std::vector<Item>& items) {
    std::size_t size = items.size();
    stream_.count(size);
    items.resize(size);
    for (Item& item : items)
      pass(item);
  }

  template <class Value>
  void pass(std::optional<Value>& value) {
    bool is_there = value.has_value();
    pass(is_there);
    if (is_there && !value)
      value.emplace();
    if (is_there)
      pass(*value);
  }

  Stream& stream_;
};

} // namespace

Record record_of(Change change) {
  const auto pass = [kept = std::make_shared<Change>(std::move(change))](
                        const TakeBytes& take) {
    ByteWriter writer(take);
    Layout(writer).pass(*kept);
    return writer.finish();
  };
  return {pass(nullptr), pass};
}

Change change_in(const FileBytes& record) {
  ByteReader reader(record);
  Change change;
  Layout(reader).pass(change);
  if (!reader.is_at_end())
    throw input::InputError("a record of the journal is too long");
  return change;
}

} // namespace asperity::results
