#include "results/observables/area_estimate.hpp"

#include "base/ranks/chunked_sum.hpp"
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

/// Sums of (A.3) to (A.5) over the nodes in contact, the pairs of neighbours of
/// which one is in contact, and the squares of neighbours.
struct ContactSums {
  double excess = 0.0; ///< of t - 1/2
  std::size_t nodes = 0, pairs = 0;
  long twists = 0; ///< n_1 - n_3 of (A.4)
  /// Pressure and gap of the first pair for which t is not defined.
  double refused_pressure = 0.0, refused_gap = 0.0;
  bool is_refused = false;

  ContactSums& operator+=(const ContactSums& other) {
    excess += other.excess;
    nodes += other.nodes;
    pairs += other.pairs;
    twists += other.twists;
    if (!is_refused && other.is_refused) {
      refused_pressure = other.refused_pressure;
      refused_gap = other.refused_gap;
      is_refused = true;
    }
    return *this;
  }
};

/// Whether a node of hard contact is in contact.
bool under_pressure(double pressure) {
  return mechanics::ContactCriterion{}.holds(pressure);
}

/// What n_1 - n_3 counts of a square with so many nodes in contact.
long twist(int in_contact) {
  return (in_contact == 1) - (in_contact == 3);
}

/// The nodes in contact of a map.
class Contact {
public:
  Contact(const Grid& grid, std::span<const double> pressure, Border border,
          int threads)
      : grid_(grid),
        width_(static_cast<std::size_t>(grid.points_x)),
        pressure_(pressure),
        border_(border),
        threads_(threads) {
    require_size("pressure", pressure.size(), grid.size());
  }

  double n_nodes() const { return static_cast<double>(grid_.size()); }

  /// The sums without t.
  ContactSums counted() const {
    return summed([](std::size_t, std::size_t, double, ContactSums&) {});
  }

  /// All sums.
  /// @throws std::domain_error  t of a pair is not defined
  ContactSums measured(std::span<const double> gap,
                       double contact_modulus) const {
    require_positive("contact_modulus", contact_modulus, "Pa");
    const auto share = [&](std::size_t inside, std::size_t outside,
                           double spacing, ContactSums& sums) {
      const double p = pressure_[inside];
      const double g = gap[outside];
      if (std::isfinite(p) && std::isfinite(g))
        sums.excess += boundary_share(p, g, spacing, contact_modulus) - 0.5;
      else if (!sums.is_refused)
        sums += {.refused_pressure = p, .refused_gap = g, .is_refused = true};
    };
    const ContactSums sums = summed(share);
    if (sums.is_refused)
      static_cast<void>(boundary_share(sums.refused_pressure, sums.refused_gap,
                                       grid_.spacing_x(), contact_modulus));
    return sums;
  }

private:
  /// Calls add_share(node inside, node outside, spacing, sums) for each pair of
  /// neighbours of which one is in contact.
  template <class AddShare>
  ContactSums summed(const AddShare& add_share) const {
    ContactSums all = chunked_sum<ContactSums>(
        pressure_.size(), threads_, [&](std::size_t begin, std::size_t end) {
          ContactSums sums;
          for (std::size_t i = begin; i < end;) {
            const std::size_t row = i / width_ * width_;
            const std::size_t last = std::min(end, row + width_);
            add_row(row, i, last, add_share, sums);
            i = last;
          }
          return sums;
        });
    if (border_ == Border::free)
      all.twists += free_twists();
    return all;
  }

  /// Adds the nodes first..last-1 of the row that begins at a node, with their
  /// neighbours to the right and above.
  template <class AddShare>
  void add_row(std::size_t row, std::size_t first, std::size_t last,
               const AddShare& add_share, ContactSums& sums) const {
    const bool is_free = border_ == Border::free;
    const bool is_last = row + width_ == pressure_.size();
    const bool has_above = !is_free || !is_last;
    const std::size_t row_above = is_last ? 0 : row + width_;
    const double* const own = pressure_.data() + row;
    const double* const above = pressure_.data() + row_above;
    const auto add_pair = [&](std::size_t node, std::size_t other,
                              bool is_inside, double spacing) {
      ++sums.pairs;
      add_share(is_inside ? node : other, is_inside ? other : node, spacing,
                sums);
    };
    for (std::size_t ix = first - row; ix < last - row; ++ix) {
      const bool has_right = !is_free || ix + 1 < width_;
      const std::size_t right = ix + 1 < width_ ? ix + 1 : 0;
      const bool here = under_pressure(own[ix]);
      const bool beside = has_right && under_pressure(own[right]);
      const bool up = has_above && under_pressure(above[ix]);
      const bool across =
          has_right && has_above && under_pressure(above[right]);
      sums.nodes += here;
      sums.twists += twist(here + beside + up + across);
      if (has_right && here != beside)
        add_pair(row + ix, row + right, here, grid_.spacing_x());
      if (has_above && here != up)
        add_pair(row + ix, row_above + ix, here, grid_.spacing_y());
    }
  }

  /// n_1 - n_3 of the squares before the first nodes of the rows and columns,
  /// whose other nodes lie beyond a free border.
  long free_twists() const {
    const auto holds = [&](int ix, int iy) {
      return ix >= 0 && ix < grid_.points_x && iy < grid_.points_y &&
             under_pressure(pressure_[grid_.index(ix, iy)]);
    };
    long twists = 0;
    for (int ix = -1; ix < grid_.points_x; ++ix)
      twists += twist(holds(ix, 0) + holds(ix + 1, 0));
    for (int iy = 0; iy < grid_.points_y; ++iy)
      twists += twist(holds(0, iy) + holds(0, iy + 1));
    return twists;
  }

  const Grid& grid_;
  std::size_t width_;
  std::span<const double> pressure_;
  Border border_;
  int threads_;
};

/// Returns A_l/A_0 of (A.3), which may be slightly outside 0..1.
double line_share(const ContactSums& sums, double n) {
  return (static_cast<double>(sums.nodes) + 0.5 * sums.excess) / n;
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
  const Contact contact(grid, pressure, border, 1);
  require_size("gap", gap.size(), grid.size());
  const double share =
      line_share(contact.measured(gap, contact_modulus), contact.n_nodes());
  return std::clamp(share, 0.0, 1.0);
}

double euler_characteristic(const Grid& grid, std::span<const double> pressure,
                            Border border) {
  const ContactSums sums = Contact(grid, pressure, border, 1).counted();
  return 0.25 * static_cast<double>(sums.twists); // (A.4)
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

Observed corrected_area_fraction(const Grid& grid,
                                 std::span<const double> pressure,
                                 std::span<const double> gap,
                                 const AreaOperator& elasticity, int threads) {
  const auto& [contact_modulus, coefficients, border] = elasticity;
  const Contact contact(grid, pressure, border, threads);
  require_size("gap", gap.size(), pressure.size());
  const ContactSums sums = contact.measured(gap, contact_modulus);
  const double n = contact.n_nodes();
  const double euler = 0.25 * static_cast<double>(sums.twists); // (A.4)
  const double share =
      line_share(sums, n) -
      coefficients.perimeter * static_cast<double>(sums.pairs) / n +
      coefficients.euler * euler / n;
  const double counted = static_cast<double>(sums.nodes) / n;
  if (share < least_corrected_share * counted)
    return {Observed::none,
            fmt::format(
                "the contact patches are too small for this grid: the estimate "
                "is only {:.2g} of the counted area, but must be at least {}",
                share / counted, least_corrected_share)};
  return std::min(share, 1.0); // (A.5)
}

} // namespace asperity::results
