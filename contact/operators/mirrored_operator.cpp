#include "contact/operators/mirrored_operator.hpp"

#include <utility>

namespace asperity::contact {

MirroredOperator::MirroredOperator(Symbol symbol, int threads)
    : SurfaceOperator(
          {.rows = SharedRows(quarter_of(symbol.compliance->grid())),
           .short_wave_compliance = symbol.short_wave,
           .threads = threads,
           .has_inverse = true}),
      symbol_(std::move(symbol)),
      exact_(symbol_.compliance->grid(), threads),
      estimate_(symbol_.compliance->grid(), threads) {}

std::unique_ptr<SurfaceOperator> MirroredOperator::do_clone() const {
  return std::make_unique<MirroredOperator>(symbol_, threads());
}

void MirroredOperator::do_displacement(std::span<const double> pressure,
                                       std::span<double> displacement) {
  exact_.apply(pressure, columns_of(*symbol_.compliance), displacement);
}

void MirroredOperator::do_pressure_of(std::span<const double> displacement,
                                      std::span<double> pressure) {
  exact_.apply(displacement, inverse_columns_of(*symbol_.compliance), pressure);
}

void MirroredOperator::do_pressure_estimate(std::span<const float> gap,
                                            double local_compliance,
                                            std::span<float> pressure) {
  const EvenColumn known = columns_of(*symbol_.compliance);
  estimate_.apply(
      gap,
      [&](int jx, std::span<double> of_jy) {
        known(jx, of_jy);
        if (jx == 0) // the uniform mode has none: FourierOperator
          of_jy[0] = symbol_.softest;
        for (double& value : of_jy)
          value = 1.0 / (value + local_compliance);
      },
      pressure);
}

} // namespace asperity::contact
