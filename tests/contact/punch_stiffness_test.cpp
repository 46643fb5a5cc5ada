// Tests of contact/solvers/punch_stiffness.hpp with exact solutions, with the
// contact solver on flat punches and with differences of contact curves.
#include "base/special_numbers.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/punch_stiffness.hpp"
#include "contact/solvers/solver.hpp"
#include "tests/contact/problems.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::contact::punch_stiffness_test {

using std::numbers::pi;

template <class IsInside>
std::vector<std::uint8_t> set_where(const Grid& grid,
                                    const IsInside& is_inside) {
  std::vector<std::uint8_t> set(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      set[grid.index(ix, iy)] =
          is_inside(ix * grid.spacing_x(), iy * grid.spacing_y()) ? 1 : 0;
  return set;
}

double stiffness(SurfaceOperator& elasticity,
                 const std::vector<std::uint8_t>& set,
                 double local_compliance = 0.0) {
  const PunchStiffness found =
      punch_stiffness(elasticity, set, local_compliance);
  EXPECT_TRUE(found.converged);
  EXPECT_LE(found.iterations, 10);
  return found.stiffness;
}

// Strips of width 2 a with the period L on a half-space have
// K = pi E*/(2 L ln(1/sin(pi a/L))). The border of the contact makes an error
// of first order: it halves with the spacing, and the extrapolated value is
// exact to second order.
TEST(PunchStiffness, OfPeriodicStripsIsThatOfTheirArray) {
  for (const double half_width : {1.0 / 32.0, 0.25, 7.0 / 16.0}) {
    const double exact = pi / 2.0 / -std::log(std::sin(pi * half_width));
    std::vector<double> errors;
    for (const int points : {128, 256, 512}) {
      const Grid grid{points, 2, 1.0, 2.0 / points};
      FourierOperator elasticity = problems::unit_halfspace(grid);

      const double found =
          stiffness(elasticity, set_where(grid, [&](double x, double) {
                      return x < 2.0 * half_width; // whole cells
                    }));

      errors.push_back(found / exact - 1.0);
    }
    EXPECT_NEAR(errors[0] / errors[1], 2.0, 0.15);
    EXPECT_NEAR(errors[1] / errors[2], 2.0, 0.1);
    EXPECT_LT(std::abs(2.0 * errors[2] - errors[1]), 1e-3);
  }
}

/// A disc of radius a around the middle of a map with free borders.
struct Disc {
  double x, y, radius;

  bool holds(double other_x, double other_y) const {
    return std::hypot(other_x - x, other_y - y) < radius;
  }
};

double free_stiffness(int points, const std::vector<Disc>& discs) {
  const Grid grid{points, points, 1.0, 1.0};
  FourierOperator elasticity = free_halfspace(grid, 1.0);
  return stiffness(elasticity, set_where(grid,
                                         [&](double x, double y) {
                                           return std::ranges::any_of(
                                               discs, [&](const Disc& one) {
                                                 return one.holds(x, y);
                                               });
                                         })) *
         grid.area();
}

// Holm's constriction is that of a circle, k = 2 E* a. The border is a
// staircase, whose error is of first order.
TEST(PunchStiffness, OfACircleIsThatOfHolm) {
  const std::vector<Disc> circle{{0.5, 0.5, 0.3}};

  const double coarse = free_stiffness(64, circle) / 0.6 - 1.0;
  const double fine = free_stiffness(256, circle) / 0.6 - 1.0;

  EXPECT_LT(std::abs(coarse), 0.03);
  EXPECT_LT(std::abs(fine), 0.008);
}

// Greenwood's formula for a cluster of n equal circles with the distances s,
// 1/k = 1/(2 n E* a) + sum over pairs i != j of 1/(pi E* n^2 s), where 1/s
// becomes (1 + a^2/(3 s^2))/s by the width of the circles, with the flux
// 1/sqrt(a^2 - r^2). The stiffness of one circle is that of the same grid.
// Tolerance: the next terms, (a/s)^3 of the interaction, which is 12 % of 1/k.
TEST(PunchStiffness, OfAClusterIsThatOfGreenwood) {
  const double radius = 0.04;
  const std::vector<Disc> four{{0.25, 0.25, radius},
                               {0.75, 0.25, radius},
                               {0.25, 0.75, radius},
                               {0.75, 0.75, radius}};
  const double one = free_stiffness(128, {{0.5, 0.5, radius}});
  const auto inverse = [=](double distance) {
    return (1.0 + radius * radius / (3.0 * distance * distance)) / distance;
  };
  const double pairs =
      4.0 * (2.0 * inverse(0.5) + inverse(std::hypot(0.5, 0.5)));

  const double cluster = free_stiffness(128, four);

  const double greenwood = 1.0 / (4.0 * one) + pairs / (pi * 16.0);
  EXPECT_NEAR(cluster * greenwood, 1.0, 6e-5);
}

class RoughContact : public ::testing::Test {
protected:
  static constexpr Grid grid{64, 64, 1.0, 1.0};
  std::vector<double> heights = problems::rough_heights(grid, {});
  double rms_height = problems::rms(heights);
  FourierOperator elasticity = problems::unit_halfspace(grid);

  ContactSolution solved(double pressure, double compliance = 0.0) {
    return solve_contact(elasticity,
                         {heights, compliance, 1e-13 * rms_height, 3000},
                         {mechanics::Control::nominal_pressure, pressure});
  }

  static std::vector<std::uint8_t> contact_of(const ContactSolution& solution) {
    std::vector<std::uint8_t> set(solution.pressure.size());
    std::ranges::transform(
        solution.pressure, set.begin(),
        [](double p) -> std::uint8_t { return p > 0.0 ? 1 : 0; });
    return set;
  }
};

// A load that is larger by a millionth changes the mean gap by K, because no
// node comes into contact. Tolerance: roundoff of the gap over its change.
TEST_F(RoughContact, StiffnessIsTheSlopeOfTheCurve) {
  for (const double compliance : {0.0, 0.05}) // [m/Pa]
    for (const double pressure : {0.3, 1.0, 4.0}) {
      const ContactSolution now = solved(pressure * rms_height, compliance);
      const ContactSolution later =
          solved(pressure * rms_height * (1.0 + 1e-6), compliance);
      ASSERT_EQ(contact_of(now), contact_of(later));

      const double found = stiffness(elasticity, contact_of(now), compliance);

      const double slope = (later.nominal_pressure - now.nominal_pressure) /
                           (now.mean_gap - later.mean_gap);
      EXPECT_NEAR(found / slope, 1.0, 1e-5);
    }
}

// The contact grows with the load, and with it the stiffness: that of a step
// lies between the secants to the steps before and after it, and above
// p_0/(h_max - u), the secant from the first touch, which is Barber's bound.
TEST_F(RoughContact, StiffnessLiesBetweenTheSecants) {
  const double highest = *std::ranges::max_element(heights);
  std::vector<double> pressures{0.0}, gaps{highest}, found{0.0};
  for (double pressure = 0.01; pressure < 8.0; pressure *= 2.0) {
    const ContactSolution step = solved(pressure * rms_height);
    pressures.push_back(step.nominal_pressure);
    gaps.push_back(step.mean_gap);
    found.push_back(stiffness(elasticity, contact_of(step)));
  }
  for (std::size_t i = 1; i < found.size(); ++i) {
    const double before =
        (pressures[i] - pressures[i - 1]) / (gaps[i - 1] - gaps[i]);
    EXPECT_GE(found[i], before);
    EXPECT_GE(found[i], pressures[i] / (highest - gaps[i]));
    if (i + 1 < found.size()) {
      EXPECT_LE(found[i],
                (pressures[i + 1] - pressures[i]) / (gaps[i] - gaps[i + 1]));
    }
  }
}

// A flat punch of the shape of the contact, pressed by the contact solver.
TEST_F(RoughContact, StiffnessIsThatOfAFlatPunch) {
  const std::vector<std::uint8_t> set = contact_of(solved(rms_height));
  std::vector<double> punch(set.size());
  double mean = 0.0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    punch[i] = set[i] != 0 ? 0.0 : -100.0;
    mean += punch[i] / static_cast<double>(set.size());
  }

  const ContactSolution pressed =
      solve_contact(elasticity, {punch, 0.0, 1e-10, 3000},
                    {mechanics::Control::nominal_pressure, 1.0});

  ASSERT_EQ(contact_of(pressed), set);
  EXPECT_NEAR(stiffness(elasticity, set) * -(pressed.mean_gap + mean), 1.0,
              1e-7);
}

TEST_F(RoughContact, NoContactAndFullContact) {
  const std::vector<std::uint8_t> none(grid.size(), 0), all(grid.size(), 1);
  EXPECT_EQ(stiffness(elasticity, none), 0.0);
  EXPECT_EQ(stiffness(elasticity, all), infinity);
  EXPECT_NEAR(stiffness(elasticity, all, 0.25), 4.0, 1e-12); // springs alone
  EXPECT_THROW(punch_stiffness(elasticity, std::vector<std::uint8_t>(3)),
               std::domain_error);
  EXPECT_THROW(punch_stiffness(elasticity, none, -1.0), std::domain_error);
}

TEST(PunchStiffness, HasTheSameBitsOnThreads) {
  const Grid grid{256, 256, 1.0, 1.0};
  const std::vector<double> heights = problems::rough_heights(grid, {});
  const double level = problems::rms(heights);
  std::vector<std::uint8_t> set(grid.size());
  std::ranges::transform(heights, set.begin(), [=](double height) {
    return static_cast<std::uint8_t>(height > level);
  });
  FourierOperator on_one = problems::unit_halfspace(grid);
  FourierOperator on_threads = problems::unit_halfspace(grid, 3);

  EXPECT_EQ(stiffness(on_threads, set), stiffness(on_one, set));
}

/// A film that is stiff on every third node and softer by up to 1e6 elsewhere.
std::vector<double> uneven_film(std::size_t nodes) {
  std::vector<double> film(nodes);
  for (std::size_t i = 0; i < nodes; ++i)
    film[i] =
        i % 3 == 0
            ? 1e-4
            : 1e-3 * std::pow(10.0, static_cast<double>(i * 7 % 11) / 2.0);
  return film;
}

// A uniform film between flat faces has the conductance of parallel plates.
TEST(PunchStiffness, OfAFilmBetweenFlatFacesIsThatOfPlates) {
  const Grid grid{16, 16, 1.0, 1.0};
  FourierOperator elasticity = problems::unit_halfspace(grid);

  const double found =
      punch_stiffness(elasticity, std::vector<std::uint8_t>(grid.size()), 0.0,
                      std::vector<double>(grid.size(), 0.125))
          .stiffness;

  EXPECT_NEAR(found, 8.0, 1e-12);
}

/// The operator on all nodes as a dense matrix.
template <class Number>
Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>
dense(SurfaceOperator& elasticity) {
  const std::size_t nodes = elasticity.n_nodes();
  const auto n = static_cast<Eigen::Index>(nodes);
  Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> matrix(n, n);
  std::vector<double> unit(nodes), column(nodes);
  for (Eigen::Index j = 0; j < n; ++j) {
    unit[static_cast<std::size_t>(j)] = 1.0;
    elasticity.displacement(unit, column);
    unit[static_cast<std::size_t>(j)] = 0.0;
    matrix.col(j) =
        Eigen::Map<const Eigen::VectorXd>(column.data(), n).cast<Number>();
  }
  return (matrix + matrix.transpose()) / Number(2);
}

/// K by the equations of the nodes in contact, and with a film of all nodes,
/// solved by factors in long double.
long double dense_stiffness(SurfaceOperator& elasticity,
                            const std::vector<std::uint8_t>& set,
                            const std::vector<double>& film = {}) {
  const auto all = dense<long double>(elasticity);
  std::vector<Eigen::Index> acting;
  for (std::size_t i = 0; i < set.size(); ++i)
    if (!film.empty() || set[i] != 0)
      acting.push_back(static_cast<Eigen::Index>(i));
  const auto n = static_cast<Eigen::Index>(acting.size());
  Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> equations =
      all(acting, acting);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto node =
        static_cast<std::size_t>(acting[static_cast<std::size_t>(i)]);
    if (set[node] == 0)
      equations(i, i) += static_cast<long double>(film[node]);
  }
  const Eigen::Vector<long double, Eigen::Dynamic> ones =
      Eigen::Vector<long double, Eigen::Dynamic>::Ones(n);
  return ones.dot(equations.fullPivLu().solve(ones)) /
         static_cast<long double>(set.size());
}

std::vector<double> times(std::vector<double> film, double factor) {
  for (double& compliance : film)
    compliance *= factor;
  return film;
}

// The equations of all nodes as a dense matrix, solved by factors.
TEST(PunchStiffness, OfContactAndFilmSolvesTheEquations) {
  const Grid grid{12, 12, 1.0, 1.0};
  FourierOperator elasticity = problems::unit_halfspace(grid);
  const std::vector<double> film = uneven_film(grid.size());
  const std::vector<std::uint8_t> set = set_where(grid, [](double x, double y) {
    return std::hypot(x - 0.5, y - 0.4) < 0.2;
  });

  const PunchStiffness found = punch_stiffness(elasticity, set, 0.0, film);

  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.stiffness /
                  static_cast<double>(dense_stiffness(elasticity, set, film)),
              1.0, 1e-9);
}

// A film adds the difference of two stiffnesses, of which double precision
// leaves nothing when the film is weak: here it is 1e-11 of each.
TEST(FilmStiffness, IsTheDifferenceHoweverWeakTheFilm) {
  const Grid grid{12, 12, 1.0, 1.0};
  FourierOperator periodic = problems::unit_halfspace(grid);
  FourierOperator free = free_halfspace(grid, 1.0);
  const std::vector<std::uint8_t> set = set_where(grid, [](double x, double y) {
    return std::hypot(x - 0.5, y - 0.4) < 0.2;
  });
  for (SurfaceOperator* const elasticity :
       {static_cast<SurfaceOperator*>(&periodic),
        static_cast<SurfaceOperator*>(&free)}) {
    const long double alone = dense_stiffness(*elasticity, set);
    for (const double factor : {1e-6, 1e-3, 1e-1, 1.0, 1e2, 1e4, 1e6, 1e8}) {
      const std::vector<double> film = times(uneven_film(grid.size()), factor);

      const FilmStiffness found = film_stiffness(*elasticity, set, film);

      const long double exact = dense_stiffness(*elasticity, set, film) - alone;
      EXPECT_TRUE(found.converged) << factor;
      EXPECT_NEAR(found.stiffness / static_cast<double>(exact), 1.0, 1e-7)
          << factor << ": " << found.stiffness << " beside "
          << static_cast<double>(alone);
    }
    // So weak that its pressure is that of the gap alone.
    const auto weak = [&](double factor) {
      return film_stiffness(*elasticity, set,
                            times(uneven_film(grid.size()), factor))
                 .stiffness *
             factor;
    };
    EXPECT_GT(weak(1e12), 0.0);
    EXPECT_NEAR(weak(1e30) / weak(1e12), 1.0, 1e-7);
  }
}

TEST(FilmStiffness, WithoutContactAndInFullContact) {
  const Grid grid{12, 12, 1.0, 1.0};
  FourierOperator periodic = problems::unit_halfspace(grid);
  FourierOperator free = free_halfspace(grid, 1.0);
  const std::vector<std::uint8_t> none(grid.size(), 0), all(grid.size(), 1);
  const std::vector<double> film = uneven_film(grid.size());

  EXPECT_EQ(film_stiffness(periodic, none, film).stiffness,
            punch_stiffness(periodic, none, 0.0, film).stiffness);
  EXPECT_EQ(film_stiffness(periodic, all, film).stiffness, infinity);
  EXPECT_EQ(film_stiffness(free, all, film).stiffness, 0.0);
  EXPECT_THROW(film_stiffness(free, all, {}), std::domain_error);
}

// A film of an extreme compliance is the contact alone, or contact everywhere
// it is thin; the iterations stay bounded.
TEST_F(RoughContact, FilmBetweenItsLimits) {
  const std::vector<std::uint8_t> set = contact_of(solved(rms_height));
  const std::vector<double> film = uneven_film(grid.size());
  const double alone = stiffness(elasticity, set);
  const auto with_film = [&](double factor) {
    std::vector<double> scaled = film;
    for (double& compliance : scaled)
      compliance *= factor;
    const PunchStiffness found = punch_stiffness(elasticity, set, 0.0, scaled);
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.iterations, 90) << factor;
    return found.stiffness;
  };

  const double weak = with_film(1e8) - alone;
  EXPECT_GT(weak, 0.0);
  EXPECT_NEAR(weak / (with_film(2e8) - alone), 2.0, 1e-3);
  double before = alone;
  for (const double factor : {1e4, 1e2, 1.0, 1e-2, 1e-4}) {
    const double now = with_film(factor);
    EXPECT_GT(now, before);
    before = now;
  }
}

} // namespace asperity::contact::punch_stiffness_test
