#include "studies/key_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::studies {

using cases::Case;
using cases::MethodSpec;
using cases::TableReader;

void check_theory(TableReader& table, const Case& read, bool takes_maps) {
  const bool is_measured =
      read.surface.kind == mechanics::SurfaceKind::measured;
  if (!study_theory(read.surface, read.methods) || (is_measured && !takes_maps))
    table.complain(
        table.node(),
        fmt::format("needs a [theory] whose spectrum is \"formula\"{}, and "
                    "whose loss_factor is \"yang-persson\"",
                    takes_maps ? ", or a measured surface" : ""));
}

void check_ends(TableReader& table, double from, double to) {
  if (from > 0.0 && to > 0.0 && !(from < to))
    table.refuse(table.said_by("to"),
                 "must be above " + table.node().path + ".from");
}

void require_fields(TableReader& table, const Case& read,
                    const std::string& what) {
  if (std::ranges::none_of(read.methods, &MethodSpec::has_fields))
    table.complain(table.node(), "needs a method with a " + what +
                                     ": [halfspace], [fem] or [md]");
}

} // namespace asperity::studies
