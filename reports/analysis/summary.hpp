#pragma once

// Everything the report, the check and summary.json say about one result, as
// plain data. Owns the step from curves to numbers with names.

#include "cases/types/case.hpp"
#include "cases/types/reference.hpp"
#include "reports/numbers/fits.hpp"
#include "results/types/result.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity::reports {

/// The fits of one method on one realisation.
struct RealizationFits {
  SurfaceScales scales;
  SlopeFit slope;
  ParameterFit parameter;
  AreaFit area;
  /// u_0/h_rms of (18) with the fitted gamma (for the theory: its own) [1]:
  /// what the slope would tend to at vanishing pressure
  double asymptotic_slope = not_a_number;
};

struct Cost {
  int steps = 0;
  int failed_steps = 0;        ///< not converged
  int largest_iterations = 0;  ///< of one step
  double cpu_time = 0.0;       ///< set-up and steps of all realisations [s]
  double setup_cpu_time = 0.0; ///< of all realisations [s]
  double step_cpu_time = 0.0;  ///< median over steps [s]
};

/// One method over all its realisations. `quantities` has the names that
/// [expect] uses, those at a load as the case or its references spell them; a
/// quantity that means nothing for the case is not in it, one that could not be
/// had is there without a value and with the reason.
struct MethodSummary {
  std::string name;
  std::string kind;
  std::string description;
  std::map<std::string, Estimate> quantities;
  std::vector<RealizationFits> fits; ///< one a realisation; rough cases only
  /// What could not be worked out at all and why: "claims: ..."; the quantities
  /// concerned are missing, everything else is there.
  std::vector<std::string> problems;
  Cost cost;
};

enum class Outcome {
  ok,
  failed,
  undecided, ///< the 95 % interval reaches over an end of the band
  missing,   ///< not to be had: counts as failed
  skipped,   ///< of a method that was left out of a complete run on purpose
};

/// One expectation held against one method.
struct Verdict {
  std::string quantity;
  std::string method;
  Estimate estimate;
  double low = 0.0;
  double high = 0.0;
  Outcome outcome = Outcome::missing;
  bool passes_if_undecided = false; ///< as the case has it

  /// ok, or undecided where the case lets that pass.
  bool is_passed() const;
};

/// Our number for a published quantity.
struct OurValue {
  std::string method;
  Estimate estimate; ///< perhaps without a value, but with the reason
};

/// One line of the case's reference.csv beside ours: informative, no verdict.
struct PublishedValue {
  cases::ReferenceValue reference;
  std::vector<OurValue> ours; ///< methods that have a quantity of that name
};

struct Summary {
  std::string case_name;
  std::string case_title;
  std::string case_hash;
  std::string status; ///< of the result: running | complete | interrupted
  results::Provenance provenance;
  std::string reference_method; ///< theory that methods without magnification
                                ///< are held against, or ""
  std::vector<MethodSummary> methods;
  std::vector<Verdict> verdicts;
  std::vector<PublishedValue> published; ///< in the order of reference.csv

  bool all_ok() const; ///< every verdict is passed or skipped
  /// How many expectations were held against a method: those not skipped.
  int n_judged() const;
};

/// True for shapes with an exact solution, where gamma and kappa mean nothing,
/// on the uniform block that it is of.
bool is_exact_shape(const cases::Case& contact_case);

/// True if the method is a theory that took the case's formula as spectrum.
bool uses_formula(const cases::Case& rough_case,
                  const results::MethodRecord& method);

/// The surface a method's realisation ran on: its own where it has one, else
/// the case's; null if neither is in the result.
const results::SurfaceRecord* surface_of(const results::Result& result,
                                         const results::MethodRecord& method,
                                         std::size_t realization);

/// E*, h_rms and h' that a method's realisation is measured in: those of the
/// surface it ran on, or of the formula if that is what the theory used.
/// Fields are NaN where neither is known.
SurfaceScales scales_of(const results::Result& result,
                        const cases::Case& rough_case,
                        const results::MethodRecord& method,
                        std::size_t realization);

/// The magnification at which a method of the case sees the surface; empty for
/// all of its roughness.
std::optional<double> magnification_of(const cases::Case& rough_case,
                                       const results::MethodRecord& method);

/// The theory record that a method is compared with: of those that see the
/// surface at its magnification the one called "theory", else the first; null
/// if there is none.
const results::MethodRecord*
reference_theory(const results::Result& result, const cases::Case& rough_case,
                 const results::MethodRecord& method);

/// The method whose variant this is, "md" of "md.explicit"; null if it is none
/// or its method did not run.
const results::MethodRecord* base_method(const results::Result& result,
                                         const results::MethodRecord& method);

/// @throws cases::CaseError  the result's reference has mistakes
Summary summarize(const results::Result& result, const cases::Case& rough_case);

} // namespace asperity::reports
