#include "methods/sharing.hpp"

#include "methods/chosen.hpp"
#include "methods/surfaces_of_case.hpp"
#include "ranks/workers.hpp"
#include "surfaces/build.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::methods {
namespace {

/// Whether a method has an operator, and its grid a size, that ranks share.
bool is_for_ranks(const cases::MethodSpec& method, const Grid& grid) {
  const auto* half =
      std::get_if<mechanics::HalfspaceSettings>(&method.settings);
  const auto* block = std::get_if<mechanics::FemSettings>(&method.settings);
  const bool has_columns =
      half != nullptr || (block != nullptr && !is_full_block(method));
  return has_columns && grid.size() >= least_shared_nodes;
}

} // namespace

bool is_shared_by_ranks(const cases::MethodSpec& method, const Grid& grid,
                        int n_ranks) {
  return n_ranks > 1 && is_for_ranks(method, grid) && !method.is_adhesive() &&
         n_ranks <= most_ranks(grid);
}

std::string obstacle_to_sharing(const cases::MethodSpec& method,
                                const Grid& grid, int n_ranks) {
  if (!is_for_ranks(method, grid) || n_ranks == 1)
    return "";
  if (method.is_adhesive())
    return "the solver of adhesion works on whole surfaces";
  if (n_ranks <= most_ranks(grid))
    return "";
  return fmt::format("a grid of {} by {} points can be divided among at most "
                     "{} rank{}",
                     grid.points_x, grid.points_y, most_ranks(grid),
                     most_ranks(grid) == 1 ? "" : "s");
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

bool has_surfaces_by_rows(const cases::Case& contact_case,
                          const std::vector<cases::MethodSpec>& methods,
                          int n_ranks) {
  const auto has_fields = [](const cases::MethodSpec& method) {
    return method.has_fields();
  };
  if (n_ranks == 1 || std::ranges::none_of(methods, has_fields))
    return false;
  const Grid grid = surfaces::surface_grid(contact_case.surface);
  return std::ranges::all_of(methods, [&](const cases::MethodSpec& method) {
    return !method.has_fields() ||
           (n_ranks <= most_ranks(grid) &&
            is_shared_by_ranks(method, pressed_grid(contact_case, method, grid),
                               n_ranks));
  });
}

} // namespace asperity::methods
