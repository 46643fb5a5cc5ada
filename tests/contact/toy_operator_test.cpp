// A surface operator of one file, solved through the public entry and
// certified: docs/extending.md. Independent springs, C p = (p - <p>)/k, whose
// contact has a closed form, winkler.hpp.
#include "contact/certificate/certificate.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "contact/solvers/winkler.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>

namespace asperity::contact::toy_operator_test {

class Springs final : public SurfaceOperator {
public:
  Springs(const Grid& grid, double stiffness)
      : SurfaceOperator({.rows = SharedRows(grid),
                         .short_wave_compliance = 1.0 / stiffness}) {}

protected:
  std::unique_ptr<SurfaceOperator> do_clone() const override {
    return std::make_unique<Springs>(*this);
  }

  void do_displacement(std::span<const double> pressure,
                       std::span<double> displacement) override {
    const double mean = std::accumulate(pressure.begin(), pressure.end(), 0.0) /
                        static_cast<double>(pressure.size());
    for (std::size_t i = 0; i < pressure.size(); ++i)
      displacement[i] = (pressure[i] - mean) * short_wave_compliance();
  }
};

constexpr Grid grid{64, 64, 1.0, 1.0};
constexpr double stiffness = 3e5;

// Tolerance: that of the solver, times the stiffness for pressures.
TEST(ToyOperator, IsSolvedAndCertifiedLikeAnyOther) {
  const std::vector<double> heights = problems::rough_heights(grid, {});
  const double tolerance = 1e-9 * problems::rms(heights);
  LoadSequence path(std::make_unique<Springs>(grid, stiffness), heights, {},
                    tolerance, 500);
  for (const double load : {1e-3, 0.1, 3.0}) {
    const mechanics::LoadTarget target{mechanics::Control::nominal_pressure,
                                       load * stiffness *
                                           problems::rms(heights)};
    const ContactSolution exact = winkler_contact(heights, stiffness, target);

    const ContactSolution found = path.solve(target);

    ASSERT_TRUE(found.converged) << found.note;
    EXPECT_TRUE(found.note.empty()) << found.note;
    EXPECT_NEAR(found.mean_gap, exact.mean_gap, 2.0 * tolerance);
    for (std::size_t i = 0; i < heights.size(); ++i)
      ASSERT_NEAR(found.pressure[i], exact.pressure[i],
                  4.0 * tolerance * stiffness);
    const FieldCheck check = check_field(
        path.elasticity(), {heights, 0.0, target.amount, found.pressure});
    EXPECT_LE(std::abs(check.mean_gap - exact.mean_gap), check.mean_gap_error);
    EXPECT_LT(check.mean_gap_error, 1e-3 * problems::rms(heights));
  }
}

// The public calls add their time to one number, also those of the operators
// that are made from a measured one.
TEST(ToyOperator, IsMeasuredByItsCaller) {
  const auto seconds = std::make_shared<double>(0.0);
  const auto spent = [&](SurfaceOperator& used) {
    *seconds = 0.0;
    std::vector<double> p(used.n_nodes(), 1.0), w(used.n_nodes());
    used.displacement(p, w);
    return *seconds;
  };
  Springs springs(grid, stiffness);
  FourierOperator halfspace = problems::unit_halfspace(grid);
  for (SurfaceOperator* const own :
       {static_cast<SurfaceOperator*>(&springs),
        static_cast<SurfaceOperator*>(&halfspace)}) {
    EXPECT_EQ(spent(*own), 0.0);
    own->measure(seconds);
    EXPECT_GT(spent(*own), 0.0);
    EXPECT_GT(spent(*own->clone()), 0.0);
  }
  EXPECT_GT(spent(*halfspace.coarsened()), 0.0);
}

} // namespace asperity::contact::toy_operator_test
