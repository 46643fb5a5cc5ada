#pragma once

// What is certified about a method's curve: how many load steps have a bound of
// the error of their mean gap, and how large these bounds are.

#include "results/types/result.hpp"

namespace asperity::reports {

/// The bounds `certified_gap_error` of one method over all realisations,
/// relative to the rms height of the surface that the method used.
struct Certified {
  int steps = 0;                        ///< converged load steps with contact
  int certified = 0;                    ///< of these, those with a bound
  double largest = results::not_given;  ///< of the bounds [h_rms]; NaN: none
  double pressure = results::not_given; ///< p_0 of the largest bound [Pa]
};

/// @param method  one of the result
Certified certified_of(const results::Result& result,
                       const results::MethodRecord& method);

} // namespace asperity::reports
