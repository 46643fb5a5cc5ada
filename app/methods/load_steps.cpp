#include "app/methods/load_steps.hpp"

#include "app/methods/timed_operator.hpp"
#include "base/array_memory.hpp"
#include "base/cpu_clock.hpp"
#include "base/field_sums.hpp"
#include "contact/certificate/certificate.hpp"

#include <utility>

namespace asperity::app {
namespace {

class OwnLoadSteps final : public LoadSteps {
public:
  OwnLoadSteps(std::unique_ptr<contact::SurfaceOperator> elasticity,
               std::vector<double> heights, const LoadStepsSetting& setting)
      : threads_(setting.threads),
        observation_(setting.observation),
        sequence_(std::make_unique<TimedOperator>(std::move(elasticity), tally_,
                                                  setting.threads),
                  std::move(heights), setting.interface, setting.gap_tolerance,
                  setting.max_iterations) {
    const contact::SurfaceOperator& c = sequence_.elasticity();
    surface_.record.grid = c.grid();
    surface_.scales.rms_height = setting.rms_height;
    observation_.nodal_weights = c.nodal_weights();
    observation_.border =
        c.is_periodic() ? results::Border::periodic : results::Border::free;
    observation_.workers = {setting.threads, c.grid(), c.shared_rows()};
  }

  StepAnswer solve(const StepTarget& target) override {
    tally_->cpu_time = 0.0;
    contact::ContactSolution solution = sequence_.solve(target.load);
    const int transforms = solution.transforms;
    const double transform_time = tally_->cpu_time;
    const CpuClock clock(threads_);
    StepAnswer answer = observe(std::move(solution), observation_, surface_);
    if (observation_.workers.rows != nullptr) {
      const bool is_finite =
          all_finite(answer.pressure) && all_finite(answer.gap);
      answer.has_finite_fields =
          total_count(observation_.workers, is_finite ? 0 : 1) == 0;
      if (!target.needs_maps)
        free_memory(answer.gap);
    }
    certify(answer);
    answer.row.observation_time = clock.seconds();
    answer.row.transforms = transforms;
    answer.row.transform_time = transform_time;
    return answer;
  }

  SavedState memory() const override { return saved_state(sequence_.memory()); }

  void recall(const StateReader& memory) override {
    sequence_.recall(memory.all());
  }

private:
  /// Bounds the error of the mean gap by one more application of the operator,
  /// which the solver has no part in.
  void certify(StepAnswer& answer) {
    if (!(answer.row.nominal_pressure > 0.0))
      return; // without contact the mean gap is prescribed
    results::RowObserver observe(answer.row);
    observe("certified_gap_error", [&] {
      return contact::check_field(sequence_.elasticity(),
                                  {sequence_.heights(),
                                   observation_.local_compliance,
                                   answer.row.nominal_pressure, answer.pressure,
                                   answer.row.mean_gap})
          .mean_gap_error;
    });
  }

  int threads_;
  Observation observation_;
  SurfaceOfCase surface_; ///< grid and rms height only
  std::shared_ptr<TimedOperator::Tally> tally_ =
      std::make_shared<TimedOperator::Tally>();
  contact::LoadSequence sequence_;
};

} // namespace

std::unique_ptr<LoadSteps>
make_load_steps(std::unique_ptr<contact::SurfaceOperator> elasticity,
                std::vector<double> heights, const LoadStepsSetting& setting) {
  return std::make_unique<OwnLoadSteps>(std::move(elasticity),
                                        std::move(heights), setting);
}

} // namespace asperity::app
