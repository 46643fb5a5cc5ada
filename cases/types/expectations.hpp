#pragma once

// The quantities a case may hold an expectation of. Owns their names, and
// which methods and surfaces can answer each.

#include "cases/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// The table of the case that a quantity needs beside its methods.
enum class Study { none, magnification, adhesion };

struct ExpectationName {
  std::string name;
  std::string description;     ///< one sentence, with the unit
  bool theory_answers = false; ///< else: numerical methods only
  bool needs_theory = false;   ///< the case must have a [theory] to compare to
  bool variants_only = false;  ///< of "md.explicit" beside "md", not of "md"
  std::vector<SurfaceKind> surfaces = {}; ///< empty: any
  bool theory_only = false;               ///< no numerical method answers
  Study study = Study::none; ///< answered by study_theory() alone if not none
};

const std::vector<ExpectationName>& expectation_names();

/// Of that name, or of a quantity at a load ("area_fraction@p=0.01 E*", see
/// quantity_at_load.hpp); nullptr if there is no such quantity.
const ExpectationName* expectation_called(const std::string& name);

} // namespace asperity::cases
