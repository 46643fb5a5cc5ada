// The keys of [spots] in a case.
#include "input/reader/bound_key.hpp"
#include "studies/key_checks.hpp"
#include "studies/spots/spots.hpp"
#include "studies/spots/spots_study.hpp"

#include <fmt/format.h>

namespace asperity::studies {
namespace {

using cases::between;
using cases::Case;
using cases::key;
using cases::TableReader;
using Spots = SpotsStudy;

cases::Table keys_of_spots() {
  return {
      .name = "spots",
      .when = "Optional; needs a method with a contact map.",
      .description =
          "The spots of contact of each load step, and the connected parts of "
          "its gap (docs/numerics/conductance.md): their number, the largest, "
          "whether they percolate, and the dimension by area and perimeter.",
      .keys = {
          key<&Spots::smallest>(
              "smallest", between(1, 1000000),
              "Nodes of the smallest cluster that counts in a dimension."),
      }};
}

void read_spots(TableReader table, Case& read) {
  SpotsStudy study;
  table.read(study);
  require_fields(table, read, "contact map");
  read.studies.ask(study);
}

std::string spots_key(const cases::Case& contact_case) {
  return fmt::format("\nspots {}", contact_case.study<SpotsStudy>()->smallest);
}

} // namespace

const cases::StudyKeys& spots_keys() {
  static const cases::StudyKeys keys{
      .tables = {keys_of_spots()},
      .read = read_spots,
      .is_asked = asks<SpotsStudy>,
      .questions = {{"[spots]",
                     {"spot_count", "largest_spot", "spots_percolate_x",
                      "spots_percolate_y", "spot_radii", "gap_count",
                      "largest_gap", "gap_percolates_x", "gap_percolates_y"},
                     asks<SpotsStudy>,
                     cases::no_map}},
      .step_key = spots_key};
  return keys;
}

} // namespace asperity::studies
