#include "fem/adaptive/contact_marks.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem {
ContactMarks::ContactMarks(const SurfaceFields& fields)
    : fields_(fields),
      cells_{fields.grid.points_x / fields.degree,
             fields.grid.points_y / fields.degree, fields.grid.length_x,
             fields.grid.length_y},
      marked_(cells_.size(), 0) {}

/// Whether the finest cell (ix, iy) is to be marked.
bool ContactMarks::is_troubled(int ix, int iy, double tolerance) const {
  bool has_contact = false;
  bool is_partly_free = false;
  for (int j = 0; j <= fields_.degree; ++j)
    for (int i = 0; i <= fields_.degree; ++i) {
      const std::size_t node = fields_.grid.periodic_index(
          ix * fields_.degree + i, iy * fields_.degree + j);
      const double gap = fields_.gap[node];
      const bool is_pressed = fields_.pressure[node] > 0.0;
      if (is_pressed ? std::abs(gap) > tolerance : gap < 0.0)
        return true;
      (is_pressed ? has_contact : is_partly_free) = true;
    }
  return has_contact && is_partly_free;
}

void ContactMarks::examine(const CellRange& face) {
  const double edge = (face.last_x - face.first_x) * cells_.spacing_x();
  const double tolerance =
      std::min(fields_.gap_tolerance,
               fields_.pressure_tolerance * edge / fields_.modulus);
  for (int iy = face.first_y; iy < face.last_y; ++iy)
    for (int ix = face.first_x; ix < face.last_x; ++ix)
      if (is_troubled(ix, iy, tolerance))
        marked_[cells_.periodic_index(ix, iy)] = 1;
}

bool ContactMarks::is_marked_near(const CellRange& range) const {
  for (int iy = range.first_y - 1; iy <= range.last_y; ++iy)
    for (int ix = range.first_x - 1; ix <= range.last_x; ++ix)
      if (marked_[cells_.periodic_index(ix, iy)] != 0)
        return true;
  return false;
}

bool ContactMarks::is_touched(const CellRange& range) const {
  const int degree = fields_.degree;
  for (int iy = range.first_y * degree; iy <= range.last_y * degree; ++iy)
    for (int ix = range.first_x * degree; ix <= range.last_x * degree; ++ix) {
      const std::size_t node = fields_.grid.periodic_index(ix, iy);
      if (fields_.pressure[node] > 0.0 || fields_.gap[node] <= 0.0)
        return true;
    }
  return false;
}

} // namespace asperity::fem
