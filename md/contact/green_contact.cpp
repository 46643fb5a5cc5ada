#include "md/contact/green_contact.hpp"

#include "base/require.hpp"
#include "input/input_error.hpp"
#include "md/contact/dump.hpp"
#include "md/contact/green_system.hpp"
#include "md/contact/load_step_driver.hpp"
#include "md/contact/request_parts.hpp"
#include "md/lattice/slab_symbol.hpp"
#include "md/minimise/newton.hpp"
#include "md/minimise/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity::md {
namespace {

void require_green_bulk(const mechanics::MdSettings& settings) {
  if (settings.engine != mechanics::AtomEngine::asperity ||
      settings.bulk != mechanics::AtomBulk::green)
    throw input::InputError(
        "[md] this block needs engine = \"asperity\" and bulk = \"green\"");
  if (settings.minimizer != mechanics::AtomMinimizer::automatic &&
      settings.minimizer != mechanics::AtomMinimizer::lbfgs)
    throw input::InputError(
        "[md] bulk = \"green\" has no internal degrees of freedom for "
        "dynamics: minimizer must be \"auto\" or \"lbfgs\"");
}

int cells_of(const AtomRequest& request) {
  const double depth = request.settings.depth.in_si(request.scales);
  require_positive("depth", depth, "m");
  return std::max(
      1, static_cast<int>(std::lround(depth / request.layer.spacing_x())));
}

class GreenContact final : public LoadStepDriver {
public:
  explicit GreenContact(AtomRequest given);

  std::string description() const override;

  double effective_contact_modulus() const override {
    return SlabSymbol(crystal_of(request())).contact_modulus(0.1, 0.0, cells_);
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

  int cells_;
  GreenSystem system_;
};

GreenContact::GreenContact(AtomRequest given)
    : LoadStepDriver(std::move(given)),
      cells_(cells_of(request())),
      system_(SurfaceStiffness(crystal_of(request()), request().layer, cells_,
                               request().settings.modes, request().threads),
              Interface(interaction_of(request().settings), request().layer,
                        request().substrate, request().heights,
                        request().threads)) {
  start();
}

Relaxation GreenContact::approach(std::vector<double>& state,
                                  const RelaxationSettings& settings) {
  return balance({}, 0, state, settings, {}).relaxation;
}

LoadStepDriver::Balance
GreenContact::balance(const Load& /*load*/, int /*step*/,
                      std::vector<double>& state,
                      const RelaxationSettings& settings, const Watch& watch) {
  return {request().settings.minimizer == mechanics::AtomMinimizer::lbfgs
              ? relax(system_, state, settings, watch)
              : relax_by_newton(system_, state, settings, watch),
          {}};
}

std::vector<AtomGroup> GreenContact::block_atoms(std::span<const double> state,
                                                 const AtomStep& step) const {
  return {contact_atoms(system_, state, step.pressure)};
}

std::string GreenContact::description() const {
  constexpr std::array lattices = {"isotropic", "born", "central"};
  const bool is_normal =
      request().settings.modes == mechanics::AtomModes::normal;
  return fmt::format(
      "{} lattice, {} x {} atoms, green: {} cells deep{}; effective E* at q a "
      "= 0.1: {:.5g} Pa",
      lattices[static_cast<std::size_t>(request().settings.lattice)],
      request().layer.points_x, request().layer.points_y, cells_,
      is_normal ? ", normal displacements only" : "",
      effective_contact_modulus());
}

} // namespace

std::unique_ptr<AtomicContact> make_green_contact(AtomRequest request) {
  require_green_bulk(request.settings);
  return std::make_unique<GreenContact>(std::move(request));
}

} // namespace asperity::md
