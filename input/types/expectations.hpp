#pragma once

// The quantities for which a case may state expectations: their names, and the
// methods and surfaces for which they are defined.

#include "input/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// What a quantity is one of: of a whole curve, of a curve at one load, or of
/// the contact at a load and a magnification (quantity_at_load.hpp).
enum class QuantityOf { curve, load, magnification };

struct ExpectationName {
  std::string name;
  std::string description;     ///< one sentence, with the unit
  bool theory_answers = false; ///< false: numerical methods only
  bool needs_theory = false;   ///< the case must have a [theory] for comparison
  bool variants_only = false;  ///< defined for the variant "md.explicit", but
                               ///< not for "md"
  std::vector<mechanics::SurfaceKind> surfaces = {}; ///< empty: any
  bool theory_only = false; ///< defined for no numerical method
  /// The table that the case must have, "magnification", if only study_theory()
  /// provides the quantity; else empty.
  std::string study = {};
  QuantityOf of = QuantityOf::curve;
};

/// The quantities of curves with their own names, of others without load.
std::vector<ExpectationName> expectation_names(QuantityOf of);

/// Adds a quantity that somebody else evaluates: a study.
void add_expectation(const ExpectationName& quantity);

/// Returns the entry of that name, or of a quantity at a load
/// ("area_fraction@p=0.01 E*", see quantity_at_load.hpp); nullptr if there is
/// no such quantity.
const ExpectationName* expectation_called(const std::string& name);

} // namespace asperity::cases
