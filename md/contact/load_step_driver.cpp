#include "md/contact/load_step_driver.hpp"

#include "base/field_sums.hpp"
#include "base/require.hpp"
#include "md/contact/request_parts.hpp"
#include "md/contact/step_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace asperity::md {
namespace {

using mechanics::Control;

constexpr double descent = 0.5e-10;       ///< largest decrease of the height
                                          ///< per step [m]
constexpr double descent_tolerance = 0.1; ///< tolerance of intermediate steps

void add_effort(const Relaxation& more, Relaxation& sum) {
  sum.evaluations += more.evaluations;
  sum.linearisations += more.linearisations;
  sum.products += more.products;
}

} // namespace

LoadStepDriver::LoadStepDriver(AtomRequest request)
    : request_(std::move(request)) {}

void LoadStepDriver::start() {
  state_ = system().undeformed(*std::ranges::max_element(request_.heights) +
                               start_clearance);
}

void LoadStepDriver::restore(std::span<const double> state) {
  if (state.size() != state_.size())
    refuse_argument("state.size()", static_cast<double>(state.size()),
                    fmt::format("{}", state_.size()));
  state_.assign(state.begin(), state.end());
}

/// Returns the settings of the minimiser. The contact stiffness k_c is the mean
/// stiffness of all atoms if each interacts through one pair with force f at r
/// close to r_0 and a repulsion r^-12, i.e. 13 f / r_0. It therefore scales
/// with the load.
RelaxationSettings LoadStepDriver::settings_for(double contact_force) const {
  RelaxationSettings settings;
  settings.tolerance = request_.settings.tolerance;
  settings.max_evaluations = request_.settings.max_evaluations;
  if (contact_force > 0.0)
    settings.contact_stiffness =
        13.0 * contact_force / request_.settings.interaction_distance;
  return settings;
}

/// Translates the block so that its lowest layer has the given mean height.
void LoadStepDriver::raise_to(double height) {
  const std::vector<double> translation =
      system().undeformed(height - mean(layer_of(system(), state_).z));
  std::ranges::transform(state_, translation, state_.begin(), std::plus<>());
}

/// Returns the contact force of the present state [N], which is 0 without
/// contact.
double LoadStepDriver::contact_force() {
  std::vector<double> forces(system().size());
  return system().energy_and_forces(state_, forces).contact_force;
}

/// Lowers the block to a prescribed height in steps that the surface can
/// follow, or raises it in one step. Returns the number of evaluations used.
Relaxation LoadStepDriver::descend_to(double height) {
  const double start = mean(layer_of(system(), state_).z);
  Relaxation taken;
  for (double at = start - descent; at > height; at -= descent) {
    raise_to(at);
    system().set_load({Load::Kind::height, at});
    const double force = contact_force();
    ++taken.evaluations;
    if (!(force > 0.0))
      continue;
    RelaxationSettings rough = settings_for(force);
    rough.tolerance = std::max(descent_tolerance, rough.tolerance);
    add_effort(approach(state_, rough), taken);
  }
  raise_to(height);
  return taken;
}

LoadStepDriver::Balance LoadStepDriver::balance_at(const Load& load, int step,
                                                   const Watch& watch) {
  if (load.kind == Load::Kind::nominal_pressure) {
    system().set_load(load);
    return balance(load, step, state_,
                   settings_for(load.amount * request_.layer.cell_area()),
                   watch);
  }
  Relaxation before = descend_to(load.amount);
  ++before.evaluations; // for the force below
  system().set_load(load);
  const double force = contact_force();
  Balance found;
  if (force == 0.0 && request_.settings.temperature == 0.0) {
    // Without contact, the undeformed block is the solution.
    state_ = system().undeformed(load.amount);
    found.relaxation.converged = true;
  } else {
    found = balance(load, step, state_, settings_for(force), watch);
  }
  add_effort(before, found.relaxation);
  return found;
}

AtomStep LoadStepDriver::solve(const mechanics::LoadTarget& target, int step,
                               const Watch& watch) {
  Load load{Load::Kind::nominal_pressure, target.amount};
  if (target.control == Control::nominal_pressure)
    require_positive("nominal pressure", target.amount, "Pa");
  else
    load = {Load::Kind::height,
            target.amount + request_.settings.contact_distance};

  const std::vector<double> before = state_;
  const auto [relaxation, average] = balance_at(load, step, watch);
  AtomStep result;
  result.evaluations = relaxation.evaluations;
  result.linearisations = relaxation.linearisations;
  result.products = relaxation.products;
  result.residual = relaxation.residual;
  const bool is_average = average.samples > 0;
  read_step(
      system(), is_average ? average.state : state_,
      is_average ? average.normal_forces : normal_forces(system(), state_),
      {request_.settings.contact_distance, close_distance(request_.settings)},
      result);
  const std::string fault =
      invalidity_reason(result.inspection, request_.layer.size());
  result.note = fault.empty() ? relaxation.note : fault;
  result.converged = relaxation.converged && fault.empty();
  // |sum r| <= sqrt(M) |r| of the M atoms that move, with the root mean square
  // |r|/sqrt(3 M).
  result.pressure_tolerance =
      request_.settings.tolerance * static_cast<double>(state_.size()) /
      std::sqrt(3.0) / static_cast<double>(result.pressure.size()) *
      mean_size(result.pressure);
  result.gap_tolerance = gap_accuracy * request_.settings.contact_distance;
  if (is_average)
    read_average(load, average, result);
  if (request_.settings.dump) {
    std::vector<AtomGroup> groups = block_atoms(state_, result);
    groups.insert(groups.begin(),
                  substrate_atoms(request_.substrate, request_.heights));
    write_atoms(file_of(step, "xyz"), request_.layer, groups);
  }
  if (!fault.empty() || !std::isfinite(relaxation.energy))
    state_ = before;
  return result;
}

void LoadStepDriver::read_average(const Load& load, const TimeAverage& average,
                                  AtomStep& result) const {
  result.residual = load.kind == Load::Kind::nominal_pressure
                        ? std::abs(result.nominal_pressure / load.amount - 1.0)
                        : 0.0;
  result.pressure_tolerance = average.force_spread / request_.layer.cell_area();
  result.gap_tolerance = std::max(result.gap_tolerance, average.height_spread);
  result.interface_energy = average.interface_energy / request_.layer.area();
  if (result.converged)
    result.note = fmt::format(
        "mean over {} samples at {:.4g} K: the nominal pressure fluctuates by "
        "{:.3g} Pa, the mean height by {:.3g} m",
        average.samples, request_.settings.temperature,
        average.force_spread / request_.layer.cell_area(),
        average.height_spread);
}

std::filesystem::path LoadStepDriver::file_of(int step,
                                              const char* ending) const {
  return request_.scratch / fmt::format("step-{:04}.{}", step, ending);
}

} // namespace asperity::md
