#pragma once

// Computes the bearing (Abbott-Firestone) curve of a map and the parameters of
// its core (ISO 25178-2, by the construction of ISO 13565-2).

#include "surfaces/maps/height_map.hpp"

#include <vector>

namespace asperity::surfaces {

/// Height above the mean, above which the fraction `material_ratio` of the
/// nodes lies.
struct BearingPoint {
  double material_ratio = 0.0; ///< [1] 0..1
  double height = 0.0;         ///< [m]
};

/// The curve and its core. The equivalent line is the least-squares line of the
/// flattest part that covers 40 % of the nodes; it meets the material ratios 0
/// and 1 at the heights upper and lower.
struct BearingCurve {
  std::vector<BearingPoint> points; ///< material ratios 0, 0.001, ..., 1
  double core_height = 0.0;         ///< Sk = upper - lower [m]
  double peak_height = 0.0;         ///< Spk [m], reduced height of the peaks
  double valley_depth = 0.0;        ///< Svk [m], reduced depth of the valleys
  double peak_ratio = 0.0;          ///< Smr1 [1], where the curve meets upper
  double valley_ratio = 0.0;        ///< Smr2 [1], where the curve meets lower
  double upper = 0.0;               ///< [m] above the mean
  double lower = 0.0;               ///< [m] above the mean

  /// Height at a material ratio, interpolated.
  double height_at(double material_ratio) const;
};

/// Computes the curve. Spk is the height of the triangle on the base Smr1 whose
/// area is that between the curve and `upper`; Svk correspondingly.
BearingCurve bearing_curve(const HeightMap& map);

} // namespace asperity::surfaces
