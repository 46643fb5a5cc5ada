#pragma once

// Typical mistakes in a pressure field that another program has written: units,
// sign, orientation, another load, another modulus. Each is recognised by what
// the field itself says and named in a sentence.

#include "contact/operators/surface_operator.hpp"
#include "suite/exchange/problem.hpp"
#include "suite/exchange/submission.hpp"

#include <string>
#include <vector>

namespace asperity::exchange {

/// Requires the field to have the grid of the problem.
/// @throws input::InputError  naming the file, what was found and, if it is
///                            recognised, the mistake: transposed, periodic end
///                            points included, another number of points
void require_grid(const Problem& problem, const SubmittedLoad& load);

/// Returns the mistakes that are recognised in a field on the right grid;
/// empty if there are none. A mean pressure that differs from the load by more
/// than a thousandth is always one. The orientation counts as a mistake if
/// another one, possibly shifted, has a duality gap ten times smaller.
/// @param elasticity  C of the problem; its scratch is used
std::vector<std::string>
recognised_mistakes(contact::SurfaceOperator& elasticity,
                    const Problem& problem, const SubmittedLoad& load);

} // namespace asperity::exchange
