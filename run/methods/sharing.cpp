#include "run/methods/sharing.hpp"

#include "base/ranks/shared_rows.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/surfaces_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::methods {
namespace {

/// Whether a method has an operator, and its grid a size, that ranks share.
bool is_for_ranks(const cases::MethodSpec& method, const Grid& grid) {
  const auto* block = std::get_if<mechanics::FemSettings>(&method.settings);
  const bool has_columns =
      std::holds_alternative<mechanics::HalfspaceSettings>(method.settings) ||
      (block != nullptr && !is_full_block(method));
  return has_columns && grid.size() >= least_shared_nodes;
}

} // namespace

bool is_shared_by_ranks(const cases::MethodSpec& method, const Grid& grid,
                        int n_ranks) {
  return n_ranks > 1 && is_for_ranks(method, grid) &&
         obstacle_to_sharing(method, grid, n_ranks).empty();
}

std::string obstacle_to_sharing(const cases::MethodSpec& method,
                                const Grid& grid, int n_ranks) {
  if (!is_for_ranks(method, grid) || n_ranks == 1)
    return "";
  if (method.is_adhesive())
    return "the solver of adhesion works on whole surfaces";
  if (method.border() == mechanics::Border::free)
    return "free boundaries are treated on whole surfaces";
  if (can_share(grid, n_ranks))
    return "";
  return fmt::format("{} rows cannot be divided among {} ranks by multiples of "
                     "{}",
                     grid.points_y, n_ranks, rows_in_cell);
}

bool is_run_by_ranks(const cases::Case& contact_case,
                     const std::vector<cases::MethodSpec>& methods,
                     const Grid& grid, int n_ranks) {
  return std::ranges::any_of(methods, [&](const cases::MethodSpec& method) {
    return is_full_block(method)
               ? n_ranks > 1
               : method.has_fields() &&
                     is_shared_by_ranks(
                         method, pressed_grid(contact_case, method, grid),
                         n_ranks);
  });
}

} // namespace asperity::methods
