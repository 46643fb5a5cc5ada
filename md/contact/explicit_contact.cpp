#include "md/contact/explicit_contact.hpp"

#include "input/input_error.hpp"
#include "md/contact/dump.hpp"
#include "md/contact/explicit_system.hpp"
#include "md/contact/load_step_driver.hpp"
#include "md/contact/request_parts.hpp"
#include "md/dynamics/checkpoint.hpp"
#include "md/dynamics/dynamics_run.hpp"
#include "md/lattice/effective_modulus.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace asperity::md {
namespace {

using mechanics::AtomMinimizer;

void require_explicit_bulk(const mechanics::MdSettings& settings) {
  if (settings.engine != mechanics::AtomEngine::asperity ||
      settings.bulk != mechanics::AtomBulk::explicit_layers)
    throw input::InputError(
        "[md] this block needs engine = \"asperity\" and bulk = \"explicit\"");
  if (settings.modes != mechanics::AtomModes::vector)
    throw input::InputError(
        "[md] modes = \"normal\" is available only with bulk = \"green\": the "
        "atoms of bulk = \"explicit\" move in all three directions");
}

/// Returns the mass of an atom. Minimisers do not depend on it, so any value
/// will do for them.
double mass_of(const mechanics::MdSettings& settings) {
  return settings.minimizer == AtomMinimizer::dynamics ? settings.mass : 1.0;
}

class ExplicitContact final : public LoadStepDriver {
public:
  explicit ExplicitContact(AtomRequest given);

  std::string description() const override;

  double effective_contact_modulus() const override {
    return effective_modulus_;
  }

private:
  System& system() override { return system_; }

  const System& system() const override { return system_; }

  Relaxation approach(std::vector<double>& state,
                      const RelaxationSettings& settings) override;
  Balance balance(const Load& load, int step, std::vector<double>& state,
                  const RelaxationSettings& settings,
                  const Watch& watch) override;
  std::vector<AtomGroup> block_atoms(std::span<const double> state,
                                     const AtomStep& step) const override;

  ExplicitSystem system_;
  std::string label_;
  double effective_modulus_;
};

std::string label_of(const AtomRequest& request) {
  const mechanics::MdSettings& settings = request.settings;
  const std::array numbers = {request.youngs_modulus,
                              request.poisson_ratio,
                              settings.interaction_energy,
                              settings.interaction_distance,
                              settings.cutoff,
                              request.layer.length_x,
                              request.layer.length_y};
  return fingerprint(
      fmt::format("{} {} {} {} {} {}", static_cast<int>(settings.lattice),
                  static_cast<int>(settings.potential), settings.levels,
                  settings.layers, request.layer.points_x,
                  request.layer.points_y),
      {numbers, request.heights});
}

ExplicitContact::ExplicitContact(AtomRequest given)
    : LoadStepDriver(std::move(given)),
      system_(crystal_of(request()),
              {request().layer, request().settings.levels,
               request().settings.layers},
              Interface(interaction_of(request().settings), request().layer,
                        request().substrate, request().heights,
                        request().threads),
              mass_of(request().settings), request().threads),
      label_(label_of(request())),
      effective_modulus_(md::effective_contact_modulus(
          crystal_of(request()), request().settings.levels,
          request().settings.layers)) {
  start();
}

Relaxation ExplicitContact::approach(std::vector<double>& state,
                                     const RelaxationSettings& settings) {
  return relax(system_, state, settings);
}

LoadStepDriver::Balance
ExplicitContact::balance(const Load& load, int step, std::vector<double>& state,
                         const RelaxationSettings& settings,
                         const Watch& watch) {
  const mechanics::MdSettings& asked = request().settings;
  if (asked.minimizer != AtomMinimizer::dynamics)
    return {relax(system_, state, settings, watch), {}};

  DynamicsRun run;
  // Each load step has its own seed, so that random numbers are not repeated.
  run.dynamics = {asked.time_step, asked.damping, asked.temperature,
                  asked.seed +
                      0x9E3779B97F4A7C15U * static_cast<std::uint64_t>(step),
                  request().threads};
  run.duration = asked.duration;
  run.tolerance = asked.tolerance;
  run.label = fmt::format("{} {}", label_, step);
  if (!request().scratch.empty())
    run.checkpoint = file_of(step, "motion");
  DynamicsOutcome outcome = run_dynamics(system_, load, state, run, watch);
  return {std::move(outcome.relaxation), std::move(outcome.average)};
}

std::vector<AtomGroup>
ExplicitContact::block_atoms(std::span<const double> state,
                             const AtomStep& step) const {
  std::vector<AtomGroup> groups = inner_atoms(system_.block(), state);
  groups.insert(groups.begin(), contact_atoms(system_, state, step.pressure));
  return groups;
}

std::string ExplicitContact::description() const {
  constexpr std::array lattices = {"isotropic", "born", "central"};
  const BlockShape& shape = system_.block().shape();
  return fmt::format(
      "{} lattice, {} x {} atoms, explicit: {} {} of {} layers, {:.4g} m deep, "
      "{} free atoms; effective E* at q a = 0.1: {:.5g} Pa",
      lattices[static_cast<std::size_t>(request().settings.lattice)],
      shape.layer.points_x, shape.layer.points_y, shape.levels,
      shape.levels == 1 ? "level" : "levels", shape.layers,
      system_.block().depth(), system_.size() / 3, effective_modulus_);
}

} // namespace

std::unique_ptr<AtomicContact> make_explicit_contact(AtomRequest request) {
  require_explicit_bulk(request.settings);
  return std::make_unique<ExplicitContact>(std::move(request));
}

} // namespace asperity::md
