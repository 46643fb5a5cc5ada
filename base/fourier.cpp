#include "base/fourier.hpp"

#include "base/fourier_plans.hpp"
#include "base/parallel_rows.hpp"

#include <cassert>
#include <mutex>
#include <stdexcept>

namespace asperity {

std::mutex& planner_mutex() {
  static std::mutex mutex;
  return mutex;
}

namespace {

fftw_complex* as_fftw(std::complex<double>* spectrum) {
  return reinterpret_cast<fftw_complex*>(spectrum);
}

/// FFTW's parallel loop over its n_jobs, run by the persistent threads.
void run_jobs(void* (*do_job)(char*), char* jobs, std::size_t job_size,
              int n_jobs, void*) {
  parallel_rows(n_jobs, n_jobs, [&](int job) {
    do_job(jobs + static_cast<std::size_t>(job) * job_size);
  });
}

/// Makes FFTW use these threads; returns 0 if FFTW cannot use threads.
int start_threads() {
  const int ready = fftw_init_threads();
  fftw_threads_set_callback(run_jobs, nullptr);
  return ready;
}

} // namespace

struct RealFourier::Plans {
  fftw_plan forward = nullptr;
  fftw_plan backward = nullptr;

  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  Plans(const Grid& grid, int threads) {
    const std::lock_guard lock(planner_mutex());
    static const int threads_ready = start_threads();
    if (threads_ready == 0)
      throw std::runtime_error("FFTW could not start its threads");
    fftw_plan_with_nthreads(threads);
    // Only the alignment of these arrays matters: FFTW_ESTIMATE does not access
    // them, and the plans are executed on other arrays.
    double* field = fftw_alloc_real(grid.size());
    fftw_complex* spectrum = fftw_alloc_complex(grid.half_spectrum_size());
    forward = fftw_plan_dft_r2c_2d(grid.points_y, grid.points_x, field,
                                   spectrum, FFTW_ESTIMATE);
    backward = fftw_plan_dft_c2r_2d(grid.points_y, grid.points_x, spectrum,
                                    field, FFTW_ESTIMATE);
    fftw_free(field);
    fftw_free(spectrum);
  }

  ~Plans() {
    const std::lock_guard lock(planner_mutex());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
  }
};

RealFourier::RealFourier(const Grid& grid, int threads)
    : grid_(grid), plans_(std::make_unique<Plans>(grid, threads)) {}

RealFourier::~RealFourier() = default;
RealFourier::RealFourier(RealFourier&&) noexcept = default;
RealFourier& RealFourier::operator=(RealFourier&&) noexcept = default;

void RealFourier::forward(std::span<const double> field,
                          std::span<std::complex<double>> spectrum) const {
  assert(field.size() == grid_.size());
  assert(spectrum.size() == grid_.half_spectrum_size());
  assert(fftw_alignment_of(const_cast<double*>(field.data())) == 0);
  // An out-of-place real-to-complex transform preserves its input, so FFTW does
  // not write in spite of the cast.
  fftw_execute_dft_r2c(plans_->forward, const_cast<double*>(field.data()),
                       as_fftw(spectrum.data()));
}

void RealFourier::backward(std::span<std::complex<double>> spectrum,
                           std::span<double> field) const {
  assert(field.size() == grid_.size());
  assert(spectrum.size() == grid_.half_spectrum_size());
  fftw_execute_dft_c2r(plans_->backward, as_fftw(spectrum.data()),
                       field.data());
}

std::string fourier_library() {
  return fftw_version;
}

} // namespace asperity
