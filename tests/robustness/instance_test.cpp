// Tests of robustness/instance.hpp and robustness/instance_surface.hpp: an
// instance follows from its seed and its index, and the axes cover their
// ranges.
#include "robustness/instance.hpp"
#include "robustness/instance_surface.hpp"
#include "robustness/kinds.hpp"
#include "surfaces/maps/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace asperity::robustness::instance_test {

TEST(Instance, IsItsSeedAndItsIndex) {
  std::set<std::string> different;
  for (int index = 0; index < 200; ++index) {
    EXPECT_EQ(text_of(draw_instance(7, index)),
              text_of(draw_instance(7, index)));
    different.insert(text_of(draw_instance(7, index)));
    different.insert(text_of(draw_instance(8, index)));
  }
  EXPECT_EQ(different.size(), 400u);
  EXPECT_THROW(draw_instance(7, -1), std::domain_error);
}

// The meaning of a seed never changes: the numbers of one instance as first
// drawn.
TEST(Instance, KeepsItsMeaning) {
  const Instance instance = draw_instance(1, 48);
  EXPECT_EQ(name_of(instance.family), "condensed-q1");
  EXPECT_EQ(instance.points, 32);
  EXPECT_DOUBLE_EQ(instance.length, 0.00028925466378849446);
  EXPECT_DOUBLE_EQ(instance.penalty, 170856592463.84698);
}

TEST(Instance, ReachesTheEndsOfItsAxes) {
  std::set<std::string> families, shapes, flaws, pairs, paths;
  std::set<int> threads;
  Instance least = draw_instance(3, 0);
  Instance most = least;
  for (int index = 0; index < 4000; ++index) {
    const Instance instance = draw_instance(3, index);
    families.insert(name_of(instance.family));
    shapes.insert(name_of(instance.shape));
    flaws.insert(name_of(instance.flaw));
    pairs.insert(name_of(instance.relation));
    paths.insert(name_of(instance.path));
    threads.insert(instance.threads);
    for (const auto member :
         {&Instance::length, &Instance::hurst, &Instance::rms_slope,
          &Instance::penalty, &Instance::contact_modulus, &Instance::growth,
          &Instance::thickness}) {
      least.*member = std::min(least.*member, instance.*member);
      most.*member = std::max(most.*member, instance.*member);
    }
  }
  EXPECT_EQ(families.size(), 8u);
  EXPECT_EQ(shapes.size(), 9u);
  EXPECT_EQ(flaws.size(), 25u);
  EXPECT_EQ(paths.size(), 4u);
  EXPECT_EQ(threads.size(), 3u);
  EXPECT_EQ(pairs.size(), 5u);
  // 4000 uniform draws miss the last hundredth of a range with e^-40.
  EXPECT_LT(least.length, 1.6e-12);
  EXPECT_GT(most.length, 6e5);
  EXPECT_EQ(least.hurst, 0.0);
  EXPECT_EQ(most.hurst, 1.0);
  EXPECT_LT(least.penalty, 2e-6);
  EXPECT_GT(most.penalty, 5e14);
  EXPECT_LT(least.rms_slope, 1.2e-6);
  EXPECT_GT(most.rms_slope, 8.0);
  EXPECT_LT(least.contact_modulus, 1.4);
  EXPECT_GT(most.contact_modulus, 7e11);
  EXPECT_EQ(least.growth, 1.0);
  EXPECT_GT(most.growth, 2.97);
  EXPECT_LT(least.thickness, 0.011);
  EXPECT_GT(most.thickness, 9.2);
}

// Only full 3-D models in the library have free sides, other linear solvers and
// random moduli, and only in combinations that they accept.
TEST(Instance, GivesTheSettingsOfABlockToBlocksOnly) {
  int n_free = 0;
  int n_counters = 0;
  double most = 1.0;
  for (int index = 0; index < 8000; ++index) {
    const Instance instance = draw_instance(4, index);
    const bool is_compared =
        instance.relation == MetamorphicRelation::direct_solver;
    EXPECT_EQ(is_compared, instance.family == Family::full_block &&
                               instance.path == Path::library);
    if (!is_compared) {
      EXPECT_FALSE(instance.has_free_sides);
      EXPECT_EQ(instance.modulus_ratio, 1.0);
    }
    n_free += instance.has_free_sides ? 1 : 0;
    if (instance.counter != CounterBody::none) {
      ++n_counters;
      EXPECT_TRUE(is_compared);
      EXPECT_NE(instance.law, mechanics::ContactLaw::hard);
      EXPECT_NE(instance.far_boundary, mechanics::FarBoundary::pressure);
      EXPECT_NE(instance.mesh, mechanics::MeshKind::adaptive);
    }
    most = std::max(most, instance.modulus_ratio);
    if (instance.has_free_sides) {
      EXPECT_NE(instance.far_boundary, mechanics::FarBoundary::pressure);
    }
  }
  EXPECT_GT(n_free, 10);
  EXPECT_GT(n_counters, 10);
  EXPECT_GT(most, 300.0);
}

// Half of the axes of a perturbed instance are those of the case, and invalid
// ones stay invalid.
TEST(Instance, IsPerturbedAboutACase) {
  Instance base;
  base.length = 3e-6;
  base.family = Family::condensed_q2;
  int own = 0;
  int n_instances = 1000;
  for (int index = 0; index < n_instances; ++index) {
    const Instance instance = draw_instance_about(base, 5, index);
    own += instance.length == base.length;
    EXPECT_EQ(instance.family == Family::flawed, instance.flaw != Flaw::none);
    if (instance.law == mechanics::ContactLaw::hard &&
        instance.control == mechanics::Control::mean_gap) {
      EXPECT_GT(instance.load, 0.0);
    }
  }
  // 3 sigma of a binomial distribution with p = 1/2, and the few atomistic
  // blocks with their own length.
  EXPECT_NEAR(own, n_instances / 2, 3.0 * std::sqrt(n_instances / 4.0) + 25.0);
}

// Thin plates with a free back and elements that lock may lose contact,
// and no other block may.
TEST(MayLoseContact, IsSaidOfPlatesAndOfElementsThatLock) {
  Instance instance;
  instance.thickness = 0.04;
  instance.far_boundary = mechanics::FarBoundary::pressure;
  EXPECT_FALSE(may_lose_contact(instance)) << "a half-space has no thickness";
  instance.family = Family::slab;
  EXPECT_TRUE(may_lose_contact(instance));
  instance.thickness = 0.06;
  EXPECT_FALSE(may_lose_contact(instance));
  instance.thickness = 0.04;
  instance.far_boundary = mechanics::FarBoundary::clamped;
  EXPECT_FALSE(may_lose_contact(instance));

  instance.poisson_ratio = 0.4999;
  EXPECT_FALSE(may_lose_contact(instance)) << "a continuum does not lock";
  instance.family = Family::condensed_q1;
  EXPECT_TRUE(may_lose_contact(instance));
  instance.poisson_ratio = 0.3;
  EXPECT_FALSE(may_lose_contact(instance));
}

// A coating is a layer with its own modulus, and no coating is none.
TEST(BlockRequest, HasALayerForEachCoating) {
  Instance instance;
  instance.family = Family::condensed_q1;
  const Grid grid = grid_of(instance);
  EXPECT_TRUE(block_request(instance, grid, 1, 1).layers.empty());

  for (const double stiffness : {0.5, 2.0}) {
    instance.coating_stiffness = stiffness;
    const fem::BlockRequest request = block_request(instance, grid, 1, 1);
    ASSERT_EQ(request.layers.size(), 1U);
    EXPECT_EQ(request.layers[0].moduli.youngs_modulus,
              stiffness * request.youngs_modulus);
  }
}

// Tolerance: roundoff of a transform and a scaling.
TEST(InstanceSurface, HasTheRequestedSlope) {
  for (const Shape shape :
       {Shape::rough, Shape::wave, Shape::paraboloid, Shape::spike, Shape::step,
        Shape::sawtooth, Shape::terraces, Shape::checkerboard}) {
    Instance instance;
    instance.shape = shape;
    instance.rms_slope = 0.37;
    instance.length = 1e-9;

    const InstanceSurface surface = surface_of(instance, grid_of(instance));

    EXPECT_NEAR(surfaces::statistics(surface.map).rms_slope / 0.37, 1.0, 1e-12)
        << name_of(shape);
  }
}

TEST(InstanceSurface, OfExtremeShapesIsAsDocumented) {
  const auto heights_of = [](Shape shape) {
    Instance instance;
    instance.shape = shape;
    return surface_of(instance, grid_of(instance)).map.heights;
  };
  const auto values = [](std::vector<double> heights) {
    return std::set<double>(heights.begin(), heights.end()).size();
  };
  EXPECT_EQ(values(heights_of(Shape::flat)), 1u);
  EXPECT_EQ(values(heights_of(Shape::spike)), 2u);
  EXPECT_EQ(values(heights_of(Shape::step)), 2u);
  EXPECT_EQ(values(heights_of(Shape::checkerboard)), 2u);
  EXPECT_EQ(values(heights_of(Shape::terraces)), 4u);
  EXPECT_EQ(values(heights_of(Shape::sawtooth)), 8u);
}

} // namespace asperity::robustness::instance_test
