// A material law of one file, run through the full block: a body that stiffens
// as it is compressed, of which uniaxial strain has a closed form.
#include "fem/material/material_law.hpp"
#include "fem/solution/meshed_block.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::fem::material_law_test {

constexpr double length = 1e-6; // m
const Moduli elastic = moduli(mechanics::BodyModuli{soft_modulus, 0.3});

/// sigma = C : epsilon - b c^2 1 with the compression c = max(-tr epsilon, 0),
/// of which the history keeps the value.
class StiffeningLaw final : public MaterialLaw {
public:
  explicit StiffeningLaw(double stiffening) : stiffening_(stiffening) {}

  std::size_t n_history() const override { return 1; }

  PointResponse respond(const dealii::SymmetricTensor<2, 3>& strain,
                        const dealii::SymmetricTensor<2, 3>& /*before*/,
                        const Moduli& moduli,
                        std::span<double> history) const override {
    const double bulk = moduli.lame_modulus + 2.0 / 3.0 * moduli.shear_modulus;
    const double compression = std::max(-dealii::trace(strain), 0.0);
    history[0] = compression;
    PointResponse response;
    response.is_elastic = false;
    response.inelastic_strain = stiffening_ * compression * compression /
                                (3.0 * bulk) *
                                dealii::unit_symmetric_tensor<3>();
    response.tangent = {moduli.lame_modulus + 2.0 * stiffening_ * compression,
                        moduli.shear_modulus,
                        {}};
    return response;
  }

  std::vector<MaterialQuantity> quantities() const override {
    return {{"compression", false, [](auto history) { return history[0]; }},
            {"fold", true, [](auto history) { return history[0]; }}};
  }

private:
  double stiffening_; ///< b [Pa]
};

// A flat block under a pressure p has the strain e of
//
//     p = (lambda + 2 mu) e + b e^2,
//
// whatever pressures were before, and its surface moves by e times its depth.
// Tolerance: that of the balance of forces.
TEST(MaterialLaw, OfOneFileRunsThroughTheBlock) {
  const double stiffening = 20.0 * soft_modulus;
  BlockProblem problem =
      boxes_problem({8, 8, length, length}, 2, {soft_modulus, 0.3}, length);
  problem.law = std::make_shared<StiffeningLaw>(stiffening);
  MeshedBlock block(problem);
  const std::vector<double> heights(block.grid().size(), 0.0);
  const double modulus = elastic.lame_modulus + 2.0 * elastic.shear_modulus;
  for (const double share : {0.05, 0.2, 0.1}) {
    const double pressure = share * soft_modulus;
    const double strain =
        (std::sqrt(modulus * modulus + 4.0 * stiffening * pressure) - modulus) /
        (2.0 * stiffening);

    BlockSolution found =
        block.solve(heights, {mechanics::Control::nominal_pressure, pressure},
                    {mechanics::ContactLaw::hard, 100.0 * soft_modulus / length,
                     1e-10, 100});

    ASSERT_TRUE(found.converged) << found.note;
    EXPECT_LT(strain, 0.9 * pressure / modulus);
    EXPECT_NEAR(-block.newton().state().rigid_gap, strain * length,
                1e-8 * strain * length);
    EXPECT_NEAR(block.strongest_stress().von_mises,
                2.0 * elastic.shear_modulus * strain, 1e-8 * pressure);
    EXPECT_NEAR(found.of_material["compression"], strain, 1e-8 * strain);
    EXPECT_NEAR(found.of_material["fold"], strain * length,
                1e-8 * strain * length);
    EXPECT_TRUE(std::isnan(found.elastic_energy));
  }
}

} // namespace asperity::fem::material_law_test
