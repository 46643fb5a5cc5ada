#pragma once

// The folder in which a problem is handed out: problem.json with its schema,
// heights in four formats, checksums, reference answers and a README with the
// equations.

#include "suite/exchange/problem_mesh.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity::exchange {

/// Requires that what write_problem() would replace is as it wrote it, which
/// the SHA256SUMS of the folder say.
/// @throws input::InputError  naming the file that is not, and what to do
void require_own_problem(const std::filesystem::path& folder);

/// What the README of a problem says of the body.
struct StatedBody {
  std::string text;
  /// Whether the text says everything, and the body that it states; else the
  /// text refers to `body` in problem.json.
  bool is_complete = false;
  mechanics::ElasticBlock body = {};
};

StatedBody stated_body(const Problem& problem);

/// Writes the folder, problem.json last: a folder that has it is complete.
/// @param answers    one per load of the discrete problem; the first one is
///                   given as the example
/// @param continuum  one per load, or none
/// @param case_text  the same problem as a case of this program, or empty
/// @param mesh       of the block, handed out with the heights, or null
/// @throws std::system_error  naming the path
void write_problem(const Problem& problem,
                   std::span<const ProblemAnswer> answers,
                   std::span<const ContinuumAnswer> continuum,
                   const std::string& case_text,
                   const std::filesystem::path& folder,
                   const ProblemMesh* mesh = nullptr);

/// The content of reference.json.
struct References {
  std::vector<ProblemAnswer> discrete;
  std::vector<ContinuumAnswer> continuum;
};

/// Reads reference.json of a folder; empty if there is none.
/// @throws input::InputError  the file is damaged
References read_references(const std::filesystem::path& folder);

} // namespace asperity::exchange
