#pragma once

// The figures of a problem on the board.

#include "reports/figures/gnuplot.hpp"
#include "suite/exchange/board/board.hpp"

namespace asperity::exchange {

/// The heights as a picture.
reports::Figure surface_figure(const Problem& problem);

/// Certified error against CPU time of the certified entries that state a time,
/// one colour per code, filled for best accuracy. Its problem is set if no
/// entry has a time.
reports::Figure error_figure(const BoardProblem& problem);

enum class MeshCost { time, memory };

/// Distance from the continuum against a cost of the same entries, one colour
/// per code, version and element. Its problem is set likewise.
reports::Figure mesh_figure(const BoardProblem& problem, MeshCost cost);

} // namespace asperity::exchange
