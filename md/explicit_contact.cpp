#include "md/explicit_contact.hpp"

#include "base/require.hpp"
#include "cases/case_error.hpp"
#include "md/checkpoint.hpp"
#include "md/dump.hpp"
#include "md/dynamics_run.hpp"
#include "md/explicit_system.hpp"
#include "md/fire.hpp"
#include "md/green_contact.hpp"
#include "md/request_parts.hpp"
#include "md/shown_modulus.hpp"
#include "md/step_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace asperity::md {
namespace {

using cases::AtomMinimizer;
using cases::Control;

constexpr double start_clearance = 4e-10; ///< over the highest rigid atom [m]
constexpr double descent = 0.5e-10;       ///< of a held height, at once [m]
constexpr double descent_tolerance = 0.1; ///< of the balances on the way

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(values.size());
}

void require_supported(const cases::MdSettings& settings) {
  if (settings.engine != cases::AtomEngine::asperity ||
      settings.bulk != cases::AtomBulk::explicit_layers)
    throw cases::CaseError("[md] this block is bulk = \"explicit\" of engine = "
                           "\"asperity\"");
  if (settings.modes != cases::AtomModes::vector)
    throw cases::CaseError("[md] bulk = \"explicit\" moves its atoms in all "
                           "three directions, so modes = \"normal\" is only "
                           "for bulk = \"green\"");
}

/// Statics needs no masses: any will do.
double mass_of(const cases::MdSettings& settings) {
  return settings.minimizer == AtomMinimizer::dynamics ? settings.mass : 1.0;
}

class ExplicitContact final : public AtomicContact {
public:
  explicit ExplicitContact(AtomRequest request);

  AtomStep solve(Control control, double amount, int step,
                 const Watch& watch) override;
  std::string description() const override;

  double shown_contact_modulus() const override { return shown_modulus_; }

  std::vector<double> state() const override { return state_; }

  void restore(std::span<const double> state) override {
    if (state.size() != state_.size())
      refuse_argument("state.size()", static_cast<double>(state.size()),
                      fmt::format("{}", state_.size()));
    state_.assign(state.begin(), state.end());
  }

private:
  double contact_distance() const { return request_.settings.contact_distance; }

  RelaxationSettings settings_for(double contact_force) const;
  std::span<double> heights_of(int level, int layer);
  void raise(double height);
  double contact_force() const;
  int descend_to(double height);
  Relaxation balance(const Load& load, int step, const Watch& watch,
                     TimeAverage& average);
  void judge_average(const Load& load, const TimeAverage& average,
                     AtomStep& result) const;
  void dump(int step, const AtomStep& result) const;
  std::filesystem::path file_of(int step, const char* ending) const;

  AtomRequest request_;
  ExplicitSystem system_;
  std::string label_;
  std::vector<double> state_; ///< of the last sound answer, or from above
  double shown_modulus_;
};

std::string label_of(const AtomRequest& request) {
  const cases::MdSettings& settings = request.settings;
  return Fingerprint()
      .add(std::array{request.youngs_modulus, request.poisson_ratio,
                      settings.interaction_energy,
                      settings.interaction_distance, settings.cutoff,
                      request.layer.length_x, request.layer.length_y})
      .add(fmt::format("{} {} {} {} {} {}", static_cast<int>(settings.lattice),
                       static_cast<int>(settings.potential), settings.levels,
                       settings.layers, request.layer.points_x,
                       request.layer.points_y))
      .add(request.heights)
      .text();
}

ExplicitContact::ExplicitContact(AtomRequest request)
    : request_(std::move(request)),
      system_(
          crystal_of(request_),
          {request_.layer, request_.settings.levels, request_.settings.layers},
          Interface(interaction_of(request_.settings), request_.layer,
                    request_.substrate, request_.heights, request_.threads),
          mass_of(request_.settings), request_.threads),
      label_(label_of(request_)),
      state_(system_.undeformed(
          *std::max_element(request_.heights.begin(), request_.heights.end()) +
          start_clearance)),
      shown_modulus_(md::shown_contact_modulus(crystal_of(request_),
                                               request_.settings.levels,
                                               request_.settings.layers)) {}

/// k_c is what all atoms together meet when each is one pair of force f near
/// r_0 in r^-12: 13 f / r_0 on average. It follows the load.
RelaxationSettings ExplicitContact::settings_for(double contact_force) const {
  RelaxationSettings settings;
  settings.tolerance = request_.settings.tolerance;
  settings.max_evaluations = request_.settings.max_evaluations;
  if (contact_force > 0.0)
    settings.contact_stiffness =
        13.0 * contact_force / request_.settings.interaction_distance;
  return settings;
}

std::span<double> ExplicitContact::heights_of(int level, int layer) {
  const std::size_t n = system_.block().level_grid(level).size();
  return std::span(state_).subspan(
      system_.block().begin_of(level, layer) + 2 * n, n);
}

/// Moves the whole block until its lowest layer is at a mean height.
void ExplicitContact::raise(double height) {
  const double change = height - mean(heights_of(0, 0));
  const BlockShape& shape = system_.block().shape();
  for (int level = 0; level < shape.levels; ++level)
    for (int layer = 0; layer < shape.layers; ++layer)
      for (double& value : heights_of(level, layer))
        value += change;
  state_[system_.block().plate()] += change;
}

/// Of the state as it is, 0 where nothing touches [N].
double ExplicitContact::contact_force() const {
  std::vector<double> forces(system_.size());
  return system_.energy_and_forces(state_, forces).contact_force;
}

/// Brings a held height down in steps that the surface can follow, and up at
/// once. Returns the evaluations it took.
int ExplicitContact::descend_to(double height) {
  int evaluations = 0;
  for (double at = mean(heights_of(0, 0)) - descent; at > height;
       at -= descent) {
    raise(at);
    system_.set_load({Load::Kind::height, at});
    const double force = contact_force();
    ++evaluations;
    if (!(force > 0.0))
      continue;
    RelaxationSettings rough = settings_for(force);
    rough.tolerance = std::max(descent_tolerance, rough.tolerance);
    evaluations += relax(system_, state_, rough).evaluations;
  }
  raise(height);
  return evaluations;
}

Relaxation ExplicitContact::balance(const Load& load, int step,
                                    const Watch& watch, TimeAverage& average) {
  const cases::MdSettings& settings = request_.settings;
  const bool is_held = load.kind == Load::Kind::height;
  const double force =
      is_held ? contact_force() : load.amount * request_.layer.cell_area();
  if (is_held && force == 0.0 && settings.temperature == 0.0) {
    // Nothing touches: the flat block is the answer.
    state_ = system_.undeformed(load.amount);
    Relaxation none;
    none.converged = true;
    return none;
  }
  if (settings.minimizer == AtomMinimizer::automatic ||
      settings.minimizer == AtomMinimizer::lbfgs)
    return relax(system_, state_, settings_for(force), watch);
  if (settings.minimizer == AtomMinimizer::fire)
    return relax_by_fire(system_, state_, settings_for(force), watch);

  DynamicsRun run;
  // Another seed a load step: its kicks are not the last one's again.
  run.dynamics = {settings.time_step, settings.damping, settings.temperature,
                  settings.seed +
                      0x9E3779B97F4A7C15U * static_cast<std::uint64_t>(step),
                  request_.threads};
  run.duration = settings.duration;
  run.tolerance = settings.tolerance;
  run.label = fmt::format("{} {}", label_, step);
  if (!request_.scratch.empty())
    run.checkpoint = file_of(step, "motion");
  const DynamicsOutcome outcome =
      run_dynamics(system_, load, state_, run, watch);
  average = outcome.average;
  return outcome.relaxation;
}

AtomStep ExplicitContact::solve(Control control, double amount, int step,
                                const Watch& watch) {
  if (control == Control::nominal_pressure)
    require_positive("nominal pressure", amount, "Pa");
  const std::vector<double> before = state_;
  AtomStep result;
  Load load{Load::Kind::nominal_pressure, amount};
  if (control == Control::mean_gap) {
    load = {Load::Kind::height, amount + contact_distance()};
    result.evaluations = descend_to(load.amount) + 1;
  }
  system_.set_load(load);

  TimeAverage average;
  const Relaxation relaxation = balance(load, step, watch, average);
  result.evaluations += relaxation.evaluations;
  result.residual = relaxation.residual;
  const bool is_hot = average.samples > 0;
  read_step(system_, is_hot ? average.state : state_,
            is_hot ? average.normal_forces : normal_forces(system_, state_),
            {contact_distance(), close_distance(request_.settings)}, result);
  const std::string fault = fault_of(result.inspection, request_.layer.size());
  result.note = fault.empty() ? relaxation.note : fault;
  result.converged = relaxation.converged && fault.empty();
  if (is_hot)
    judge_average(load, average, result);
  if (request_.settings.dump)
    dump(step, result);
  if (!fault.empty() || !std::isfinite(relaxation.energy))
    state_ = before;
  return result;
}

void ExplicitContact::judge_average(const Load& load,
                                    const TimeAverage& average,
                                    AtomStep& result) const {
  result.residual = load.kind == Load::Kind::nominal_pressure
                        ? std::abs(result.nominal_pressure / load.amount - 1.0)
                        : 0.0;
  result.interface_energy = average.interface_energy / request_.layer.area();
  if (result.converged)
    result.note = fmt::format(
        "mean over {} samples at {:.4g} K: the nominal pressure fluctuates by "
        "{:.3g} Pa, the mean height by {:.3g} m",
        average.samples, request_.settings.temperature,
        average.force_spread / request_.layer.cell_area(),
        average.height_spread);
}

void ExplicitContact::dump(int step, const AtomStep& result) const {
  std::vector<AtomGroup> groups{
      substrate_atoms(request_.substrate, request_.heights),
      contact_atoms(system_, state_, result.pressure)};
  for (AtomGroup& group : inner_atoms(system_.block(), state_))
    groups.push_back(std::move(group));
  write_atoms(file_of(step, "xyz"), request_.layer, groups);
}

std::filesystem::path ExplicitContact::file_of(int step,
                                               const char* ending) const {
  return request_.scratch / fmt::format("step-{:04}.{}", step, ending);
}

std::string ExplicitContact::description() const {
  constexpr std::array lattices = {"isotropic", "born", "central"};
  const BlockShape& shape = system_.block().shape();
  return fmt::format(
      "{} lattice, {} x {} atoms, explicit: {} {} of {} layers, {:.4g} m deep, "
      "{} free atoms; E* shown at q a = 0.1: {:.5g} Pa",
      lattices[static_cast<std::size_t>(request_.settings.lattice)],
      shape.layer.points_x, shape.layer.points_y, shape.levels,
      shape.levels == 1 ? "level" : "levels", shape.layers,
      system_.block().depth(), system_.size() / 3, shown_modulus_);
}

} // namespace

std::unique_ptr<AtomicContact> make_explicit_contact(AtomRequest request) {
  require_supported(request.settings);
  return std::make_unique<ExplicitContact>(std::move(request));
}

} // namespace asperity::md
