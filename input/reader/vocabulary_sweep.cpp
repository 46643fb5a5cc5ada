// The row of [sweep].
#include "input/reader/bound_key.hpp"

namespace asperity::cases {

Table case_sweep_table() {
  return {.name = "sweep",
          .when = "Optional.",
          .description =
              "Parameter sweep: this file describes many cases, its points "
              "(docs/reference/sweeps.md). Every other key names a key of the "
              "case with its table, in quotes, and lists its values: "
              "\"surface.hurst\" = [0.5, 0.7, 0.9].",
          .keys = {
              key("combine", {"product", "zip"},
                  "Points: every value of each key with every value of the "
                  "others, or the lists side by side.",
                  or_else("\"product\"")),
          }};
}

} // namespace asperity::cases
