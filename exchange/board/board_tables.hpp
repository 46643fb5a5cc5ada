#pragma once

// The tables of the board: which rows and columns, and what links where.

#include "exchange/board/board.hpp"
#include "exchange/board/board_page.hpp"

#include <string>

namespace asperity::exchange {

/// File names of the pages of a problem and of a code.
std::string problem_page_name(const std::string& problem);
std::string code_page_name(const std::string& code);

/// A head of a column; `small` is its second line.
BoardCell head(const std::string& text, const std::string& small = "",
               bool is_number = true);

BoardCell error_cell(double error);
/// The CPU time of all loads with its interval and the run that it belongs to,
/// or "as submitted" if nothing says how it was measured.
BoardCell time_cell(const BoardEntry& entry);

/// The peak memory in MB.
BoardCell memory_cell(const BoardEntry& entry);

/// The accuracy of an entry, or a dash.
std::string accuracy_word(const BoardEntry& entry);

/// Certified entries in their order. Answers of one version of a code to the
/// same number of loads share a row, if their accuracies differ.
BoardTable ranking(const BoardProblem& problem);

/// Certified entries of a problem with a mesh: their elements, their errors
/// with the compliance of this mesh and against the continuum, and their cost.
/// Empty if no entry was computed on the mesh.
BoardTable mesh_table(const BoardProblem& problem);

/// Entries in another state, with the reasons.
BoardTable unranked(const BoardProblem& problem, BoardEntry::State state);

/// Reference answers on this grid and in the continuum.
BoardTable reference_table(const BoardProblem& problem);

} // namespace asperity::exchange
