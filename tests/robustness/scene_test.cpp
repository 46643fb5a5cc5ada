// Claims about robustness/scene.hpp and robustness/scene_surface.hpp: a scene
// is its seed and its index, and the axes reach their ends.
#include "surfaces/maps/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "robustness/scene.hpp"
#include "robustness/scene_surface.hpp"

namespace asperity::robustness {
namespace {

TEST(Scene, IsItsSeedAndItsIndex) {
  std::set<std::string> different;
  for (int index = 0; index < 200; ++index) {
    EXPECT_EQ(in_words(draw_scene(7, index)), in_words(draw_scene(7, index)));
    different.insert(in_words(draw_scene(7, index)));
    different.insert(in_words(draw_scene(8, index)));
  }
  EXPECT_EQ(different.size(), 400u);
  EXPECT_THROW(draw_scene(7, -1), std::domain_error);
}

// What a seed means never changes: the numbers of one scene, as first drawn.
TEST(Scene, KeepsItsMeaning) {
  const Scene scene = draw_scene(1, 48);
  EXPECT_EQ(name_of(scene.family), "condensed-q1");
  EXPECT_EQ(scene.points, 32);
  EXPECT_DOUBLE_EQ(scene.length, 0.00028925466378849446);
  EXPECT_DOUBLE_EQ(scene.penalty, 170856592463.84698);
}

TEST(Scene, ReachesTheEndsOfItsAxes) {
  std::set<std::string> families, shapes, flaws, twins, paths;
  std::set<int> threads;
  Scene least = draw_scene(3, 0);
  Scene most = least;
  for (int index = 0; index < 4000; ++index) {
    const Scene scene = draw_scene(3, index);
    families.insert(name_of(scene.family));
    shapes.insert(name_of(scene.shape));
    flaws.insert(name_of(scene.flaw));
    twins.insert(name_of(scene.twin));
    paths.insert(name_of(scene.path));
    threads.insert(scene.threads);
    for (const auto member :
         {&Scene::length, &Scene::hurst, &Scene::rms_slope, &Scene::penalty,
          &Scene::contact_modulus, &Scene::growth, &Scene::thickness}) {
      least.*member = std::min(least.*member, scene.*member);
      most.*member = std::max(most.*member, scene.*member);
    }
  }
  EXPECT_EQ(families.size(), 8u);
  EXPECT_EQ(shapes.size(), 9u);
  EXPECT_EQ(flaws.size(), 25u);
  EXPECT_EQ(paths.size(), 4u);
  EXPECT_EQ(threads.size(), 3u);
  EXPECT_EQ(twins.size(), 4u);
  // 4000 even draws miss the last hundredth of a range with e^-40.
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

// Half of the axes of a case's scene are its own, and the flawed stay flawed.
TEST(Scene, IsPerturbedAboutACase) {
  Scene base;
  base.length = 3e-6;
  base.family = Family::condensed_q2;
  int own = 0;
  int n_scenes = 1000;
  for (int index = 0; index < n_scenes; ++index) {
    const Scene scene = draw_scene_about(base, 5, index);
    own += scene.length == base.length;
    EXPECT_EQ(scene.family == Family::flawed, scene.flaw != Flaw::none);
    if (scene.law == mechanics::ContactLaw::hard &&
        scene.control == mechanics::Control::mean_gap) {
      EXPECT_GT(scene.load, 0.0);
    }
  }
  // 3 sigma of a fair coin, and the few blocks of atoms with their own length.
  EXPECT_NEAR(own, n_scenes / 2, 3.0 * std::sqrt(n_scenes / 4.0) + 25.0);
}

// Tolerance: rounding of a transform and a scaling.
TEST(SceneSurface, HasTheSlopeThatWasAsked) {
  for (const Shape shape :
       {Shape::rough, Shape::wave, Shape::paraboloid, Shape::spike, Shape::step,
        Shape::sawtooth, Shape::terraces, Shape::checkerboard}) {
    Scene scene;
    scene.shape = shape;
    scene.rms_slope = 0.37;
    scene.length = 1e-9;

    const SceneSurface surface = surface_of(scene, grid_of(scene));

    EXPECT_NEAR(surfaces::statistics(surface.map).rms_slope / 0.37, 1.0, 1e-12)
        << name_of(shape);
  }
}

TEST(SceneSurface, OfTheNastyShapesIsWhatItSays) {
  const auto heights_of = [](Shape shape) {
    Scene scene;
    scene.shape = shape;
    return surface_of(scene, grid_of(scene)).map.heights;
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

} // namespace
} // namespace asperity::robustness
