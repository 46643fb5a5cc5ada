#include "studies/flow/flow.hpp"

#include "base/shown_number.hpp"
#include "fem/plugin.hpp"
#include "input/reader/bound_key.hpp"
#include "mechanics/flow/effective_medium.hpp"
#include "mechanics/flow/reynolds.hpp"
#include "results/observables/row_observer.hpp"
#include "studies/key_checks.hpp"
#include "theory/persson/leakage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace asperity::studies {
namespace {

using cases::at_least;
using cases::Case;
using cases::Dimension;
using cases::eg;
using cases::key;
using cases::MethodSpec;
using cases::needed;
using cases::TableReader;
using Flow = FlowStudy;

flow::NetworkSolution solved(const flow::Network& network) {
  return fem::load_fem_module().solved_network(network);
}

/// Calls `add`, and says in the note of the row if that fails.
template <class Add>
void try_to_add(results::CurvePoint& row, const Add& add) {
  try {
    add();
  } catch (const std::exception& failure) {
    row.add_note(std::string("no flow: ") + failure.what());
  }
}

/// The gaps u_1 that open between magnifications, and their shares of the
/// nominal area, Eqs. (25) and (27).
struct OpeningGaps {
  std::vector<double> gaps, shares;
};

OpeningGaps opening_gaps(const theory::MagnifiedContact& contact) {
  constexpr int intervals = 200;
  // Of a spectrum of shells, the first and the last one are between them.
  constexpr double beyond = 1e-9;
  const double lowest = contact.lowest_magnification() * (1.0 - beyond);
  const double ratio =
      contact.highest_magnification() * (1.0 + beyond) / lowest;
  const auto magnification = [&](int i) {
    return lowest * std::pow(ratio, static_cast<double>(i) / intervals);
  };
  OpeningGaps opening;
  for (int i = 0; i < intervals; ++i) {
    const double from = magnification(i), to = magnification(i + 1);
    const double share =
        contact.area_fraction(from) - contact.area_fraction(to);
    if (!(share > 0.0))
      continue;
    opening.shares.push_back(share);
    opening.gaps.push_back(contact.opening_gap(from, to));
  }
  return opening;
}

constexpr int most_points = 256; // of a side of a table

/// The flux |q| over its mean and the narrowest place of one saved map, for
/// flow along x: averaged over squares of nodes if a side has more than 256.
/// @param nodes  grid.size(), with their gaps
/// @return  "flow-<method>" with the columns x, y [m], flux [1] and is_critical
///          [1]; without rows if the map is sealed
results::Table flow_map_table(const std::string& method, const Grid& grid,
                              const mechanics::ContactNodes& nodes,
                              mechanics::Border border) {
  const flow::GapFlow flow = flow::flow_through(
      grid, nodes.open_gaps(), flow::Direction::x, border, solved, true);
  results::Table table{
      "flow-" + method,
      fmt::format("Flux along x through the gap of {}, "
                  "narrowest at {}",
                  method, quantity_text(flow.critical_gap, "m", 3)),
      {{"x", "m"}, {"y", "m"}, {"flux", "1"}, {"is_critical", "1"}}};
  const int side =
      (std::max(grid.points_x, grid.points_y) - 1) / most_points + 1;
  for (int iy = 0; flow.percolates && iy < grid.points_y; iy += side)
    for (int ix = 0; ix < grid.points_x; ix += side) {
      const int end_x = std::min(ix + side, grid.points_x);
      const int end_y = std::min(iy + side, grid.points_y);
      double sum = 0.0;
      for (int jy = iy; jy < end_y; ++jy)
        for (int jx = ix; jx < end_x; ++jx)
          sum += flow.flux[grid.index(jx, jy)];
      const bool is_critical = flow.critical_x / side == ix / side &&
                               flow.critical_y / side == iy / side;
      table.add({0.5 * (ix + end_x - 1) * grid.spacing_x(),
                 0.5 * (iy + end_y - 1) * grid.spacing_y(),
                 sum / ((end_x - ix) * (end_y - iy)), is_critical ? 1.0 : 0.0});
    }
  return table;
}

/// Keeps the rows of a flow map that are on the user's map. The narrowest place
/// is in its mirror images, too, and is marked on the map.
void keep_user_map(const Grid& cell, const results::MapInCell& in_cell,
                   results::Table& table) {
  const Grid map = in_cell.grid(cell);
  if (map == cell || table.columns.front().values.empty())
    return;
  const auto folded = [](double place, double spacing, double length) {
    return std::min(place, length - spacing - place); // node i and n - 1 - i
  };
  const std::vector<double> x = table.values("x"), y = table.values("y"),
                            critical = table.values("is_critical");
  std::vector<std::size_t> kept;
  std::array<double, 2> narrowest{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < map.length_x - 0.5 * cell.spacing_x() &&
        y[i] < map.length_y - 0.5 * cell.spacing_y())
      kept.push_back(i);
    if (critical[i] > 0.0)
      narrowest = {folded(x[i], cell.spacing_x(), cell.length_x),
                   folded(y[i], cell.spacing_y(), cell.length_y)};
  }
  const auto distance = [&](std::size_t i) {
    return std::hypot(x[i] - narrowest[0], y[i] - narrowest[1]);
  };
  const std::size_t nearest = *std::ranges::min_element(kept, {}, distance);
  for (results::Column& column : table.columns) {
    std::vector<double> values;
    values.reserve(kept.size());
    for (const std::size_t i : kept)
      values.push_back(column.name != "is_critical" ? column.values[i]
                       : i == nearest               ? 1.0
                                                    : 0.0);
    column.values = std::move(values);
  }
}

/// Adds to the row of a step the flow through its gap along x and y.
void evaluate_flow(const Step& step, results::CurvePoint& row) {
  try_to_add(row, [&] {
    const std::vector<double> gap = step.nodes.open_gaps();
    const mechanics::Border border = step.method.border();
    const Grid& grid = step.grid;
    for (const bool is_y : {false, true}) {
      const flow::GapFlow found = flow::flow_through(
          grid, gap, is_y ? flow::Direction::y : flow::Direction::x, border,
          solved);
      const double length_over_width =
          is_y ? grid.length_y / grid.length_x : grid.length_x / grid.length_y;
      row[columns::flow_factor.along(is_y)] = found.flow_factor;
      row[columns::flow_conductance.along(is_y)] =
          found.conductance * length_over_width;
      row[columns::critical_gap.along(is_y)] = found.critical_gap;
    }
    row[columns::effective_medium] = flow::effective_medium(gap);
  });
}

/// Adds the flow of the theory to its row: that of the effective medium with
/// the distribution of u_1, Eq. (27) of Yang and Persson (2008), and u_1 where
/// the open area percolates (theory/persson/leakage.hpp). Where u_1 is not
/// determined, the note of the row says why.
void evaluate_flow_of_theory(const cases::Case& contact_case,
                             const theory::PerssonContact& contact,
                             results::CurvePoint& row) {
  if (row.status != results::StepStatus::converged)
    return;
  const FlowStudy& study = *contact_case.study<FlowStudy>();
  try_to_add(row, [&] {
    constexpr double any_wavevector = 1.0;
    const theory::MagnifiedContact magnified(contact, row.nominal_pressure,
                                             any_wavevector);
    const OpeningGaps opening = opening_gaps(magnified);
    row[columns::effective_medium] =
        flow::effective_medium(opening.gaps, opening.shares);
    const double medium = row[columns::effective_medium];
    const theory::Leak leak =
        theory::leakage(magnified, {0.0, study.viscosity}, study.pressure_drop);
    results::RowObserver observe(row);
    for (const bool is_y : {false, true}) {
      row[columns::flow_conductance.along(is_y)] = medium;
      row[columns::critical_gap.along(is_y)] = leak.pore_gap;
      observe(columns::flow_factor.along(is_y), [&] {
        return results::Observed{medium / std::pow(row.mean_gap, 3.0),
                                 "the mean gap is too small for a number"};
      });
    }
  });
}

/// Q = K Dp/(12 eta) W/L, where K is the flow conductance of a square.
void set_leak_rates(const cases::Case& contact_case, results::CurvePoint& row) {
  const FlowStudy& study = *contact_case.study<FlowStudy>();
  const double rate =
      study.pressure_drop / (12.0 * study.viscosity) * study.aspect();
  for (const bool is_y : {false, true})
    row[columns::leak_rate.along(is_y)] =
        row[columns::flow_conductance.along(is_y)] * rate;
}

/// The flux through the gap of a saved step, on the user's map; nothing if it
/// is sealed.
std::optional<results::Table> flow_map(const Step& step,
                                       const results::MapInCell& map) {
  results::Table table = flow_map_table(step.method.name, step.grid, step.nodes,
                                        step.method.border());
  if (table.columns.front().values.empty())
    return std::nullopt;
  keep_user_map(step.grid, map, table);
  return table;
}

cases::Table keys_of_flow() {
  return {
      .name = "flow",
      .when = "Optional; needs a method with a gap.",
      .description =
          "The flow of a fluid through the gap of each load step, by Reynolds' "
          "equation (docs/numerics/flow.md), along x and along y.",
      .keys = {
          key<&Flow::viscosity>("viscosity", Dimension::viscosity,
                                "Viscosity of the fluid.", needed("1 mPa s")),
          key<&Flow::pressure_drop>(
              "pressure_drop", {Dimension::pressure, at_least(0.0)},
              "Pressure drop across the seal.", needed("10 kPa")),
          key<&Flow::length>("length", Dimension::length,
                             "Length of the seal along the flow.",
                             eg("5 mm", "default: that of a square")),
          key<&Flow::width>("width", Dimension::length,
                            "Width of the seal across the flow.",
                            eg("100 mm", "default: that of a square")),
      }};
}

void read_flow(TableReader table, Case& read) {
  FlowStudy study;
  table.read(study);
  require_fields(table, read, "gap");
  if (study.length.has_value() != study.width.has_value())
    table.complain_missing(study.length ? "width" : "length",
                           ": a seal has both");
  read.studies.ask(study);
}

std::string no_flow(const Case&, const MethodSpec& method) {
  const auto* const theory =
      std::get_if<mechanics::TheorySettings>(&method.settings);
  return theory != nullptr &&
                 theory->loss_factor != mechanics::LossFactor::yang_persson
             ? "needs loss_factor = \"yang-persson\""
             : "";
}

/// The numbers of [flow] scale the answer.
std::string flow_key(const cases::Case&) {
  return "\nflow";
}

const cases::StudyKeys& flow_keys() {
  static const cases::StudyKeys keys{
      .tables = {keys_of_flow()},
      .read = read_flow,
      .is_asked = asks<FlowStudy>,
      .questions = {{"[flow]",
                     {"flow_factor_x", "flow_factor_y", "flow_conductance_x",
                      "flow_conductance_y", "critical_gap_x", "critical_gap_y",
                      "leak_rate_x", "leak_rate_y", "effective_medium"},
                     asks<FlowStudy>,
                     no_flow}},
      .step_key = flow_key};
  return keys;
}

} // namespace

const Study flow_study{.keys = flow_keys,
                       .pages = flow_pages,
                       .evaluate = evaluate_flow,
                       .evaluate_theory = evaluate_flow_of_theory,
                       .rescale = set_leak_rates,
                       .map_table = flow_map,
                       .memory = 430.0}; // in both directions

} // namespace asperity::studies
