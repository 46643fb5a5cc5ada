#pragma once

// This internal header of surfaces/formats reads the points of an X3P file one
// after the other. If they are a member of the archive, only a piece of it is
// in memory.

#include "base/grid.hpp"
#include "surfaces/formats/x3p_document.hpp"
#include "surfaces/formats/zip_archive.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::surfaces {

/// An archive and what its main.xml says.
struct X3pFile {
  /// @param name  of the file, for messages
  /// @throws input::InputError  there is no main.xml, or it is malformed
  X3pFile(std::unique_ptr<ZipArchive> opened, std::string name);

  std::size_t count() const {
    return static_cast<std::size_t>(header.size_x * header.size_y);
  }

  /// Whether the points are in main.xml itself.
  bool are_points_listed() const;

  /// Compares main.xml with the file of its checksum, if there is one.
  /// @throws input::InputError  they differ
  void check_sum_of_document() const;

  std::string name;
  std::unique_ptr<ZipArchive> archive;
  std::string text; ///< of main.xml
  X3pDocument document;
  X3pHeader header;
};

/// One point; x and y are 0 unless their axes are absolute [m].
struct X3pPoint {
  double x = 0.0, y = 0.0, z = 0.0;
};

class X3pStream;

class X3pPoints {
public:
  /// @param file  outlives this object
  explicit X3pPoints(const X3pFile& file);
  ~X3pPoints();
  X3pPoints(const X3pPoints&) = delete;
  X3pPoints& operator=(const X3pPoints&) = delete;

  /// Reads all points and compares the checksums.
  /// @param take  receives the heights by pieces [m], NaN at points that are
  ///              not valid; what it has received is void if this throws
  /// @throws input::InputError  a member is missing or damaged, has too few
  ///                            bytes or another checksum, or the positions of
  ///                            an absolute axis are not equidistant
  Grid read_all(const std::function<void(std::span<const double>)>& take);

  /// Heights of whole rows, which take less time in their order.
  /// @param first  of a file that read_all() accepts and whose points are not
  ///               listed in main.xml
  /// @throws input::InputError  the member is damaged
  std::vector<double> rows(int first, int count);

private:
  Grid grid(const std::vector<X3pPoint>& corners) const;
  void check_positions(double step_x, double step_y) const;

  const X3pFile* file_;
  std::unique_ptr<X3pStream> stream_; ///< of rows()
};

} // namespace asperity::surfaces
