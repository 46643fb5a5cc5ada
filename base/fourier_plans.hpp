#pragma once

// Common names for FFTW in single and double precision, for sources that plan
// transforms.

#include <fftw3.h>

#include <complex>
#include <mutex>

namespace asperity {

/// Protects FFTW's planner, which is not thread safe; executing a plan is. A
/// process has one planner per precision and must have a single mutex,
/// therefore this module is a shared library.
std::mutex& planner_mutex();

template <class Real>
struct Fftw;

template <>
struct Fftw<double> {
  using Plan = fftw_plan;
  using Complex = fftw_complex;
  static constexpr auto plan_row = fftw_plan_dft_r2c_1d;
  static constexpr auto plan_row_back = fftw_plan_dft_c2r_1d;
  static constexpr auto plan_columns = fftw_plan_many_dft;
  static constexpr auto forward_row = fftw_execute_dft_r2c;
  static constexpr auto backward_row = fftw_execute_dft_c2r;
  static constexpr auto columns = fftw_execute_dft;
  static constexpr auto destroy = fftw_destroy_plan;
};

template <>
struct Fftw<float> {
  using Plan = fftwf_plan;
  using Complex = fftwf_complex;
  static constexpr auto plan_row = fftwf_plan_dft_r2c_1d;
  static constexpr auto plan_row_back = fftwf_plan_dft_c2r_1d;
  static constexpr auto plan_columns = fftwf_plan_many_dft;
  static constexpr auto forward_row = fftwf_execute_dft_r2c;
  static constexpr auto backward_row = fftwf_execute_dft_c2r;
  static constexpr auto columns = fftwf_execute_dft;
  static constexpr auto destroy = fftwf_destroy_plan;
};

} // namespace asperity
