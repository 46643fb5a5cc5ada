#include "md/green_contact.hpp"

#include "base/require.hpp"
#include "cases/case_error.hpp"
#include "md/dump.hpp"
#include "md/green_system.hpp"
#include "md/newton.hpp"
#include "md/relaxation.hpp"
#include "md/request_parts.hpp"
#include "md/slab_symbol.hpp"
#include "md/step_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace asperity::md {
namespace {

using cases::Control;

constexpr double start_clearance = 4e-10; ///< over the highest rigid atom [m]
constexpr double descent = 0.5e-10;       ///< of a held height, at once [m]
constexpr double descent_tolerance = 0.1; ///< of the balances on the way

void require_supported(const cases::MdSettings& settings) {
  if (settings.engine != cases::AtomEngine::asperity ||
      settings.bulk != cases::AtomBulk::green)
    throw cases::CaseError("[md] this block is bulk = \"green\" of engine = "
                           "\"asperity\"");
  if (settings.minimizer != cases::AtomMinimizer::automatic &&
      settings.minimizer != cases::AtomMinimizer::lbfgs)
    throw cases::CaseError("[md] bulk = \"green\" has no inside that could "
                           "move in time: its minimizer is \"auto\" or "
                           "\"lbfgs\"");
}

int cells_of(const AtomRequest& request) {
  const double depth = request.settings.depth.in_si(request.scales);
  require_positive("depth", depth, "m");
  return std::max(
      1, static_cast<int>(std::lround(depth / request.layer.spacing_x())));
}

void add_effort(const Relaxation& more, Relaxation& sum) {
  sum.evaluations += more.evaluations;
  sum.linearisations += more.linearisations;
  sum.products += more.products;
}

class GreenContact final : public AtomicContact {
public:
  explicit GreenContact(AtomRequest request);

  AtomStep solve(Control control, double amount, int step,
                 const Watch& watch) override;
  std::string description() const override;

  std::vector<double> state() const override { return state_; }

  void restore(std::span<const double> state) override {
    if (state.size() != state_.size())
      refuse_argument("state.size()", static_cast<double>(state.size()),
                      fmt::format("{}", state_.size()));
    state_.assign(state.begin(), state.end());
  }

  double shown_contact_modulus() const override {
    return SlabSymbol(crystal_of(request_)).contact_modulus(0.1, 0.0, cells_);
  }

private:
  RelaxationSettings settings_for(double contact_force) const;
  std::span<double> heights();
  void raise(double height);
  double contact_force();
  Relaxation descend_to(double height);
  Relaxation relaxed(const RelaxationSettings& settings, const Watch& watch);
  Relaxation balance(const Load& load, const Watch& watch);

  AtomRequest request_;
  int cells_;
  GreenSystem system_;
  std::vector<double> state_; ///< of the last sound answer, or from above
};

GreenContact::GreenContact(AtomRequest request)
    : request_(std::move(request)),
      cells_(cells_of(request_)),
      system_(SurfaceStiffness(crystal_of(request_), request_.layer, cells_,
                               request_.settings.modes, request_.threads),
              Interface(interaction_of(request_.settings), request_.layer,
                        request_.substrate, request_.heights,
                        request_.threads)),
      state_(system_.undeformed(*std::ranges::max_element(request_.heights) +
                                start_clearance)) {}

/// k_c is what all atoms together meet when each is one pair of force f near
/// r_0 in r^-12: 13 f / r_0 on average. It follows the load.
RelaxationSettings GreenContact::settings_for(double contact_force) const {
  RelaxationSettings settings;
  settings.tolerance = request_.settings.tolerance;
  settings.max_evaluations = request_.settings.max_evaluations;
  if (contact_force > 0.0)
    settings.contact_stiffness =
        13.0 * contact_force / request_.settings.interaction_distance;
  return settings;
}

std::span<double> GreenContact::heights() {
  return std::span(state_).subspan(2 * request_.layer.size());
}

/// Moves the whole layer to a mean height.
void GreenContact::raise(double height) {
  const double mean = std::accumulate(heights().begin(), heights().end(), 0.0) /
                      static_cast<double>(heights().size());
  for (double& z : heights())
    z += height - mean;
}

/// Of the state as it is, 0 where nothing touches [N].
double GreenContact::contact_force() {
  std::vector<double> forces(system_.size());
  return system_.energy_and_forces(state_, forces).contact_force;
}

/// Brings a held height down in steps that the surface can follow, and up at
/// once. Returns what it took.
Relaxation GreenContact::descend_to(double height) {
  const double start =
      std::accumulate(heights().begin(), heights().end(), 0.0) /
      static_cast<double>(heights().size());
  Relaxation taken;
  for (double at = start - descent; at > height; at -= descent) {
    raise(at);
    system_.set_load({Load::Kind::height, at});
    const double force = contact_force();
    ++taken.evaluations;
    if (!(force > 0.0))
      continue;
    RelaxationSettings rough = settings_for(force);
    rough.tolerance = std::max(descent_tolerance, rough.tolerance);
    add_effort(relaxed(rough, {}), taken);
  }
  raise(height);
  return taken;
}

/// By the asked method, from the state as it is.
Relaxation GreenContact::relaxed(const RelaxationSettings& settings,
                                 const Watch& watch) {
  return request_.settings.minimizer == cases::AtomMinimizer::lbfgs
             ? relax(system_, state_, settings, watch)
             : relax_by_newton(system_, state_, settings, watch);
}

Relaxation GreenContact::balance(const Load& load, const Watch& watch) {
  if (load.kind == Load::Kind::nominal_pressure) {
    system_.set_load(load);
    return relaxed(settings_for(load.amount * request_.layer.cell_area()),
                   watch);
  }
  Relaxation before = descend_to(load.amount);
  ++before.evaluations; // the force below
  system_.set_load(load);
  const double force = contact_force();
  Relaxation relaxation;
  if (force == 0.0) { // nothing touches: the flat block is the answer
    state_ = system_.undeformed(load.amount);
    relaxation.converged = true;
  } else {
    relaxation = relaxed(settings_for(force), watch);
  }
  add_effort(before, relaxation);
  return relaxation;
}

AtomStep GreenContact::solve(Control control, double amount, int step,
                             const Watch& watch) {
  Load load{Load::Kind::nominal_pressure, amount};
  if (control == Control::nominal_pressure)
    require_positive("nominal pressure", amount, "Pa");
  else
    load = {Load::Kind::height, amount + request_.settings.contact_distance};

  const std::vector<double> before = state_;
  const Relaxation relaxation = balance(load, watch);
  AtomStep answer;
  answer.evaluations = relaxation.evaluations;
  answer.linearisations = relaxation.linearisations;
  answer.products = relaxation.products;
  answer.residual = relaxation.residual;
  read_step(
      system_, state_, normal_forces(system_, state_),
      {request_.settings.contact_distance, close_distance(request_.settings)},
      answer);
  const std::string fault = fault_of(answer.inspection, request_.layer.size());
  answer.note = fault.empty() ? relaxation.note : fault;
  answer.converged = relaxation.converged && fault.empty();
  if (request_.settings.dump)
    write_atoms(
        request_.scratch / fmt::format("step-{:04}.xyz", step), request_.layer,
        std::array{substrate_atoms(request_.substrate, request_.heights),
                   contact_atoms(system_, state_, answer.pressure)});
  if (!fault.empty() || !std::isfinite(relaxation.energy))
    state_ = before;
  return answer;
}

std::string GreenContact::description() const {
  constexpr std::array lattices = {"isotropic", "born", "central"};
  const bool is_normal = request_.settings.modes == cases::AtomModes::normal;
  return fmt::format(
      "{} lattice, {} x {} atoms, green: {} cells deep{}; E* shown at q a = "
      "0.1: {:.5g} Pa",
      lattices[static_cast<std::size_t>(request_.settings.lattice)],
      request_.layer.points_x, request_.layer.points_y, cells_,
      is_normal ? ", normal displacements alone" : "", shown_contact_modulus());
}

} // namespace

std::unique_ptr<AtomicContact> make_green_contact(AtomRequest request) {
  require_supported(request.settings);
  return std::make_unique<GreenContact>(std::move(request));
}

std::string fault_of(const Inspection& inspection, std::size_t atoms) {
  const double share =
      100.0 * inspection.below_substrate / static_cast<double>(atoms);
  if (inspection.below_substrate > 0)
    return fmt::format("{:.3g} % of the atoms are below the substrate, and {} "
                       "pairs are too near: atoms went through",
                       share, inspection.close_pairs);
  if (inspection.close_pairs > 0)
    return fmt::format("{} pairs are too near, the nearest at {:.3g} m: atoms "
                       "are going through",
                       inspection.close_pairs, inspection.shortest_distance);
  return "";
}

} // namespace asperity::md
