#pragma once

// What reports are told of the studies that a case may ask for. They know none
// of them: studies/list/list.cpp adds them when the program starts.

#include "input/types/case.hpp"
#include "results/types/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

struct Figure;
struct MethodSummary;
struct ReportEntry;
struct Series;

/// The part of a study that belongs to the pages; a member that is null is not
/// part of it. Each is asked of every result.
struct StudyPages {
  std::string name; ///< "flow"
  /// Names of its figures; one that ends with "-" is followed by the name of a
  /// method or by the number of a load.
  std::vector<std::string> figure_names = {};
  /// @param index  of the entry, as in Series::entry
  std::vector<Figure> (*figures)(const ReportEntry& entry, std::size_t index,
                                 std::span<const Series> series) = nullptr;
  /// The answer in a sentence with its load and units; "" if there is none.
  std::string (*answer)(const ReportEntry& entry) = nullptr;
  /// Sentences of the text on methods, each with a blank before it; "" if the
  /// case does not ask.
  std::string (*methods_text)(const cases::Case& contact_case) = nullptr;
  /// Adds the quantities that [expect] and reference.csv may name.
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

/// Adds a study, whose object must live as long as the program.
void add_study_pages(const StudyPages& pages);

/// The studies in the order in which they were added.
std::span<const StudyPages* const> study_pages();

} // namespace asperity::reports
