#pragma once

// Before a problem is handed out, the program answers it as anybody else does:
// its reference is imported through the files that were written.

#include "suite/exchange/answers/reference_answers.hpp"
#include "suite/exchange/problem_mesh.hpp"

#include <filesystem>
#include <string>

namespace asperity::exchange {

/// Imports the pressures of the reference answers through the files of a
/// problem, as `asperity import` does, and through what its README states of
/// the body (problem_folder.hpp). Each must be certified as the answer to the
/// problem that is stated, with the mean gap, area and energy of
/// reference.json.
/// @param folder  as write_problem() wrote it
/// @return  what does not hold, one line each; empty if all does
/// @throws input::InputError  the problem cannot be read or answered
std::string broken_reference(const AnsweredProblem& answered,
                             const std::filesystem::path& folder);

/// Writes the folder of a problem (write_problem()) after it has been written
/// among the temporary files and broken_reference() has found nothing there.
/// @throws std::logic_error  naming what does not hold; nothing was written
void write_certified_problem(const AnsweredProblem& answered,
                             const std::string& case_text,
                             const std::filesystem::path& folder,
                             const ProblemMesh* mesh = nullptr);

} // namespace asperity::exchange
