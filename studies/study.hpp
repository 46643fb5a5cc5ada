#pragma once

// A study: what a case may ask of a contact besides its curve. One object says
// everything about it that the rest of the program needs, and
// studies/list/list.cpp lists them; adding one is told in docs/extending.md.

#include "base/grid.hpp"
#include "contact/operators/surface_operator.hpp"
#include "input/reader/study_keys.hpp"
#include "mechanics/contact_nodes.hpp"
#include "reports/study_pages.hpp"
#include "results/types/result.hpp"
#include "run/methods/surfaces_of_case.hpp"
#include "theory/persson/persson.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::studies {

/// Whether a case asks for the study with these settings.
template <class Settings>
bool asks(const cases::Case& contact_case) {
  return contact_case.study<Settings>() != nullptr;
}

/// A converged load step with its maps, as a study sees it.
struct Step {
  const cases::Case& contact_case;
  const cases::MethodSpec& method;
  const methods::SurfaceOfCase& surface; ///< of the method
  Grid grid;                             ///< of the maps
  std::span<const double> pressure;      ///< grid.size() [Pa]
  std::span<const double> gap;           ///< grid.size() [m]
  mechanics::ContactNodes nodes;         ///< which of them are in contact
  int threads = 1;
  /// Makes the operator of a surface method.
  std::function<std::unique_ptr<contact::SurfaceOperator>()> elasticity = {};
};

/// The step of these maps, in one thread and without an operator; the maps and
/// what they belong to must outlive it.
Step step_with_maps(const cases::Case& contact_case,
                    const cases::MethodSpec& method,
                    const methods::SurfaceOfCase& surface, const Grid& grid,
                    std::span<const double> pressure,
                    std::span<const double> gap);

/// A table of a result that is computed when it is needed.
struct AskedTable {
  std::string name;
  std::function<results::Table()> make; ///< may throw any std::exception
};

/// What a study does; a member that is null is not part of it.
struct Study {
  const cases::StudyKeys& (*keys)();
  const reports::StudyPages& (*pages)();
  /// Sets its columns of the row of a step. A number that it cannot determine
  /// is NaN, and the note of the row says why; no exception leaves it.
  void (*evaluate)(const Step& step, results::CurvePoint& row) = nullptr;
  /// Sets its columns of a row of the theory, whose loss factor is that of Yang
  /// and Persson.
  void (*evaluate_theory)(const cases::Case& contact_case,
                          const theory::PerssonContact& contact,
                          results::CurvePoint& row) = nullptr;
  /// Sets the columns that follow from others by the settings of the study, of
  /// new rows after `evaluate` and of rows that an earlier run kept.
  void (*rescale)(const cases::Case& contact_case,
                  results::CurvePoint& row) = nullptr;
  /// The tables that the theory of the case answers.
  std::vector<AskedTable> (*theory_tables)(
      const cases::Case& contact_case,
      const theory::PerssonContact& contact) = nullptr;
  /// A table of the heaviest saved step that has one.
  /// @param map  the user's map in the grid of the step
  std::optional<results::Table> (*map_table)(
      const Step& step, const results::MapInCell& map) = nullptr;
  /// Memory that `evaluate` needs, per node of the surface [B].
  double memory = 0.0;
  /// Whether it needs that memory for a method; null: for each with maps.
  bool (*is_for)(const cases::Case& contact_case,
                 const cases::MethodSpec& method) = nullptr;
};

/// All studies, in the order of the reference page and of a report.
std::span<const Study* const> all_studies();

/// Whether a study of a case reads the maps of every load step.
bool needs_all_maps(const cases::Case& contact_case);

/// Lets all studies that the case asks for evaluate a converged step.
void evaluate_studies(const Step& step, results::CurvePoint& row);

/// Lets them do so for a row of a theory.
void evaluate_studies(const cases::Case& contact_case,
                      const theory::PerssonContact& contact,
                      results::CurvePoint& row);

/// The table of a study of the heaviest saved step of a curve that has one;
/// nothing without such a step.
/// @param study  with `map_table`
std::optional<results::Table>
table_of_heaviest_map(const Study& study, const cases::Case& contact_case,
                      const cases::MethodSpec& method,
                      const methods::SurfaceOfCase& surface,
                      const results::Curve& curve);

/// Lets them set again what follows from their settings.
void rescale_studies(const cases::Case& contact_case, results::CurvePoint& row);

} // namespace asperity::studies
