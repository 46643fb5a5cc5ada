#pragma once

// Describes a case before it is run: all of its keys in SI units, the numbers
// that follow from them, and the plan of its run. Nothing is solved or written.

#include "input/reader/resolved_keys.hpp"
#include "results/types/result.hpp"
#include "run/plan/plan.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::run {

/// A number that follows from the keys of a case.
struct DerivedNumber {
  std::string name; ///< "node_spacing"
  double value = 0.0;
  std::string unit;    ///< SI; "1" if dimensionless
  std::string meaning; ///< one line for the reader
};

/// One load step in SI units.
struct DescribedLoad {
  double target = 0.0;  ///< p_0 [Pa] or mean gap [m]; NaN: not known
  double reduced = 0.0; ///< p_0/E* or mean gap/h_rms [1]; NaN: not known
  bool is_unloading = false;
};

/// A method in one line.
struct DescribedMethod {
  std::string name;
  std::string kind;
  std::string text;
};

/// Everything that is known about a case before it is run.
struct CaseDescription {
  std::string name;
  std::string title;
  std::string file;
  std::string hash;                          ///< as in the result file
  std::map<std::string, std::string> inputs; ///< SHA-256 of the files it names
  std::vector<cases::ResolvedKey> keys;
  std::vector<DerivedNumber> derived;
  mechanics::Control control = mechanics::Control::nominal_pressure;
  std::vector<DescribedLoad> loads;
  std::vector<DescribedMethod> methods;
  Plan plan;
};

/// Describes a case. The surface of the first realisation is built if a method
/// needs it and the run fits into memory.
///
/// @throws input::InputError, std::domain_error  an unknown method name, or a
///                                               surface that cannot be built
CaseDescription describe_case(const cases::Case& contact_case,
                              const RunOptions& options);

/// Formats the description as readable text.
std::string description_text(const CaseDescription& description,
                             const cases::Case& contact_case);

/// Formats the description as JSON, with null for numbers that are not known.
std::string description_json(const CaseDescription& description,
                             const cases::Case& contact_case);

/// Formats a plan as JSON.
std::string plan_json(const Plan& plan, const cases::Case& contact_case);

} // namespace asperity::run
