#include "run/flow_of_step.hpp"

#include "fem/plugin.hpp"
#include "flow/effective_medium.hpp"
#include "flow/reynolds.hpp"
#include "results/observables/row_observer.hpp"
#include "results/types/study_columns.hpp"
#include "theory/persson/leakage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <vector>

namespace asperity::run {
namespace {

flow::NetworkSolution solved(const flow::Network& network) {
  return fem::load_fem_module().solved_network(network);
}

/// Calls `add`, and says in the note of the row if that fails.
template <class Add>
void try_to_add(results::CurvePoint& row, const Add& add) {
  try {
    add();
  } catch (const std::exception& failure) {
    row.note += (row.note.empty() ? "" : "; ") + std::string("no flow: ") +
                failure.what();
  }
}

/// The gaps u_1 that open between magnifications, and their shares of the
/// nominal area, Eqs. (25) and (27).
struct OpeningGaps {
  std::vector<double> gaps, shares;
};

OpeningGaps opening_gaps(const theory::MagnifiedContact& contact) {
  constexpr int intervals = 200;
  const double ratio =
      contact.highest_magnification() / contact.lowest_magnification();
  const auto magnification = [&](int i) {
    return contact.lowest_magnification() *
           std::pow(ratio, static_cast<double>(i) / intervals);
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

} // namespace

results::Table flow_map_table(const std::string& method, const Grid& grid,
                              const mechanics::ContactNodes& nodes,
                              mechanics::Border border) {
  const flow::GapFlow flow = flow::flow_through(
      grid, nodes.open_gaps(), flow::Direction::x, border, solved, true);
  results::Column x{"x", "m", {}}, y{"y", "m", {}}, flux{"flux", "1", {}},
      critical{"is_critical", "1", {}};
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
      x.values.push_back(0.5 * (ix + end_x - 1) * grid.spacing_x());
      y.values.push_back(0.5 * (iy + end_y - 1) * grid.spacing_y());
      flux.values.push_back(sum / ((end_x - ix) * (end_y - iy)));
      critical.values.push_back(flow.critical_x / side == ix / side &&
                                        flow.critical_y / side == iy / side
                                    ? 1.0
                                    : 0.0);
    }
  return {"flow-" + method,
          fmt::format("Flux along x through the gap of {}, narrowest at "
                      "{:.3g} nm",
                      method, flow.critical_gap * 1e9),
          {x, y, flux, critical}};
}

void add_flow(const cases::FlowStudy& study, const cases::MethodSpec& method,
              double rms_height, methods::StepAnswer& answer) {
  results::CurvePoint& row = answer.row;
  if (row.status != results::StepStatus::converged || answer.gap.empty())
    return;
  const std::vector<double> gap =
      mechanics::ContactNodes(method.contact_criterion(rms_height),
                              answer.pressure, answer.gap)
          .open_gaps();
  const mechanics::Border border = method.border();
  try_to_add(row, [&] {
    const Grid& grid = answer.grid;
    const flow::GapFlow x =
        flow::flow_through(grid, gap, flow::Direction::x, border, solved);
    const flow::GapFlow y =
        flow::flow_through(grid, gap, flow::Direction::y, border, solved);
    row[columns::flow_factor_x] = x.flow_factor;
    row[columns::flow_factor_y] = y.flow_factor;
    row[columns::flow_conductance_x] =
        x.conductance * grid.length_x / grid.length_y;
    row[columns::flow_conductance_y] =
        y.conductance * grid.length_y / grid.length_x;
    row[columns::critical_gap_x] = x.critical_gap;
    row[columns::critical_gap_y] = y.critical_gap;
    row[columns::effective_medium] = flow::effective_medium(gap);
    set_leak_rates(study, row);
  });
}

void add_flow(const cases::FlowStudy& study,
              const theory::PerssonContact& contact, results::CurvePoint& row) {
  if (row.status != results::StepStatus::converged)
    return;
  try_to_add(row, [&] {
    constexpr double any_wavevector = 1.0;
    const theory::MagnifiedContact magnified(contact, row.nominal_pressure,
                                             any_wavevector);
    const OpeningGaps opening = opening_gaps(magnified);
    row[columns::effective_medium] =
        flow::effective_medium(opening.gaps, opening.shares);
    row[columns::flow_conductance_x] = row[columns::flow_conductance_y] =
        row[columns::effective_medium];
    results::RowObserver observe(row);
    for (const char* const factor : {"flow_factor_x", "flow_factor_y"})
      observe(factor, [&] {
        return results::Observed{row[columns::effective_medium] /
                                     std::pow(row.mean_gap, 3.0),
                                 "the mean gap is too small for a number"};
      });
    row[columns::critical_gap_x] = row[columns::critical_gap_y] =
        theory::leakage(magnified, {0.0, study.viscosity}, study.pressure_drop)
            .pore_gap;
    set_leak_rates(study, row);
  });
}

void set_leak_rates(const cases::FlowStudy& study, results::CurvePoint& row) {
  const double rate =
      study.pressure_drop / (12.0 * study.viscosity) * study.aspect();
  row[columns::leak_rate_x] = row[columns::flow_conductance_x] * rate;
  row[columns::leak_rate_y] = row[columns::flow_conductance_y] * rate;
}

} // namespace asperity::run
