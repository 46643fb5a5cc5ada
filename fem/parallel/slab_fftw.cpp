#include "fem/parallel/slab_fftw.hpp"

#include "base/fourier_plans.hpp"

#include <fftw3-mpi.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <type_traits>
#include <vector>

namespace asperity::fem {
namespace {

/// The functions of FFTW for a number type.
template <class Real>
struct FftwMpi {
  static constexpr bool is_single = std::is_same_v<Real, float>;
  using Plan = std::conditional_t<is_single, fftwf_plan, fftw_plan>;

  template <class OfSingle, class OfDouble>
  static constexpr auto either(OfSingle of_single, OfDouble of_double) {
    if constexpr (is_single)
      return of_single;
    else
      return of_double;
  }

  static constexpr auto init = either(fftwf_mpi_init, fftw_mpi_init);
  static constexpr auto local_size =
      either(fftwf_mpi_local_size_many_transposed,
             fftw_mpi_local_size_many_transposed);
  static constexpr auto plan_forward =
      either(fftwf_mpi_plan_many_dft_r2c, fftw_mpi_plan_many_dft_r2c);
  static constexpr auto plan_backward =
      either(fftwf_mpi_plan_many_dft_c2r, fftw_mpi_plan_many_dft_c2r);
  static constexpr auto execute = either(fftwf_execute, fftw_execute);
  static constexpr auto destroy = either(fftwf_destroy_plan, fftw_destroy_plan);
  static constexpr auto allocate =
      either(fftwf_alloc_complex, fftw_alloc_complex);
  static constexpr auto release = either(fftwf_free, fftw_free);
};

/// The transforms, in place. Plans by FFTW_ESTIMATE are the same in every run.
template <class Real>
class SlabFftw final : public SlabTransforms<Real> {
  using Library = FftwMpi<Real>;

public:
  using typename SlabTransforms<Real>::Complex;

  SlabFftw(const Grid& grid, int rows, MPI_Comm ranks)
      : width_(static_cast<std::size_t>(grid.points_x)),
        height_(static_cast<std::size_t>(grid.points_y)) {
    const std::lock_guard lock(planner_mutex());
    Library::init();
    const std::array<std::ptrdiff_t, 2> points{grid.points_y, grid.points_x};
    const std::array<std::ptrdiff_t, 2> modes{grid.points_y,
                                              grid.points_x / 2 + 1};
    std::ptrdiff_t own_rows = 0, first_row = 0, count = 0, first = 0;
    const std::ptrdiff_t size =
        Library::local_size(2, modes.data(), 1, rows, FFTW_MPI_DEFAULT_BLOCK,
                            ranks, &own_rows, &first_row, &count, &first);
    columns_ = {static_cast<std::size_t>(first),
                static_cast<std::size_t>(count)};
    auto* const memory = Library::allocate(static_cast<std::size_t>(size));
    memory_.reset(reinterpret_cast<Complex*>(memory));
    auto* const values = reinterpret_cast<Real*>(memory);
    forward_ = Library::plan_forward(
        2, points.data(), 1, rows, FFTW_MPI_DEFAULT_BLOCK, values, memory,
        ranks, FFTW_ESTIMATE | FFTW_MPI_TRANSPOSED_OUT);
    backward_ = Library::plan_backward(
        2, points.data(), 1, FFTW_MPI_DEFAULT_BLOCK, rows, memory, values,
        ranks, FFTW_ESTIMATE | FFTW_MPI_TRANSPOSED_IN);
  }

  SlabFftw(const SlabFftw&) = delete;
  SlabFftw& operator=(const SlabFftw&) = delete;

  ~SlabFftw() override {
    const std::lock_guard lock(planner_mutex());
    Library::destroy(forward_);
    Library::destroy(backward_);
  }

  SpectrumColumns columns() const override { return columns_; }

  std::span<Complex> spectrum() override {
    return {memory_.get(), columns_.count * height_};
  }

  void forward(std::span<const Real> field) override {
    for (std::size_t row = 0; row < field.size() / width_; ++row)
      std::copy_n(&field[row * width_], width_, padded_row(row));
    Library::execute(forward_);
  }

  void backward(std::span<Real> answer) override {
    Library::execute(backward_);
    for (std::size_t row = 0; row < answer.size() / width_; ++row)
      std::copy_n(padded_row(row), width_, &answer[row * width_]);
  }

private:
  struct Release {
    void operator()(Complex* memory) const { Library::release(memory); }
  };

  Real* padded_row(std::size_t row) {
    return reinterpret_cast<Real*>(memory_.get() + row * (width_ / 2 + 1));
  }

  std::size_t width_, height_;
  SpectrumColumns columns_;
  std::unique_ptr<Complex[], Release> memory_;
  typename Library::Plan forward_, backward_;
};

} // namespace

template <class Real>
std::shared_ptr<SlabTransforms<Real>>
slab_transforms(const Grid& grid, int rows, MPI_Comm ranks) {
  return std::make_shared<SlabFftw<Real>>(grid, rows, ranks);
}

template std::shared_ptr<SlabTransforms<float>> slab_transforms(const Grid&,
                                                                int, MPI_Comm);
template std::shared_ptr<SlabTransforms<double>> slab_transforms(const Grid&,
                                                                 int, MPI_Comm);

} // namespace asperity::fem
