#pragma once

// Wraps the HDF5 C library in three small classes. All calls to the library are
// made behind them, and each error is reported as an exception that names the
// file and the object.

#include "results/types/map_rows.hpp"

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::results {

/// An error "file.h5: /methods/fem: <what>".
struct Hdf5Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns a mutex that must be held while any object of the classes below
/// exists, because the packaged library is not thread-safe. The thread that
/// holds it may lock it again, to read one file while it writes another.
std::recursive_mutex& hdf5_mutex();

/// Returns the version of the linked library, e.g. "1.10.8".
std::string hdf5_version();

/// A handle of the library that is closed in the destructor.
class Hdf5Handle {
public:
  using Close = int (*)(std::int64_t);

  Hdf5Handle() = default;

  Hdf5Handle(std::int64_t id, Close close) : id_(id), close_(close) {}

  ~Hdf5Handle() { reset(); }

  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }

  std::int64_t id() const { return id_; }

  /// Closes the handle; returns false if the library failed to, e.g. because
  /// the disk is full.
  bool reset() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

private:
  std::int64_t id_ = -1;
  Close close_ = nullptr;
};

/// Rows and columns of a map: points_y, points_x.
struct Hdf5Shape {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

enum class Hdf5Number { float64, float32_packed, int32 };

/// A group of a file with its attributes and datasets. Names are those of
/// direct children. Every function throws Hdf5Error if the library reports an
/// error or if the contents exceed a limit of hdf5_limits.hpp.
class Hdf5Group {
public:
  Hdf5Group() = default;

  bool has(const std::string& name) const;
  /// Returns whether the name is that of a group or of a dataset, without an
  /// error if it is neither or if its link cannot be followed.
  bool is_group(const std::string& name) const;
  bool is_dataset(const std::string& name) const;
  Hdf5Group open(const std::string& name) const;
  /// Opens the group of this path "/methods/fem/0", one part after the other,
  /// without links to other files.
  /// @param path  below this group
  Hdf5Group open_path(std::string_view path) const;
  /// Returns the path of this group in its file.
  std::string path() const;
  Hdf5Group open_or_create(const std::string& name);

  /// Returns the names in the order of creation if the file records it, as ours
  /// do, and in alphabetical order otherwise.
  std::vector<std::string> children() const;
  std::vector<std::string> attributes() const;

  void remove(const std::string& name);

  bool has_attribute(const std::string& name) const;
  /// Each of these functions replaces an existing attribute.
  void set_attribute(const std::string& name, const std::string& text);
  void set_attribute(const std::string& name, double number);
  void set_attribute(const std::string& name, int number);
  /// Returns a text; a number is converted with the fewest digits that
  /// reproduce it.
  std::string text_attribute(const std::string& name) const;
  double number_attribute(const std::string& name) const;

  /// Writes a new map of shape.rows * shape.columns values.
  void write_map(const std::string& name, std::span<const double> map,
                 Hdf5Shape shape, Hdf5Number number, const std::string& unit);
  /// The same from a map that is passed on by rows. Packed maps are
  /// stored in chunks of whole rows, of at most 2^20 values; no more than these
  /// are in memory besides what `rows` passes on.
  void write_map(const std::string& name, const MapRows& rows, Hdf5Shape shape,
                 Hdf5Number number, const std::string& unit);
  /// Appends to a column, which the first call creates.
  void append(const std::string& name, std::span<const double> values,
              Hdf5Number number, const std::string& unit);
  void append(const std::string& name, std::span<const std::string> texts);
  /// Overwrites a column of the same length.
  void overwrite(const std::string& name, std::span<const double> values);

  /// Opens a dataset for access to its attributes.
  Hdf5Group open_dataset(const std::string& name) const;
  std::vector<std::size_t> extents(const std::string& name) const;
  /// Returns all values of a dataset, with the last index fastest.
  std::vector<double> numbers(const std::string& name) const;
  /// Returns some rows of a dataset with two dimensions.
  /// @throws Hdf5Error  also if the dataset has no such rows
  std::vector<double> rows(const std::string& name, std::size_t first,
                           std::size_t count) const;
  /// Returns the values of a one-dimensional dataset.
  std::vector<double> column(const std::string& name) const;
  /// Compares the lengths of one-dimensional datasets before any of them is
  /// read.
  /// @return  the length that all of them have; 0 if there is none
  /// @throws Hdf5Error  naming the first that differs from the first of all
  std::size_t common_length(std::span<const std::string> names) const;
  /// Requires that the file stores as many bytes as the values of a dataset
  /// must have at least, so that few bytes do not become gigabytes.
  void require_stored(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;
  /// Returns the size of one value of a dataset [B].
  std::size_t value_bytes(const std::string& name) const;

  /// Returns "file.h5: /methods/fem/name" for messages.
  std::string place(const std::string& name = "") const;

protected:
  Hdf5Group(Hdf5Handle handle, std::string place)
      : handle_(std::move(handle)), place_(std::move(place)) {}

  Hdf5Handle handle_;
  std::string place_;
};

/// An open file and its root group.
class Hdf5File : public Hdf5Group {
public:
  enum class Mode { create, read_write, read };

  Hdf5File(const std::filesystem::path& path, Mode mode);

  /// Closes the file and all its objects. Unlike the destructor, it reports
  /// errors by an exception.
  void close();
};

} // namespace asperity::results
