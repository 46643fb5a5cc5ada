// A program for several ranks: a map that rank 0 can read only in part is an
// exception on all ranks, after which they find the stress under another map.
// Exit code 1 with a sentence if not.
#include "fem/plugin.hpp"
#include "input/input_error.hpp"
#include "methods/stress_section.hpp"

#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace asperity::program {
namespace {

constexpr std::size_t side = 512; // points
const Grid grid{side, side, 1e-3, 1e-3};

/// A wave of pressure, stored; rows from `readable` on cannot be read, and none
/// on other ranks than rank 0.
results::Fields stored_map(std::size_t readable) {
  results::Fields map;
  map.nominal_pressure = 1e6;
  map.grid = grid;
  map.stored_pressure = {
      side, side, [readable](std::size_t first, std::size_t count) {
        if (first + count > readable)
          throw input::InputError("the map ends");
        std::vector<double> rows(side * count);
        for (std::size_t i = 0; i < rows.size(); ++i)
          rows[i] =
              1e6 * (1.0 + std::cos(2.0 * std::numbers::pi *
                                    static_cast<double>(i % side) / side));
        return rows;
      }};
  return map;
}

std::string failure_of(const methods::StressUnderMaps& stress,
                       const results::Fields& map) {
  try {
    static_cast<void>(stress.strongest(map));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

int fail(const std::string& words) {
  std::fprintf(stderr, "%s\n", words.c_str());
  return 1;
}

int run_test() {
  ProgramRanks& ranks = fem::load_fem_module().rank_group();
  const bool is_root = ranks.rank() == 0;
  mechanics::ElasticBlock block;
  block.contact_modulus = 1e9;
  block.poisson_ratio = 0.3;
  block.thickness = std::numeric_limits<double>::infinity();
  const methods::StressUnderMaps stress(block, 1, &ranks);

  // The rows of rank 0 can be read, those of the others cannot.
  for (const std::size_t readable : {side / 2, std::size_t{0}})
    if (const std::string found =
            failure_of(stress, stored_map(is_root ? readable : 0));
        found != (is_root ? "the map ends" : "rank 0 could not read the field"))
      return fail("instead of the failure to read: " + found);

  const double alone = methods::StressUnderMaps(block)
                           .strongest(stored_map(side))
                           .peak.von_mises;
  const double found =
      stress.strongest(stored_map(is_root ? side : 0)).peak.von_mises;
  return found == alone ? 0 : fail("another stress than that of one process");
}

} // namespace
} // namespace asperity::program

int main() {
  return asperity::program::run_test();
}
