#pragma once

// The answer of another program to a problem, with everything that follows from
// its fields: certificates, broken claims, typical mistakes, rows of a curve.

#include "input/types/case.hpp"
#include "run/methods/step_solver.hpp"
#include "run/methods/surfaces_of_case.hpp"
#include "suite/exchange/answers/adhesive_answer.hpp"
#include "suite/exchange/answers/certified_field.hpp"
#include "suite/exchange/submission.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::exchange {

/// One load: its certificate, the row and maps of the result, and the mistakes
/// that were recognised.
struct ImportedLoad {
  std::string file;                    ///< name of the submitted file
  double cpu_time_low = not_a_number;  ///< as SubmittedLoad
  double cpu_time_high = not_a_number; ///< likewise
  double peak_memory = not_a_number;   ///< likewise
  CertifiedField field; ///< with adhesion its claims, without bounds
  std::optional<AdhesiveAnswer> adhesive; ///< of a problem with adhesion
  /// Bound of the error of the mean gap that follows from the field, with the
  /// compliance of the submission's mesh; NaN: it has none [m].
  double mesh_error = not_a_number;
  methods::StepAnswer answer;
  std::vector<std::string> mistakes;

  /// Whether every claim holds and no mistake was recognised.
  bool is_sound() const;
};

struct ImportedAnswer {
  Submission submission;           ///< its fields have been moved into `loads`
  std::string method;              ///< "contactmechanics-1.8.3-default"
  std::vector<ImportedLoad> loads; ///< ascending in load

  bool is_sound() const;
};

/// The name of the row of a result's provenance that says which body an import
/// was certified against, unless it is the periodic half-space.
inline constexpr const char* imported_body = "imported body";
/// What it says of a problem with adhesion.
inline constexpr const char* attracting_faces = "faces that attract each other";

/// The surface of a problem, with the statistics that a result records.
methods::SurfaceOfCase surface_of(const Problem& problem);

/// The operator behind a half-space or condensed method, without a cache.
std::unique_ptr<contact::SurfaceOperator>
operator_of(const cases::Case& contact_case, const cases::MethodSpec& method,
            const methods::SurfaceOfCase& surface);

/// Makes the compliance of the problem's mesh with an element, "Q1" or "Q2".
using MeshOperator = std::function<std::unique_ptr<contact::SurfaceOperator>(
    const std::string& element)>;

/// Reads and certifies a submission. The contact stiffness follows from
/// differences between the loads. Answers to a problem with adhesion have no
/// bounds, but energies.
/// @param surface  surface_of(problem)
/// @param mesh     of the problem, if it is known
/// @throws input::InputError  the submission cannot be read, or a field cannot
///                            be certified
ImportedAnswer import_answer(const std::filesystem::path& folder,
                             const Problem& problem,
                             const methods::SurfaceOfCase& surface,
                             const MeshOperator& mesh = {});

/// The content of certificate.json.
nlohmann::ordered_json answer_json(const ImportedAnswer& answer);

} // namespace asperity::exchange
