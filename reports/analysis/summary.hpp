#pragma once

// What the report, the check and summary.json state about one result, as plain
// data: the step from curves to named quantities.

#include "input/types/case.hpp"
#include "input/types/reference.hpp"
#include "reports/analysis/asked_interval.hpp"
#include "reports/analysis/certified.hpp"
#include "reports/numbers/fits.hpp"
#include "results/types/result.hpp"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// The fits of one method on one realisation.
struct RealizationFits {
  SurfaceScales scales;
  SlopeFit slope;
  ParameterFit matched; ///< gamma by the slope, the whole curve, the energy
  ParameterFit curve;
  ParameterFit energy;
  AreaFit area;
  /// u_0/h_rms of Eq. (18) of Yang and Persson (2008) with the fitted gamma
  /// (for the theory: its own) [1]. The slope would approach this value at
  /// vanishing pressure.
  double asymptotic_slope = not_a_number;
  /// Of a theory: its curve at loads between those of the case, including
  /// these, in ascending pressure, with pressure, gap and area.
  std::vector<results::CurvePoint> fine_curve;

  /// Leaves no fit of gamma, for one reason.
  void set_no_gamma(const std::string& reason) {
    matched = curve = energy = {};
    matched.reason = curve.reason = energy.reason = reason;
  }
};

struct Cost {
  int steps = 0;
  int failed_steps = 0;        ///< not converged
  int largest_iterations = 0;  ///< in one step
  double cpu_time = 0.0;       ///< set-up and steps of all realisations [s]
  double setup_cpu_time = 0.0; ///< of all realisations [s]
  double step_cpu_time = 0.0;  ///< median over steps [s]
};

/// One method over all its realisations. The keys of `quantities` are the names
/// that [expect] uses; names at a load are spelled as in the case or its
/// references. A quantity that is meaningless for the case is absent; one that
/// could not be determined is present without a value and with the reason.
struct MethodSummary {
  std::string name;
  std::string kind;
  std::string description;
  std::map<std::string, Estimate> quantities;
  std::vector<RealizationFits> fits; ///< one per realisation; rough cases only
  /// What could not be computed at all and why: "claims: ...". The quantities
  /// concerned are absent; all others are present.
  std::vector<std::string> problems;
  /// What the case asks and the method has no answer to, with the reason: a
  /// sentence each.
  std::vector<std::string> omissions;
  Cost cost;
  Certified certified;

  /// The estimate of that name, or null.
  const Estimate* quantity(const std::string& quantity_name) const {
    const auto found = quantities.find(quantity_name);
    return found == quantities.end() ? nullptr : &found->second;
  }
};

/// The method of that name, or null.
const MethodSummary* method_called(std::span<const MethodSummary> methods,
                                   const std::string& name);

enum class Outcome {
  ok,
  failed,
  undecided, ///< the 95 % interval contains an end of the band
  missing,   ///< not available: counts as failed
  skipped,   ///< the method was deliberately omitted from a complete run
};

/// One expectation compared with one method.
struct Verdict {
  std::string quantity;
  std::string method;
  Estimate estimate;
  double low = 0.0;
  double high = 0.0;
  Outcome outcome = Outcome::missing;
  bool passes_if_undecided = false; ///< as set in the case

  /// True if ok, or if undecided and the case accepts that.
  bool is_passed() const;
};

/// The computed value of a published quantity.
struct OurValue {
  std::string method;
  Estimate estimate; ///< may lack a value, but then has the reason
};

/// One line of the case's reference.csv beside the computed values. It is
/// informative and has no verdict.
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
  /// Theory with which methods without magnification are compared, or "".
  std::string reference_method;
  std::vector<MethodSummary> methods;
  std::vector<Verdict> verdicts;
  std::vector<PublishedValue> published; ///< in the order of reference.csv
  /// What the user asked, in sentences (reports/pages/answers.hpp), and the
  /// sources of error of area and mean gap; summarize() leaves them empty.
  std::vector<std::string> answers = {};
  std::vector<IntervalPart> interval_parts = {};

  bool all_ok() const; ///< every verdict is passed or skipped
  /// Number of expectations that were compared with a method, that is, not
  /// skipped.
  int n_judged() const;
};

/// True for shapes with an exact solution, for which gamma and kappa are
/// meaningless, on the uniform block to which that solution applies.
bool is_exact_shape(const cases::Case& contact_case);

/// True for those whose area and mean gap the solution has: of a tilted punch,
/// only the moment is known.
bool has_exact_curve(const cases::Case& contact_case);

/// Returns the method of the case by which a record was made; null for a record
/// of other origin.
const cases::MethodSpec* spec_of(const cases::Case& contact_case,
                                 const results::MethodRecord& method);

/// Returns its settings, or null if they are of another kind.
template <class Settings>
const Settings* settings_of(const cases::Case& contact_case,
                            const results::MethodRecord& method) {
  const cases::MethodSpec* const spec = spec_of(contact_case, method);
  return spec == nullptr ? nullptr : std::get_if<Settings>(&spec->settings);
}

/// Returns whether its faces attract each other.
bool is_adhesive(const cases::Case& contact_case,
                 const results::MethodRecord& method);

/// Returns the law by which they do, on the surface of realisation 0; none
/// without adhesion or without a surface.
std::optional<mechanics::ContactInterface>
adhesion_of(const results::Result& result, const cases::Case& contact_case,
            const results::MethodRecord& method);

/// True if the method is a theory that used the analytical spectrum of the
/// case.
bool uses_formula(const cases::Case& contact_case,
                  const results::MethodRecord& method);

/// Returns the surface on which a method's realisation ran: its own if it has
/// one, otherwise that of the case; null if the result contains neither.
const results::SurfaceRecord* surface_of(const results::Result& result,
                                         const results::MethodRecord& method,
                                         std::size_t realization);

/// Returns E*, h_rms and h' by which a method's realisation is normalised:
/// those of the surface on which it ran, or of the analytical spectrum if the
/// theory used it. Fields are NaN where neither is known.
SurfaceScales scales_of(const results::Result& result,
                        const cases::Case& contact_case,
                        const results::MethodRecord& method,
                        std::size_t realization);

/// Returns how contact is decided in the maps of a method, and what lies beyond
/// their border: of a method that is not in the case, as of another program, by
/// the pressure, on a periodic map.
/// @param rms_height  of its surface [m]
mechanics::ContactCriterion
contact_criterion_of(const cases::Case& contact_case,
                     const results::MethodRecord& method, double rms_height);
mechanics::Border border_of(const cases::Case& contact_case,
                            const results::MethodRecord& method);

/// Returns true if the method presses the surface once on an infinite
/// half-space.
bool has_free_boundaries(const cases::Case& contact_case,
                         const results::MethodRecord& method);

/// Returns true if the method is a finite-element block with free sides, or
/// with a counter-body of finite size, to which no exact solution applies.
bool has_free_sides(const cases::Case& contact_case,
                    const results::MethodRecord& method);

inline constexpr const char* not_with_free_sides =
    "there is no exact solution with free sides";

/// Returns the magnification at which a method of the case resolves the
/// surface; empty if it resolves all of the roughness.
std::optional<double> magnification_of(const cases::Case& contact_case,
                                       const results::MethodRecord& method);

/// Returns the theory record with which a method is compared: of those that
/// resolve the surface at the magnification of the method, the one called
/// "theory", otherwise the first; null if there is none.
const results::MethodRecord*
reference_theory(const results::Result& result, const cases::Case& contact_case,
                 const results::MethodRecord& method);

/// Returns the method of which this is a variant, "md" for "md.explicit"; null
/// if it is not a variant or its base method did not run.
const results::MethodRecord* base_method(const results::Result& result,
                                         const results::MethodRecord& method);

/// @throws input::InputError  the reference data in the result contain mistakes
Summary summarize(const results::Result& result,
                  const cases::Case& contact_case);

} // namespace asperity::reports
