#pragma once

// What is known of the errors of a method's curve: how many load steps have a
// bound of the error of their mean gap, or an estimate of it, and how large
// these are.

#include "results/types/result.hpp"

namespace asperity::reports {

/// The errors of one column over all realisations of a method, relative to the
/// rms height of the surface that the method used.
struct ErrorsOfSteps {
  int steps = 0;                        ///< load steps with an error
  double largest = results::not_given;  ///< of the errors [h_rms]; NaN: none
  double pressure = results::not_given; ///< p_0 of the largest error [Pa]
};

/// The bounds `certified_gap_error` of one method, and its estimates
/// `estimated_gap_error`.
struct Certified {
  int steps = 0; ///< converged load steps with contact
  ErrorsOfSteps bounds;
  ErrorsOfSteps estimates;
};

/// @param method  one of the result
Certified certified_of(const results::Result& result,
                       const results::MethodRecord& method);

} // namespace asperity::reports
