// Draws instances from a seed and an index.
#include "robustness/instance.hpp"

#include "base/require.hpp"
#include "robustness/draw.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::robustness {
namespace {

Family draw_family(const Draw& draw) {
  return draw.weigh<Family>(Stream::family, {{Family::halfspace, 25.0},
                                             {Family::slab, 21.0},
                                             {Family::condensed_q1, 16.0},
                                             {Family::condensed_q2, 14.0},
                                             {Family::full_block, 2.0},
                                             {Family::atoms, 1.0},
                                             {Family::theory, 11.0},
                                             {Family::flawed, 10.0}});
}

Shape draw_shape(const Draw& draw) {
  return draw.weigh<Shape>(Stream::shape, {{Shape::rough, 8.0},
                                           {Shape::wave, 1.0},
                                           {Shape::paraboloid, 1.0},
                                           {Shape::spike, 1.0},
                                           {Shape::step, 1.0},
                                           {Shape::sawtooth, 1.0},
                                           {Shape::terraces, 1.0},
                                           {Shape::checkerboard, 1.0},
                                           {Shape::flat, 1.0}});
}

/// The first seventeen flaws have a stream of their own, so that flaws added
/// later do not change them.
Flaw draw_flaw(const Draw& draw) {
  constexpr int first_later = static_cast<int>(Flaw::nan_load);
  constexpr int n_flaws = static_cast<int>(Flaw::infinite_modulus);
  const int later =
      static_cast<int>(draw.uniform(Stream::later_flaw, 0, n_flaws));
  if (first_later + later <= n_flaws)
    return static_cast<Flaw>(first_later + later);
  constexpr int first = static_cast<int>(Flaw::nan_height);
  return static_cast<Flaw>(draw.uniform(Stream::flaw, first, first_later));
}

/// A process and a result file cost as much as some hundred instances.
Path draw_path(const Draw& draw, Family family) {
  const double place = draw.uniform(Stream::path, 0.0, 1.0);
  switch (family) {
  case Family::full_block:
    return place < 0.1 ? Path::two_ranks : Path::library;
  case Family::flawed:
    return place < 0.1 ? Path::program : Path::library;
  case Family::atoms:
  case Family::theory:
    return Path::library;
  default:
    return place < 0.01   ? Path::program
           : place < 0.02 ? Path::report
                          : Path::library;
  }
}

/// Pressures are log-uniform, with half of the draws in the range in which
/// contact changes most; gaps lie where the surfaces touch.
double draw_load(const Draw& draw, const Instance& instance) {
  if (instance.family == Family::theory)
    return draw.log_uniform(Stream::load, 1e-12, 100.0);
  if (instance.control == mechanics::Control::mean_gap)
    return instance.law == mechanics::ContactLaw::penalty &&
                   draw.coin(Stream::load)
               ? draw.uniform(Stream::load, -1.0, 3.0)
               : draw.log_uniform(Stream::load, 1e-3, 4.0);
  return draw.coin(Stream::load) ? draw.log_uniform(Stream::load, 1e-9, 100.0)
                                 : draw.log_uniform(Stream::load, 1e-3, 10.0);
}

void draw_surface(const Draw& draw, Instance& instance) {
  instance.shape = draw_shape(draw);
  instance.points = draw.pick<int>(Stream::points, {8, 16, 24, 32, 48, 64});
  instance.length = draw.log_uniform(Stream::length, 1e-12, 1e6);
  // Both limits are drawn with finite probability, because part of a spectral
  // moment is a logarithm there.
  instance.hurst = std::clamp(draw.uniform(Stream::hurst, -0.1, 1.1), 0.0, 1.0);
  instance.roll_off = draw.uniform(Stream::roll_off, 1.0, 4.0);
  instance.shortest_wave =
      draw.pick<double>(Stream::shortest_wave, {2.0, 2.1, 2.1, 3.0, 4.0, 8.0});
  instance.rms_slope = draw.log_uniform(Stream::rms_slope, 1e-6, 10.0);
}

void draw_block(const Draw& draw, Instance& instance) {
  instance.contact_modulus =
      draw.log_uniform(Stream::contact_modulus, 1.0, 1e12);
  instance.poisson_ratio =
      draw.pick<double>(Stream::poisson_ratio, {0.0, 0.3, 0.49, 0.4999});
  instance.thickness = draw.log_uniform(Stream::thickness, 0.01, 10.0);
  instance.growth = std::max(1.0, draw.uniform(Stream::growth, 0.8, 3.0));
  instance.degree = draw.pick<int>(Stream::degree, {1, 2});
  instance.coating_stiffness =
      draw.coin(Stream::coating_stiffness)
          ? draw.log_uniform(Stream::coating_stiffness, 0.05, 20.0)
          : 1.0;
  instance.coating_thickness =
      draw.uniform(Stream::coating_thickness, 0.02, 0.5);
  // Full 3-D models have coatings of 1e-3 to 1e3 times the modulus.
  if (instance.family == Family::full_block)
    instance.coating_stiffness =
        std::pow(instance.coating_stiffness, std::log(1e3) / std::log(20.0));
  instance.has_free_sides = draw.coin(Stream::sides);
  instance.linear_solver = draw.pick<mechanics::LinearSolver>(
      Stream::linear_solver,
      {mechanics::LinearSolver::automatic, mechanics::LinearSolver::multigrid});
  instance.mesh = draw.weigh<mechanics::MeshKind>(
      Stream::mesh, {{mechanics::MeshKind::layers, 4.0},
                     {mechanics::MeshKind::hanging, 2.0},
                     {mechanics::MeshKind::adaptive, 2.0},
                     {mechanics::MeshKind::gmsh, 2.0}});
  instance.modulus_ratio =
      draw.coin(Stream::modulus_ratio)
          ? draw.log_uniform(Stream::modulus_ratio, 1.0, 1e3)
          : 1.0;
  instance.counter =
      draw.weigh<CounterBody>(Stream::counter, {{CounterBody::none, 7.0},
                                                {CounterBody::sphere, 1.0},
                                                {CounterBody::cylinder, 1.0},
                                                {CounterBody::cuboid, 1.0}});
  instance.counter_radius = draw.uniform(Stream::counter_radius, 0.25, 0.45);
  instance.counter_stiffness =
      draw.log_uniform(Stream::counter_stiffness, 1e-2, 1e2);
  instance.far_boundary = draw.pick<mechanics::FarBoundary>(
      Stream::far_boundary,
      {mechanics::FarBoundary::clamped, mechanics::FarBoundary::sliding,
       mechanics::FarBoundary::pressure});
}

} // namespace

Instance draw_instance(std::uint64_t seed, int index) {
  require_not_negative("index", index, "1");
  const Draw draw(seed, index);
  Instance instance;
  instance.seed = seed;
  instance.index = index;
  instance.family = draw_family(draw);
  draw_surface(draw, instance);
  draw_block(draw, instance);
  instance.law = draw.weigh<mechanics::ContactLaw>(
      Stream::law, {{mechanics::ContactLaw::penalty, 4.0},
                    {mechanics::ContactLaw::hard, 3.0},
                    {mechanics::ContactLaw::augmented, 2.0}});
  instance.adhesion = draw.log_uniform(Stream::adhesion, 1e-3, 10.0);
  if (draw.coin(Stream::spring))
    instance.spring = draw.log_uniform(Stream::spring, 1e-2, 1e4);
  instance.grid_number = draw.log_uniform(Stream::grid_number, 1e-3, 1.0);
  if (draw.uniform(Stream::adhesive_law, 0.0, 5.0) < 1.0)
    instance.law = draw.pick<mechanics::ContactLaw>(
        Stream::law,
        {mechanics::ContactLaw::exponential, mechanics::ContactLaw::dugdale,
         mechanics::ContactLaw::cubic, mechanics::ContactLaw::lennard_jones,
         mechanics::ContactLaw::lennard_jones_layers,
         mechanics::ContactLaw::morse});
  instance.penalty = draw.log_uniform(Stream::penalty, 1e-6, 1e15);
  instance.control = draw.weigh<mechanics::Control>(
      Stream::control, {{mechanics::Control::nominal_pressure, 7.0},
                        {mechanics::Control::mean_gap, 3.0}});
  instance.load = draw_load(draw, instance);
  instance.has_free_boundaries =
      draw.uniform(Stream::boundaries, 0.0, 3.0) < 1.0;
  instance.program = draw.pick<Program>(
      Stream::program, {Program::increments, Program::jump, Program::cycle});
  instance.relation = draw.pick<MetamorphicRelation>(
      Stream::relation,
      {MetamorphicRelation::none, MetamorphicRelation::binary_units,
       MetamorphicRelation::decimal_units, MetamorphicRelation::threads});
  instance.gamma = draw.log_uniform(Stream::gamma, 0.01, 1.0);
  instance.path = draw_path(draw, instance.family);
  // The default is three threads. A metamorphic pair that compares threads
  // needs at least two.
  instance.threads = draw.pick<int>(Stream::threads, {1, 2, 3});
  if (instance.relation == MetamorphicRelation::threads &&
      instance.threads == 1)
    instance.threads = 3;
  if (instance.family == Family::flawed)
    instance.flaw = draw_flaw(draw);
  return within_reach(instance);
}

Instance draw_instance_about(const Instance& base, std::uint64_t seed,
                             int index) {
  const Instance drawn = draw_instance(seed, index);
  const Draw draw(seed, index);
  Instance instance = drawn;
  const auto keep = [&](Stream axis, auto member) {
    if (draw.coin(axis))
      instance.*member = base.*member;
  };
  keep(Stream::shape, &Instance::shape);
  keep(Stream::law, &Instance::law);
  keep(Stream::far_boundary, &Instance::far_boundary);
  keep(Stream::length, &Instance::length);
  keep(Stream::hurst, &Instance::hurst);
  keep(Stream::roll_off, &Instance::roll_off);
  keep(Stream::shortest_wave, &Instance::shortest_wave);
  keep(Stream::rms_slope, &Instance::rms_slope);
  keep(Stream::contact_modulus, &Instance::contact_modulus);
  keep(Stream::poisson_ratio, &Instance::poisson_ratio);
  keep(Stream::thickness, &Instance::thickness);
  keep(Stream::growth, &Instance::growth);
  keep(Stream::penalty, &Instance::penalty);
  keep(Stream::gamma, &Instance::gamma);
  if (instance.law != drawn.law &&
      instance.control == mechanics::Control::mean_gap)
    // Hard contact does not allow a negative gap.
    instance.load = std::abs(instance.load);
  if (instance.family != Family::flawed && draw.coin(Stream::family))
    instance.family = base.family;
  return within_reach(instance);
}

} // namespace asperity::robustness
