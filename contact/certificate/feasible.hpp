#pragma once

// Makes a pressure >= 0 of the prescribed mean from a submitted field, and
// finds what the bounds of the certificate need of it.

#include "base/ranks/node_sums.hpp"
#include "contact/certificate/certificate.hpp"
#include "contact/certificate/weighted.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::contact {

/// Defects of a submitted field that are seen without the operator.
struct Defects {
  std::size_t not_finite = 0, in_tension = 0; ///< numbers of nodes
  double largest_tension = 0.0;               ///< [Pa]

  Defects& operator+=(const Defects& other) {
    not_finite += other.not_finite;
    in_tension += other.in_tension;
    largest_tension = std::max(largest_tension, other.largest_tension);
    return *this;
  }
};

/// @throws std::domain_error  as check_field(), except for a pressure that is
///                            nowhere > 0
Defects sound_or_refused(const SurfaceOperator& elasticity,
                         const SubmittedField& submitted);

/// A pressure >= 0 of mean p_0 with what the bounds need of it.
struct Feasible {
  std::vector<double> pressure;
  std::vector<double> displacement; ///< (C + c) p [m]
  std::span<const double> heights;  ///< of the problem
  double lift = 0.0;       ///< mean of C p; 0 on a periodic surface [m]
  double separation = 0.0; ///< smallest u with gap >= 0 everywhere; with a
                           ///< hardness the one with the smallest G [m]
  double sunk_load = 0.0;  ///< H times the mean overlap there [J/m^2]
  double roundoff = 0.0;   ///< of any value of displacement [m]

  double excess(std::size_t i) const { ///< h - (C + c) p of a node [m]
    return heights[i] - displacement[i];
  }

  double gap(std::size_t i) const { ///< g at that separation [m]
    return separation - excess(i);
  }

  double pressure_excess(const Weighted& weighted) const { ///< <p, excess>
    return weighted.mean(pressure.size(), [this](std::size_t i) {
      return pressure[i] * excess(i);
    });
  }
};

/// Cuts off tension, and pressures above a hardness, scales the mean to p_0 and
/// applies the operator once.
/// @param problem    whose heights must outlive the result
/// @param submitted  pressure, as in SubmittedField; it is changed in place
/// @throws std::domain_error  no node has a pressure > 0
Feasible feasible(SurfaceOperator& elasticity, const SubmittedField& problem,
                  std::vector<double> submitted);

/// Fills displacement, lift, separation and roundoff of a pressure once more.
void displace(SurfaceOperator& elasticity, const SubmittedField& problem,
              Feasible& answer);

/// G = <p, g>, with a hardness plus H times the mean overlap, and its allowance
/// for roundoff [J/m^2].
/// @param pressure_excess  <p, excess>
double duality_gap(const Feasible& answer, double pressure_excess,
                   double mean_pressure);
double duality_gap(const Feasible& answer, const Weighted& weighted,
                   double mean_pressure);

} // namespace asperity::contact
