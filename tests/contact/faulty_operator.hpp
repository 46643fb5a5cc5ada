#pragma once

// An elastic operator that returns a number that is not finite, once or from
// some call on. A solver must not accept it as a solution.

#include "contact/operators/fourier_operator.hpp"

#include <limits>
#include <memory>
#include <utility>

namespace asperity::contact::problems {

/// Which application fails, when, and with which value.
struct Fault {
  enum class Call { displacement, change, estimate } call = Call::displacement;
  int after = 0;         ///< correct calls before it
  int times = 1;         ///< calls that fail
  bool is_whole = false; ///< the whole field or its last node only
  double value = std::numeric_limits<double>::quiet_NaN();
};

class FaultyOperator final : public SurfaceOperator {
public:
  FaultyOperator(FourierOperator exact, const Fault& fault)
      : SurfaceOperator(
            {.rows = exact.rows(),
             .short_wave_compliance = exact.short_wave_compliance()}),
        exact_(std::move(exact)),
        fault_(fault) {}

protected:
  std::unique_ptr<SurfaceOperator> do_clone() const override {
    return std::make_unique<FaultyOperator>(*this);
  }

  void do_displacement(std::span<const double> pressure,
                       std::span<double> displacement) override {
    exact_.displacement(pressure, displacement);
    inject(Fault::Call::displacement, displacement);
  }

  void do_displacement_change(std::span<const float> pressure_change,
                              std::span<float> displacement_change) override {
    exact_.displacement_change(pressure_change, displacement_change);
    inject(Fault::Call::change, displacement_change);
  }

  void do_pressure_estimate(std::span<const float> gap, double local_compliance,
                            std::span<float> pressure) override {
    exact_.pressure_estimate(gap, local_compliance, pressure);
    inject(Fault::Call::estimate, pressure);
  }

  /// Fails in the same way.
  std::unique_ptr<SurfaceOperator> do_coarsened() const override {
    const std::unique_ptr<SurfaceOperator> coarse = exact_.coarsened();
    if (!coarse)
      return nullptr;
    return std::make_unique<FaultyOperator>(
        dynamic_cast<const FourierOperator&>(*coarse), fault_);
  }

private:
  template <class Number>
  void inject(Fault::Call call, std::span<Number> field) {
    if (call != fault_.call)
      return;
    const int so_far = calls_++;
    if (so_far < fault_.after || so_far >= fault_.after + fault_.times)
      return;
    for (std::size_t i = fault_.is_whole ? 0 : field.size() - 1;
         i < field.size(); ++i)
      field[i] = static_cast<Number>(fault_.value);
  }

  FourierOperator exact_;
  Fault fault_;
  int calls_ = 0;
};

} // namespace asperity::contact::problems
