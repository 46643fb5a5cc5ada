#include "contact/operators/fourier_operator.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace asperity::contact {

struct FourierOperator::Shared {
  std::vector<double> compliance;
  double softest;    ///< largest C(q) [m/Pa], that of the longest wavelength
  double short_wave; ///< C at half the Nyquist wavevector [m/Pa]
  Convolution<double> exact;
  Convolution<float> convolution;
  Convolution<double>::Symbol exact_symbol;
  Convolution<float>::Symbol symbol;
  mutable std::once_flag coarse_is_made; ///< by the first clone that needs it
  mutable std::shared_ptr<const Shared> coarse;

  Shared(const Grid& grid, std::vector<double> values, int threads);
};

namespace {

void require_compliance(const Grid& grid, std::span<const double> compliance) {
  if (compliance.size() != grid.half_spectrum_size())
    refuse_argument("compliance.size()", static_cast<double>(compliance.size()),
                    "the size of the grid's half spectrum");
  for (std::size_t j = 1; j < compliance.size(); ++j)
    require_positive("compliance", compliance[j], "m/Pa");
}

} // namespace

FourierOperator::Shared::Shared(const Grid& grid, std::vector<double> values,
                                int threads)
    : compliance(std::move(values)),
      softest(1.0),
      exact(grid, threads),
      convolution(grid, threads) {
  if (compliance.size() > 1)
    softest = *std::max_element(compliance.begin() + 1, compliance.end());
  // (points_x/4, 0), or (0, points_y/4) if the x direction has too few points.
  const std::size_t columns = grid.half_spectrum_columns();
  const std::size_t half_nyquist =
      grid.points_x >= 4
          ? static_cast<std::size_t>(grid.points_x) / 4
          : columns * (static_cast<std::size_t>(grid.points_y) / 4);
  short_wave = half_nyquist > 0 ? compliance[half_nyquist] : softest;
  compliance[0] = 0.0;
  exact_symbol = exact.arranged(compliance);
  symbol = convolution.arranged(compliance);
}

FourierOperator::FourierOperator(const Grid& grid,
                                 std::vector<double> compliance, int threads) {
  require_compliance(grid, compliance);
  shared_ =
      std::make_shared<const Shared>(grid, std::move(compliance), threads);
}

FourierOperator::FourierOperator(std::shared_ptr<const Shared> shared)
    : shared_(std::move(shared)) {}

std::unique_ptr<SurfaceOperator> FourierOperator::clone() const {
  return std::unique_ptr<SurfaceOperator>(new FourierOperator(shared_));
}

const Grid& FourierOperator::grid() const {
  return shared_->exact.grid();
}

double FourierOperator::short_wave_compliance() const {
  return shared_->short_wave;
}

int FourierOperator::threads() const {
  return shared_->exact.threads();
}

std::span<const double> FourierOperator::compliance() const {
  return shared_->compliance;
}

std::unique_ptr<SurfaceOperator> FourierOperator::coarsened() const {
  const std::optional<Grid> coarse = coarse_grid(grid());
  if (!coarse)
    return nullptr;
  std::call_once(shared_->coarse_is_made, [&] {
    shared_->coarse = std::make_shared<const Shared>(
        *coarse, coarse_spectrum(grid(), *coarse, shared_->compliance),
        threads());
  });
  return std::unique_ptr<SurfaceOperator>(new FourierOperator(shared_->coarse));
}

void FourierOperator::displacement(std::span<const double> pressure,
                                   std::span<double> displacement) {
  shared_->exact.apply(pressure, shared_->exact_symbol, exact_scratch_,
                       displacement);
}

void FourierOperator::displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change) {
  shared_->convolution.apply(pressure_change, shared_->symbol, scratch_,
                             displacement_change);
}

void FourierOperator::pressure_estimate(std::span<const float> gap,
                                        double local_compliance,
                                        std::span<float> pressure) {
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  if (inverted_compliance_ != local_compliance) {
    std::vector<double> inverse = shared_->compliance;
    // The compliance of the uniform mode is undefined here; that of the longest
    // wavelength replaces it.
    inverse[0] = shared_->softest;
    for (double& value : inverse)
      value = 1.0 / (value + local_compliance);
    inverse_ = shared_->convolution.arranged(inverse);
    inverted_compliance_ = local_compliance;
  }
  shared_->convolution.apply(gap, inverse_, scratch_, pressure);
}

} // namespace asperity::contact
