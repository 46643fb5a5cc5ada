#include "contact/operators/fourier_operator.hpp"

#include "base/require.hpp"

#include <algorithm>
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
  const Grid& fine = grid();
  const std::optional<Grid> every_second = coarse_grid(grid());
  if (!every_second)
    return nullptr;
  const Grid& coarse = *every_second;
  const std::size_t fine_columns = fine.half_spectrum_columns();
  const int coarse_columns = coarse.points_x / 2 + 1;
  std::vector<double> compliance;
  compliance.reserve(coarse.half_spectrum_size());
  for (int jy = 0; jy < coarse.points_y; ++jy) {
    const int wavenumber = signed_wavenumber(jy, coarse.points_y);
    const int row = wavenumber < 0 ? wavenumber + fine.points_y : wavenumber;
    for (int jx = 0; jx < coarse_columns; ++jx)
      compliance.push_back(
          shared_->compliance[static_cast<std::size_t>(row) * fine_columns +
                              static_cast<std::size_t>(jx)]);
  }
  return std::unique_ptr<SurfaceOperator>(
      new FourierOperator(std::make_shared<const Shared>(
          coarse, std::move(compliance), threads())));
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
