#include "contact/fourier_operator.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

namespace asperity::contact {

struct FourierOperator::Shared {
  RealFourier fourier;
  std::vector<double> compliance;
  double softest;    ///< largest C(q), of the longest wave [m/Pa]
  double short_wave; ///< C at half the Nyquist wavevector [m/Pa]
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

FourierOperator::FourierOperator(const Grid& grid,
                                 std::vector<double> compliance, int threads) {
  require_compliance(grid, compliance);
  const auto uniform = compliance.begin();
  const double softest = compliance.size() > 1
                             ? *std::max_element(uniform + 1, compliance.end())
                             : 1.0;
  // (points_x/4, 0) and (0, points_y/4), whichever direction is resolved.
  const std::size_t columns = static_cast<std::size_t>(grid.points_x / 2 + 1);
  const std::size_t half_nyquist =
      grid.points_x >= 4
          ? static_cast<std::size_t>(grid.points_x / 4)
          : columns * static_cast<std::size_t>(grid.points_y / 4);
  const double short_wave =
      half_nyquist > 0 ? compliance[half_nyquist] : softest;
  shared_ = std::make_shared<const Shared>(Shared{
      RealFourier(grid, threads), std::move(compliance), softest, short_wave});
  spectrum_.resize(grid.half_spectrum_size());
}

FourierOperator::FourierOperator(std::shared_ptr<const Shared> shared)
    : shared_(std::move(shared)),
      spectrum_(shared_->fourier.grid().half_spectrum_size()) {}

std::unique_ptr<SurfaceOperator> FourierOperator::clone() const {
  return std::unique_ptr<SurfaceOperator>(new FourierOperator(shared_));
}

const Grid& FourierOperator::grid() const {
  return shared_->fourier.grid();
}

double FourierOperator::short_wave_compliance() const {
  return shared_->short_wave;
}

std::span<const double> FourierOperator::compliance() const {
  return shared_->compliance;
}

std::unique_ptr<SurfaceOperator> FourierOperator::coarsened() const {
  const Grid& fine = grid();
  if (fine.points_x % 2 != 0 || fine.points_y % 2 != 0 || fine.points_x < 64 ||
      fine.points_y < 64)
    return nullptr;
  const Grid coarse{fine.points_x / 2, fine.points_y / 2, fine.length_x,
                    fine.length_y};
  const std::size_t fine_columns =
      static_cast<std::size_t>(fine.points_x / 2 + 1);
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
  return std::make_unique<FourierOperator>(coarse, std::move(compliance));
}

void FourierOperator::displacement(std::span<const double> pressure,
                                   std::span<double> displacement) {
  shared_->fourier.forward(pressure, spectrum_);
  const double normalise = 1.0 / static_cast<double>(grid().size());
  const std::vector<double>& compliance = shared_->compliance;
  spectrum_[0] = 0.0;
  for (std::size_t j = 1; j < spectrum_.size(); ++j)
    spectrum_[j] *= compliance[j] * normalise;
  shared_->fourier.backward(spectrum_, displacement);
}

void FourierOperator::pressure_estimate(std::span<const double> gap,
                                        double local_compliance,
                                        std::span<double> pressure) {
  assert(local_compliance >= 0.0);
  shared_->fourier.forward(gap, spectrum_);
  const double normalise = 1.0 / static_cast<double>(grid().size());
  const std::vector<double>& compliance = shared_->compliance;
  // The uniform mode has no compliance of its own: treat it as the longest.
  spectrum_[0] *= normalise / (shared_->softest + local_compliance);
  for (std::size_t j = 1; j < spectrum_.size(); ++j)
    spectrum_[j] *= normalise / (compliance[j] + local_compliance);
  shared_->fourier.backward(spectrum_, pressure);
}

} // namespace asperity::contact
