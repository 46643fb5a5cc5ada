#pragma once

// What reports are told of the studies that a case may ask for. They know none
// of them: studies/list/list.cpp adds them when the program starts.

#include "input/types/expectations.hpp"
#include "results/types/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// A load step of which a number is asked.
struct StepAtLoad {
  const results::CurvePoint& row;
  const results::CurvePoint* theory; ///< at the same load; null: there is none
  double contact_modulus;            ///< E* [Pa]
};

/// A quantity at one load that [expect] and reference.csv may name,
/// "leak_departure@p=1 MPa": a number of the first step of the loading branch
/// with this load.
struct NumberAtLoad {
  cases::ExpectationName name;
  /// NaN: not known. With `needs_theory`, the step has that of the theory.
  double (*of)(const StepAtLoad& step);
  /// Why an infinite number has no mean, a format of how many realisations have
  /// it, of how many, and of p/E*; null: it is never infinite.
  const char* infinite = nullptr;
};

/// A column by which a study answers at a load.
struct AnswerColumn {
  const results::CurveColumn* column;
  std::string words;     ///< "Leak rate of water at 100 kPa along x"
  std::string zero = {}; ///< what a surface with 0 is: "tight"; "": none has 0
};

struct Figure;
struct FigureData;
struct MethodSummary;
struct ReportEntry;

/// The part of a study that belongs to the pages; a member that is null is not
/// part of it. Each is asked of every result.
struct StudyPages {
  std::string name; ///< "flow"
  /// Names of its figures; one that ends with "-" is followed by the name of a
  /// method or by the number of a load.
  std::vector<std::string> figure_names = {};
  /// Of one result, as ReportFigure::draw.
  std::vector<Figure> (*figures)(const FigureData& data) = nullptr;
  /// The answer in a sentence with its load and units; "" if there is none.
  std::string (*answer)(const ReportEntry& entry) = nullptr;
  /// The columns by which it answers for several samples, which tables have
  /// first; they are without numbers if the case does not ask.
  std::vector<AnswerColumn> (*answer_columns)(const cases::Case& contact_case) =
      nullptr;
  /// Sentences of the text on methods, each with a blank before it; "" if the
  /// case does not ask.
  std::string (*methods_text)(const cases::Case& contact_case) = nullptr;
  /// Names of the quantities of curves, and at a magnification, that [expect]
  /// may state.
  std::vector<cases::ExpectationName> quantities = {};
  std::vector<NumberAtLoad> at_load = {};
  /// Adds these quantities, and others that only reference.csv may name.
  /// @param names  quantities at a load that they do name
  void (*add_quantities)(const results::Result& result,
                         const cases::Case& contact_case,
                         const results::MethodRecord& method,
                         std::span<const std::string> names,
                         MethodSummary& summary) = nullptr;
  /// Adds its tables to summary.json, of which the page is rendered.
  void (*add_tables)(const ReportEntry& entry,
                     nlohmann::ordered_json& page) = nullptr;
};

/// Adds a study, whose object must live as long as the program, and tells the
/// reader of cases its quantities.
void add_study_pages(const StudyPages& pages);

/// The studies in the order in which they were added.
std::span<const StudyPages* const> study_pages();

} // namespace asperity::reports
