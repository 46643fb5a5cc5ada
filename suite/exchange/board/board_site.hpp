#pragma once

// The pages of the board: a front page, one page per problem and one per code.

#include "suite/exchange/board/board.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::exchange {

/// Writes index.html, problem-<name>.html, code-<code>.html, board.json and the
/// figures.
/// @throws std::system_error  naming the path
void write_site(const std::vector<BoardProblem>& board,
                const std::filesystem::path& site);

} // namespace asperity::exchange
