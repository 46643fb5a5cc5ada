// Serialises changes. One description of the layout serves both directions.
#include "results/storage/byte_stream.hpp"
#include "results/storage/change.hpp"
#include "results/types/curve_columns.hpp"

namespace asperity::results {
namespace {

/// Passes the members of every part of a change to a ByteWriter, which stores
/// them, or to a ByteReader, which fills them.
template <class Stream>
class Layout {
public:
  explicit Layout(Stream& stream) : stream_(stream) {}

  void pass(Change& change) {
    pass(change.status);
    pass(change.provenance);
    pass(change.surfaces);
    pass(change.methods);
    pass(change.tables);
    pass(change.skipped);
  }

private:
  void pass(MethodChange& method) {
    stream_.text(method.name);
    stream_.number(method.realization);
    pass(method.kind);
    pass(method.description);
    pass(method.setup_cpu_time);
    pass(method.own_surface);
    pass(method.fields);
    pass(method.points);
  }

  void pass(SurfaceRecord& surface) {
    pass(surface.grid);
    stream_.numbers(surface.heights);
    for (double* number :
         {&surface.rms_height, &surface.rms_slope, &surface.rms_curvature,
          &surface.skewness, &surface.kurtosis, &surface.highest})
      stream_.number(*number);
    pass(surface.spectrum);
  }

  void pass(Grid& grid) {
    stream_.number(grid.points_x);
    stream_.number(grid.points_y);
    stream_.number(grid.length_x);
    stream_.number(grid.length_y);
  }

  void pass(SpectrumPoint& point) {
    stream_.number(point.wavevector);
    stream_.number(point.spectrum);
  }

  void pass(Fields& fields) {
    stream_.number(fields.step);
    stream_.number(fields.nominal_pressure);
    pass(fields.grid);
    stream_.single_numbers(fields.pressure);
    stream_.single_numbers(fields.gap);
  }

  void pass(CurvePoint& point) {
    for (const CurveColumn& column : curve_columns()) {
      double number = column.get(point);
      stream_.number(number);
      column.set(point, number);
    }
    stream_.text(point.note);
  }

  void pass(Table& table) {
    stream_.text(table.name);
    stream_.text(table.title);
    pass(table.columns);
  }

  void pass(Column& column) {
    stream_.text(column.name);
    stream_.text(column.unit);
    stream_.numbers(column.values);
  }

  void pass(Skipped& skipped) {
    stream_.text(skipped.what);
    stream_.text(skipped.why);
    stream_.number(skipped.cpu_time);
    stream_.number(skipped.bytes);
  }

  void pass(std::string& text) { stream_.text(text); }

  void pass(double& number) { stream_.number(number); }

  void pass(int& number) { stream_.number(number); }

  template <class First, class Second>
  void pass(std::pair<First, Second>& both) {
    pass(both.first);
    pass(both.second);
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
    stream_.flag(is_there);
    if (is_there && !value)
      value.emplace();
    if (is_there)
      pass(*value);
  }

  Stream& stream_;
};

} // namespace

std::string bytes_of(Change change) {
  ByteWriter writer;
  Layout(writer).pass(change);
  return writer.take();
}

Change change_in(std::string_view bytes) {
  ByteReader reader(bytes);
  Change change;
  Layout(reader).pass(change);
  if (!reader.is_at_end())
    throw input::InputError("a record of the journal is too long");
  return change;
}

} // namespace asperity::results
