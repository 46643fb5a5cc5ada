#pragma once

// What a case asks of its methods, and which of them have no answer to it. This
// is the one place that says so: the reader refuses by it what nobody answers,
// and a run, its page and summary.json say of each method what it leaves out.

#include "input/types/case.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::cases {

/// A table or key of a case that asks something of each of its methods.
struct AskedTraits {
  const char* name; ///< "[flow]", "normal_stiffness of [conductance]"
  /// Columns of a curve that a method with an answer fills, unless the note of
  /// the row says why not.
  std::vector<const char*> columns;
  bool (*is_in)(const Case&);
  /// Why a method has no answer, as "needs ..." or "has ..."; "" if it has one.
  /// Null: it is asked of study_theory() alone.
  std::string (*obstacle)(const Case&, const MethodSpec&);
};

/// All that can be asked: by studies, in the order in which they were added,
/// and by other tables.
std::span<const AskedTraits> all_asked();

/// Adds what a study asks.
void add_question(const AskedTraits& question);

/// "has no contact map", or "".
std::string no_map(const Case& contact_case, const MethodSpec& method);

/// One thing that a case asks and a method does not compute.
struct Omission {
  std::string what; ///< AskedTraits::name
  std::string why;  ///< AskedTraits::obstacle()

  /// Returns "[spots] is not computed: has no contact map".
  std::string sentence() const;
};

/// Returns what the case asks and this method of it does not compute.
std::vector<Omission> omissions(const Case& contact_case,
                                const MethodSpec& method);

/// Returns a sentence for each thing asked that none of these methods computes,
/// or that only theories compute although there are methods with fields.
///
/// @param methods  those of the case that are run
std::vector<std::string> omission_warnings(const Case& contact_case,
                                           std::span<const MethodSpec> methods);

} // namespace asperity::cases
