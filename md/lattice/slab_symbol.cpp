#include "md/lattice/slab_symbol.hpp"

#include "base/require.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <cstddef>

namespace asperity::md {
namespace {

using Matrix = Eigen::Matrix3d;

/// A slab that is mirror-symmetric in z.
struct Slab {
  Matrix alike;  ///< F: force on the lower face, both faces moving alike
  Matrix across; ///< B: force on the lower face, the upper one moving
};

/// Returns R M R with R = diag(1, 1, -1), the mirror image of M in z.
Matrix mirrored(Matrix matrix) {
  matrix.row(2) = -matrix.row(2);
  matrix.col(2) = -matrix.col(2);
  return matrix;
}

/// Combines two slabs by elimination of their common face. With the stiffness M
/// of that face,
///
///     B = -B_lower M^-1 B_upper
///     F = F_lower - B_lower M^-1 (R F_lower R + F_upper)
///
/// The second line follows from F = (lower face) + B and M =
/// R (F_lower - B_lower) R + F_upper - B_upper. It is simplified by hand so
/// that no large terms are subtracted.
Slab stacked(const Slab& lower, const Slab& upper) {
  const Matrix common =
      mirrored(lower.alike - lower.across) + upper.alike - upper.across;
  const Matrix transfer = -lower.across * common.inverse();
  return {lower.alike + transfer * (mirrored(lower.alike) + upper.alike),
          transfer * upper.across};
}

/// Returns whether the upper face no longer affects the lower one.
bool is_deep(const Slab& slab) {
  return slab.across.cwiseAbs().maxCoeff() <
         1e-18 * slab.alike.cwiseAbs().maxCoeff();
}

/// Returns whether the entry (row, column) couples a lateral axis to z. Such
/// entries are imaginary and odd in the wavevector; all others are real and
/// even.
bool is_odd(std::size_t row, std::size_t column) {
  return (row == 2) != (column == 2);
}

} // namespace

SymmetricBlock inverse(const SymmetricBlock& block, double added_lateral,
                       double added_normal) {
  const double xx = block.xx + added_lateral;
  const double yy = block.yy + added_lateral;
  const double zz = block.zz + added_normal;
  const double minor_x = yy * zz - block.yz * block.yz;
  const double minor_xy = block.xz * block.yz - block.xy * zz;
  const double minor_xz = block.xy * block.yz - block.xz * yy;
  const double factor =
      1.0 / (xx * minor_x + block.xy * minor_xy + block.xz * minor_xz);
  return {factor * minor_x,
          factor * (xx * zz - block.xz * block.xz),
          factor * (xx * yy - block.xy * block.xy),
          factor * minor_xy,
          factor * minor_xz,
          factor * (block.xy * block.xz - xx * block.yz)};
}

SlabSymbol::SlabSymbol(const Crystal& crystal) : spacing_(crystal.spacing) {
  const CellStiffness cell = cell_stiffness(crystal);
  for (std::size_t lower = 0; lower < 4; ++lower) {
    for (std::size_t other = 0; other < 8; ++other) {
      const std::size_t column = 1 + (other & 1U) - (lower & 1U);
      const std::size_t row = 1 + (other >> 1U & 1U) - (lower >> 1U & 1U);
      Offset& offset = offsets_[3 * row + column];
      offset.x = static_cast<int>(column) - 1;
      offset.y = static_cast<int>(row) - 1;
      for (std::size_t entry = 0; entry < 9; ++entry) {
        const double term =
            cell[(3 * lower + entry / 3) * 24 + 3 * other + entry % 3];
        offset.moving_alike[entry] += term;
        if (other >= 4)
          offset.across[entry] += term;
      }
    }
  }
}

SymmetricBlock SlabSymbol::clamped(double angle_x, double angle_y,
                                   int cells) const {
  if (cells < 1)
    refuse_argument("cells", cells, ">= 1");
  Slab power{Matrix::Zero(), Matrix::Zero()};
  for (const Offset& offset : offsets_) {
    const double angle = offset.x * angle_x + offset.y * angle_y;
    const double half = std::sin(0.5 * angle);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto row = static_cast<Eigen::Index>(i);
        const auto column = static_cast<Eigen::Index>(j);
        const double alike = offset.moving_alike[3 * i + j];
        const double across = offset.across[3 * i + j];
        // Multiplication by i or -i makes the odd entries real: K_xz = -i S_xz.
        const double sine = (i == 2 ? -1.0 : 1.0) * std::sin(angle);
        // The sum of moving_alike over the offsets vanishes for even entries,
        // so cos(angle) may be replaced by cos(angle) - 1.
        power.alike(row, column) +=
            alike * (is_odd(i, j) ? sine : -2.0 * half * half);
        power.across(row, column) +=
            across * (is_odd(i, j) ? sine : std::cos(angle));
      }
    }
  }

  // The slab is composed from the binary digits of `cells`, with the largest
  // power of two at the bottom.
  Slab whole;
  bool is_begun = false;
  for (int rest = cells;; power = stacked(power, power)) {
    if (is_deep(power))
      return symmetric_part(power.alike);
    if (rest & 1) {
      whole = is_begun ? stacked(power, whole) : power;
      is_begun = true;
    }
    rest >>= 1;
    if (rest == 0)
      return symmetric_part(whole.alike - whole.across);
  }
}

double SlabSymbol::contact_modulus(double angle_x, double angle_y,
                                   int cells) const {
  const double compliance = inverse(clamped(angle_x, angle_y, cells)).zz;
  return 2.0 / (std::hypot(angle_x, angle_y) * spacing_ * compliance);
}

} // namespace asperity::md
