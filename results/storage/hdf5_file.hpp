#pragma once

// The HDF5 C library behind three small classes. Owns every call to it: what
// goes wrong there comes out as one exception that names file and object.

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace asperity::results {

/// "file.h5: /methods/fem: <what>".
struct Hdf5Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The packaged library is not thread safe: hold this while any object below
/// lives.
std::mutex& hdf5_mutex();

/// "1.10.8", of the library that is linked.
std::string hdf5_version();

/// A handle of the library, closed when it goes.
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

  /// Closes now; false if the library could not (a full disk shows here).
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
/// direct children. Every function throws Hdf5Error when the library refuses,
/// and when what it finds breaks a limit of hdf5_limits.hpp.
class Hdf5Group {
public:
  Hdf5Group() = default;

  bool has(const std::string& name) const;
  Hdf5Group open(const std::string& name) const;
  Hdf5Group open_or_create(const std::string& name);

  /// Names in the order of their creation where the file keeps it (ours do),
  /// else by the alphabet.
  std::vector<std::string> children() const;
  std::vector<std::string> attributes() const;

  void remove(const std::string& name);

  bool has_attribute(const std::string& name) const;
  /// Each replaces what was there.
  void set_attribute(const std::string& name, const std::string& text);
  void set_attribute(const std::string& name, double number);
  void set_attribute(const std::string& name, int number);
  /// A number is printed in the fewest digits that give it back.
  std::string text_attribute(const std::string& name) const;
  double number_attribute(const std::string& name) const;

  /// A map of shape.rows * shape.columns values, written once.
  void write_map(const std::string& name, std::span<const double> map,
                 Hdf5Shape shape, Hdf5Number number, const std::string& unit);
  /// Adds to the end of a column, made at the first call.
  void append(const std::string& name, std::span<const double> values,
              Hdf5Number number, const std::string& unit);
  void append(const std::string& name, std::span<const std::string> texts);
  /// Overwrites a column of the same length.
  void overwrite(const std::string& name, std::span<const double> values);

  /// A dataset as the bearer of its attributes.
  Hdf5Group open_dataset(const std::string& name) const;
  std::vector<std::size_t> extents(const std::string& name) const;
  /// All values of a dataset, the last index fastest.
  std::vector<double> numbers(const std::string& name) const;
  /// The values of a dataset, which has to have one dimension.
  std::vector<double> column(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;

  /// "file.h5: /methods/fem/name", for messages.
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

  /// Closes with everything in it; throws where the destructor could not.
  void close();
};

} // namespace asperity::results
