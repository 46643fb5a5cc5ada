#pragma once

// This internal header of surfaces/formats reads the points of an X3P file one
// after the other. If they are a member of the archive, only a piece of it is
// in memory.

#include "base/grid.hpp"
#include "surfaces/formats/x3p_file.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace asperity::surfaces {

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
