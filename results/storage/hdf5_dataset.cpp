// Implements the datasets of Hdf5Group: maps, extensible columns and texts.
#include "base/plain_text.hpp"
#include "results/storage/hdf5_call.hpp"
#include "results/storage/hdf5_file.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace asperity::results {
namespace {

constexpr hsize_t column_chunk = 128; // rows
constexpr unsigned deflate_level = 4;
constexpr const char* wrong_size =
    "write a map whose size differs from that of its grid";
constexpr hsize_t most_in_chunk = hsize_t{1} << 20; ///< values of a map

hid_t file_type(Hdf5Number number) {
  switch (number) {
  case Hdf5Number::float32_packed:
    return H5T_IEEE_F32LE;
  case Hdf5Number::int32:
    return H5T_STD_I32LE;
  case Hdf5Number::float64:
    break;
  }
  return H5T_IEEE_F64LE;
}

Hdf5Handle dataset_of(hid_t group, const std::string& name,
                      const std::string& place) {
  Hdf5Handle dataset(checked(H5Dopen2(group, name.c_str(), H5P_DEFAULT), place,
                             "find this dataset"),
                     H5Dclose);
  require_own_storage(dataset.id(), place);
  return dataset;
}

void set_unit(hid_t dataset, const std::string& unit,
              const std::string& place) {
  const Hdf5Handle type = text_type();
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(
      checked(H5Acreate2(dataset, "unit", type.id(), space.id(), H5P_DEFAULT,
                         H5P_DEFAULT),
              place, "create the attribute unit"),
      H5Aclose);
  const char* characters = unit.c_str();
  checked(H5Awrite(attribute.id(), type.id(), &characters), place,
          "write the attribute unit");
}

/// Creates an empty extensible column.
Hdf5Handle create_column(hid_t group, const std::string& name, hid_t type,
                         const std::string& place) {
  const hsize_t empty = 0;
  const hsize_t unlimited = H5S_UNLIMITED;
  const Hdf5Handle space(H5Screate_simple(1, &empty, &unlimited), H5Sclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false); // equal data, equal bytes
  H5Pset_chunk(creation.id(), 1, &column_chunk);
  return {checked(H5Dcreate2(group, name.c_str(), type, space.id(), H5P_DEFAULT,
                             creation.id(), H5P_DEFAULT),
                  place, "create this dataset"),
          H5Dclose};
}

/// Appends `count` values of `memory_type` to a column.
void append_to(hid_t dataset, hid_t memory_type, hsize_t count,
               const void* values, const std::string& place) {
  hsize_t old_length = 0;
  {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    H5Sget_simple_extent_dims(space.id(), &old_length, nullptr);
  }
  const hsize_t new_length = old_length + count;
  checked(H5Dset_extent(dataset, &new_length), place, "extend this dataset");
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  checked(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &old_length, nullptr,
                              &count, nullptr),
          place, "select rows");
  const Hdf5Handle memory_space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  checked(H5Dwrite(dataset, memory_type, memory_space.id(), space.id(),
                   H5P_DEFAULT, values),
          place, "write this dataset");
}

/// Writes the values of a map in order, as many rows at a time as a chunk has.
class RowWriter {
public:
  RowWriter(hid_t dataset, const std::array<hsize_t, 2>& extents,
            hsize_t rows_at_a_time, std::string place)
      : dataset_(dataset),
        extents_(extents),
        rows_at_a_time_(rows_at_a_time),
        place_(std::move(place)) {
    kept_.reserve(rows_at_a_time * extents[1]);
  }

  void take(std::span<const double> values) {
    const std::size_t whole = rows_at_a_time_ * extents_[1];
    while (!values.empty()) {
      const std::size_t n = std::min(whole - kept_.size(), values.size());
      if (n == whole) { // without a copy
        write(values.first(n));
      } else {
        kept_.insert(kept_.end(), values.begin(),
                     values.begin() + static_cast<std::ptrdiff_t>(n));
        if (kept_.size() == whole) {
          write(kept_);
          kept_.clear();
        }
      }
      values = values.subspan(n);
    }
  }

  void finish() {
    if (!kept_.empty())
      write(kept_);
    if (rows_ != extents_[0] || rows_ == 0)
      refuse();
  }

private:
  void write(std::span<const double> values) {
    const std::array<hsize_t, 2> count{values.size() / extents_[1],
                                       extents_[1]};
    if (values.size() % extents_[1] != 0 || rows_ + count[0] > extents_[0])
      refuse();
    const std::array<hsize_t, 2> start{rows_, 0};
    const Hdf5Handle space(H5Dget_space(dataset_), H5Sclose);
    checked(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(),
                                nullptr, count.data(), nullptr),
            place_, "select rows");
    const Hdf5Handle memory(H5Screate_simple(2, count.data(), nullptr),
                            H5Sclose);
    checked(H5Dwrite(dataset_, H5T_NATIVE_DOUBLE, memory.id(), space.id(),
                     H5P_DEFAULT, values.data()),
            place_, "write this dataset");
    rows_ += count[0];
  }

  [[noreturn]] void refuse() const { refuse_hdf5(place_, wrong_size); }

  hid_t dataset_;
  std::array<hsize_t, 2> extents_;
  hsize_t rows_at_a_time_;
  std::string place_;
  hsize_t rows_ = 0; ///< that are written
  std::vector<double> kept_;
};

} // namespace

void Hdf5Group::write_map(const std::string& name, std::span<const double> map,
                          Hdf5Shape shape, Hdf5Number number,
                          const std::string& unit) {
  if (map.size() != shape.rows * shape.columns || map.empty())
    refuse_hdf5(place(name), wrong_size);
  write_map(name, rows_of_map(map), shape, number, unit);
}

void Hdf5Group::write_map(const std::string& name, const MapRows& rows,
                          Hdf5Shape shape, Hdf5Number number,
                          const std::string& unit) {
  const std::array<hsize_t, 2> extents{shape.rows, shape.columns};
  const std::array<hsize_t, 2> chunk{
      std::clamp<hsize_t>(most_in_chunk / std::max(hsize_t{1}, extents[1]), 1,
                          std::max(hsize_t{1}, extents[0])),
      extents[1]};
  const Hdf5Handle space(H5Screate_simple(2, extents.data(), nullptr),
                         H5Sclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false); // equal data, equal bytes
  if (number == Hdf5Number::float32_packed) {
    H5Pset_chunk(creation.id(), 2, chunk.data());
    H5Pset_shuffle(creation.id());
    H5Pset_deflate(creation.id(), deflate_level);
  }
  const Hdf5Handle dataset(
      checked(H5Dcreate2(handle_.id(), name.c_str(), file_type(number),
                         space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
              place(name), "create this dataset"),
      H5Dclose);
  set_unit(dataset.id(), unit, place(name));
  RowWriter writer(dataset.id(), extents, chunk[0], place(name));
  rows([&](std::span<const double> values) { writer.take(values); });
  writer.finish();
}

void Hdf5Group::append(const std::string& name, std::span<const double> values,
                       Hdf5Number number, const std::string& unit) {
  const bool is_new = !has(name);
  const Hdf5Handle dataset =
      is_new ? create_column(handle_.id(), name, file_type(number), place(name))
             : dataset_of(handle_.id(), name, place(name));
  if (is_new)
    set_unit(dataset.id(), unit, place(name));
  append_to(dataset.id(), H5T_NATIVE_DOUBLE, values.size(), values.data(),
            place(name));
}

void Hdf5Group::append(const std::string& name,
                       std::span<const std::string> texts) {
  std::vector<std::string> plain; // no other text is read
  std::vector<const char*> characters;
  std::ranges::transform(texts, std::back_inserter(plain), plain_text);
  std::ranges::transform(plain, std::back_inserter(characters),
                         [](const std::string& text) { return text.c_str(); });
  const Hdf5Handle type = text_type();
  const Hdf5Handle dataset =
      has(name) ? dataset_of(handle_.id(), name, place(name))
                : create_column(handle_.id(), name, type.id(), place(name));
  append_to(dataset.id(), type.id(), characters.size(), characters.data(),
            place(name));
}

void Hdf5Group::overwrite(const std::string& name,
                          std::span<const double> values) {
  const Hdf5Handle dataset = dataset_of(handle_.id(), name, place(name));
  if (extents(name) != std::vector<std::size_t>{values.size()})
    refuse_hdf5(place(name), "overwrite a column of a different length");
  checked(H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL,
                   H5P_DEFAULT, values.data()),
          place(name), "write this dataset");
}

Hdf5Group Hdf5Group::open_dataset(const std::string& name) const {
  return {dataset_of(handle_.id(), name, place(name)), place(name)};
}

std::vector<std::size_t> Hdf5Group::extents(const std::string& name) const {
  const Hdf5Handle dataset = dataset_of(handle_.id(), name, place(name));
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(rank, 0)));
  H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr);
  return {extents.begin(), extents.end()};
}

std::vector<double> Hdf5Group::numbers(const std::string& name) const {
  const Hdf5Handle dataset = dataset_of(handle_.id(), name, place(name));
  require_stored_values(dataset.id(), place(name));
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::vector<double> values(
      element_count(space.id(), sizeof(double), place(name)));
  checked(H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL,
                  H5P_DEFAULT, values.data()),
          place(name), "read this dataset as numbers");
  return values;
}

std::vector<double> Hdf5Group::rows(const std::string& name, std::size_t first,
                                    std::size_t count) const {
  const std::vector<std::size_t> size = extents(name);
  if (size.size() != 2 || first > size[0] || count > size[0] - first)
    refuse_hdf5(place(name), "read these rows of this dataset");
  const Hdf5Handle dataset = dataset_of(handle_.id(), name, place(name));
  require_stored_values(dataset.id(), place(name));
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const std::array<hsize_t, 2> start{first, 0};
  const std::array<hsize_t, 2> counts{count, size[1]};
  checked(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr,
                              counts.data(), nullptr),
          place(name), "select rows");
  const Hdf5Handle memory(H5Screate_simple(2, counts.data(), nullptr),
                          H5Sclose);
  element_count(memory.id(), sizeof(double), place(name));
  std::vector<double> values(count * size[1]);
  checked(H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(),
                  H5P_DEFAULT, values.data()),
          place(name), "read this dataset as numbers");
  return values;
}

std::vector<double> Hdf5Group::column(const std::string& name) const {
  common_length({&name, 1});
  return numbers(name);
}

std::size_t Hdf5Group::common_length(std::span<const std::string> names) const {
  std::size_t length = 0;
  for (const std::string& name : names) {
    const std::vector<std::size_t> found = extents(name);
    if (found.size() != 1)
      throw Hdf5Error(fmt::format(
          "{}: has {} dimensions, but must have one: it is a column",
          place(name), found.size()));
    if (&name == names.data())
      length = found.front();
    if (found.front() != length)
      throw Hdf5Error(fmt::format("{} has {} values, but must have {}, as {}",
                                  place(name), found.front(), length,
                                  names.front()));
  }
  return length;
}

void Hdf5Group::require_stored(const std::string& name) const {
  const Hdf5Handle dataset = dataset_of(handle_.id(), name, place(name));
  require_stored_values(dataset.id(), place(name));
}

std::size_t Hdf5Group::value_bytes(const std::string& name) const {
  const Hdf5Handle dataset = dataset_of(handle_.id(), name, place(name));
  const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
  return H5Tget_size(type.id());
}

std::vector<std::string> Hdf5Group::texts(const std::string& name) const {
  const Hdf5Handle dataset = dataset_of(handle_.id(), name, place(name));
  const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (H5Tget_class(type.id()) != H5T_STRING)
    refuse_hdf5(place(name), "read this dataset as text");
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const bool is_variable = H5Tis_variable_str(type.id()) > 0;
  hsize_t bytes = 0;
  if (is_variable && H5Sget_simple_extent_npoints(space.id()) <=
                         static_cast<hssize_t>(most_texts))
    checked(H5Dvlen_get_buf_size(dataset.id(), type.id(), space.id(), &bytes),
            place(name), "determine the size of this dataset");
  if (bytes > largest_text)
    throw Hdf5Error(
        fmt::format("{}: has {} bytes of text, but must have at most {}",
                    place(name), bytes, largest_text));
  return read_texts(type.id(), space.id(), place(name),
                    [&](hid_t memory, void* buffer) {
                      checked(H5Dread(dataset.id(), memory, H5S_ALL, H5S_ALL,
                                      H5P_DEFAULT, buffer),
                              place(name), "read this dataset");
                    });
}

} // namespace asperity::results
