#include "results/observables/area_estimate.hpp"

#include "base/require.hpp"
#include "results/types/map_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace asperity::results {
namespace {

/// Sums of (A.3) and (A.5) over the pairs of neighbours of which one is in
/// contact.
struct BoundaryPairs {
  double excess = 0.0; ///< sum of t - 1/2
  std::size_t pairs = 0;
};

class Contact {
public:
  /// @param rows  of which this process holds the map; null: all
  Contact(const Grid& grid, std::span<const double> pressure, Border border,
          const SharedRows* rows = nullptr)
      : grid_(grid),
        pressure_(pressure),
        border_(border),
        rows_(rows),
        n_rows_(rows != nullptr ? rows->count() : grid.points_y) {
    require_size("pressure", pressure.size(),
                 rows != nullptr ? rows->size() : grid.size());
    if (rows != nullptr)
      pressure_after_ = rows->row_after(pressure);
  }

  bool holds(std::size_t node) const {
    return node != beyond && value(pressure_, pressure_after_, node) > 0.0;
  }

  /// Number of nodes in contact, on all ranks.
  std::size_t n_nodes() const {
    return sum_of_ranks(rows_, static_cast<std::size_t>(std::count_if(
                                   pressure_.begin(), pressure_.end(),
                                   [](double p) { return p > 0.0; })));
  }

  /// n_1 - n_3 of (A.4).
  long twists() const {
    long own = 0;
    for_each_square([&](std::size_t node, std::size_t right, std::size_t above,
                        std::size_t across) {
      const int in_contact =
          holds(node) + holds(right) + holds(above) + holds(across);
      own += (in_contact == 1) - (in_contact == 3);
    });
    return sum_of_ranks(rows_, own);
  }

  /// Calls visit(node, right, above, across) with the corners of every square
  /// of neighbours. Squares cross the border, beyond which a node is `beyond`
  /// unless the map is periodic.
  template <class Visit>
  void for_each_square(Visit visit) const {
    const int first = border_ == Border::periodic ? 0 : -1;
    for (int iy = first; iy < n_rows_; ++iy)
      for (int ix = first; ix < grid_.points_x; ++ix)
        visit(at(ix, iy), at(ix + 1, iy), at(ix, iy + 1), at(ix + 1, iy + 1));
  }

  BoundaryPairs boundary(std::span<const double> gap,
                         double contact_modulus) const {
    const std::vector<double> gap_after =
        rows_ != nullptr ? rows_->row_after(gap) : std::vector<double>();
    return in_order(rows_, BoundaryPairs{}, [&](BoundaryPairs& boundary) {
      const auto add = [&](std::size_t a, std::size_t b, double spacing) {
        if (holds(a) == holds(b) || a == beyond || b == beyond)
          return;
        const std::size_t inside = holds(a) ? a : b;
        const std::size_t outside = holds(a) ? b : a;
        boundary.excess +=
            boundary_share(value(pressure_, pressure_after_, inside),
                           value(gap, gap_after, outside), spacing,
                           contact_modulus) -
            0.5;
        ++boundary.pairs;
      };
      for_each_square([&](std::size_t node, std::size_t right,
                          std::size_t above, std::size_t) {
        add(node, right, grid_.spacing_x());
        add(node, above, grid_.spacing_y());
      });
    });
  }

private:
  static constexpr std::size_t beyond = static_cast<std::size_t>(-1);

  /// The node at these indices, from -1 to the number of points. The nodes of
  /// the row after those of this process follow its own.
  std::size_t at(int ix, int iy) const {
    const bool is_inside =
        ix >= 0 && iy >= 0 && ix < grid_.points_x && iy < grid_.points_y;
    if (!is_inside && border_ == Border::free)
      return beyond;
    return grid_.index(ix == grid_.points_x ? 0 : ix,
                       iy == grid_.points_y && rows_ == nullptr ? 0 : iy);
  }

  static double value(std::span<const double> own,
                      std::span<const double> after, std::size_t node) {
    return node < own.size() ? own[node] : after[node - own.size()];
  }

  const Grid& grid_;
  std::span<const double> pressure_;
  Border border_;
  const SharedRows* rows_;
  int n_rows_;                         ///< of this process
  std::vector<double> pressure_after_; ///< of the row after them
};

/// Returns A_l/A_0 of (A.3), which may be slightly outside 0..1.
double line_share(const Contact& contact, const BoundaryPairs& boundary,
                  double n) {
  return (static_cast<double>(contact.n_nodes()) + 0.5 * boundary.excess) / n;
}

} // namespace

double boundary_share(double pressure_inside, double gap_outside,
                      double spacing, double contact_modulus) {
  require_positive("pressure_inside", pressure_inside, "Pa");
  require_positive("spacing", spacing, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
  if (!std::isfinite(gap_outside))
    refuse_argument("gap_outside", gap_outside, "finite");
  if (gap_outside <= 0.0)
    return 1.0;
  const double root = 0.75 * contact_modulus * gap_outside /
                      (pressure_inside * spacing); // rho^(1/2)
  // The root s = 1 - t of s^3 + rho s = rho is given by Cardano's formula in
  // hyperbolic form.
  const double scale = root / std::sqrt(3.0);
  const double outside = 2.0 * scale * std::sinh(std::asinh(1.5 / scale) / 3.0);
  if (!std::isfinite(outside)) // overflow or underflow of rho
    return scale > 1.0 ? 0.0 : 1.0;
  return std::clamp(1.0 - outside, 0.0, 1.0); // (A.2)
}

double line_area_fraction(const Grid& grid, std::span<const double> pressure,
                          std::span<const double> gap, double contact_modulus,
                          Border border) {
  const Contact contact(grid, pressure, border);
  require_size("gap", gap.size(), grid.size());
  const double share =
      line_share(contact, contact.boundary(gap, contact_modulus),
                 static_cast<double>(grid.size()));
  return std::clamp(share, 0.0, 1.0);
}

double euler_characteristic(const Grid& grid, std::span<const double> pressure,
                            Border border) {
  return 0.25 *
         static_cast<double>(Contact(grid, pressure, border).twists()); // (A.4)
}

AreaCoefficients q1_area_coefficients(double surface_cell_depth) {
  require_positive("surface_cell_depth", surface_cell_depth, "spacings");
  constexpr std::array depths{0.5, 1.0, 1.5};
  constexpr std::array<AreaCoefficients, 3> measured{
      {{0.142, 0.60}, {0.109, 0.37}, {0.067, 0.035}}};
  const double depth =
      std::clamp(surface_cell_depth, depths.front(), depths.back());
  const std::size_t i = depth < depths[1] ? 0 : 1;
  const double share = (depth - depths[i]) / (depths[i + 1] - depths[i]);
  return {std::lerp(measured[i].perimeter, measured[i + 1].perimeter, share),
          std::lerp(measured[i].euler, measured[i + 1].euler, share)};
}

namespace {

Observed corrected_area(const Contact& contact, std::span<const double> gap,
                        double contact_modulus,
                        const AreaCoefficients& coefficients, double n) {
  const BoundaryPairs boundary = contact.boundary(gap, contact_modulus);
  const double euler = 0.25 * static_cast<double>(contact.twists()); // (A.4)
  const double share =
      line_share(contact, boundary, n) -
      coefficients.perimeter * static_cast<double>(boundary.pairs) / n +
      coefficients.euler * euler / n;
  const double counted = static_cast<double>(contact.n_nodes()) / n;
  if (share < least_corrected_share * counted)
    return {Observed::none,
            fmt::format(
                "the contact patches are too small for this grid: the estimate "
                "is only {:.2g} of the counted area, but must be at least {}",
                share / counted, least_corrected_share)};
  return std::min(share, 1.0); // (A.5)
}

} // namespace

Observed
corrected_area_fraction(const Grid& grid, std::span<const double> pressure,
                        std::span<const double> gap, double contact_modulus,
                        const AreaCoefficients& coefficients, Border border) {
  require_size("gap", gap.size(), grid.size());
  return corrected_area(Contact(grid, pressure, border), gap, contact_modulus,
                        coefficients, static_cast<double>(grid.size()));
}

Observed corrected_area_fraction(const SharedRows& rows,
                                 std::span<const double> pressure,
                                 std::span<const double> gap,
                                 double contact_modulus,
                                 const AreaCoefficients& coefficients) {
  require_size("gap", gap.size(), rows.size());
  return corrected_area(Contact(rows.grid(), pressure, Border::periodic, &rows),
                        gap, contact_modulus, coefficients,
                        static_cast<double>(rows.grid().size()));
}

} // namespace asperity::results
