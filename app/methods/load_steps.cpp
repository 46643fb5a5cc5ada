#include "app/methods/load_steps.hpp"

#include "app/methods/timed_operator.hpp"

#include <utility>

namespace asperity::app {
namespace {

class OwnLoadSteps final : public LoadSteps {
public:
  OwnLoadSteps(std::unique_ptr<contact::SurfaceOperator> elasticity,
               std::vector<double> heights, const LoadStepsSetting& setting)
      : sequence_(std::make_unique<TimedOperator>(std::move(elasticity), tally_,
                                                  setting.threads),
                  std::move(heights), setting.interface, setting.gap_tolerance,
                  setting.max_iterations) {}

  contact::ContactSolution solve(const mechanics::LoadTarget& target) override {
    tally_->cpu_time = 0.0;
    contact::ContactSolution solution = sequence_.solve(target);
    transform_time_ = tally_->cpu_time;
    return solution;
  }

  double transform_time() const override { return transform_time_; }

  std::vector<double> memory() const override { return sequence_.memory(); }

  void recall(std::span<const double> memory) override {
    sequence_.recall(memory);
  }

  contact::SurfaceOperator& elasticity() override {
    return sequence_.elasticity();
  }

private:
  std::shared_ptr<TimedOperator::Tally> tally_ =
      std::make_shared<TimedOperator::Tally>();
  contact::LoadSequence sequence_;
  double transform_time_ = 0.0;
};

} // namespace

std::unique_ptr<LoadSteps>
make_load_steps(std::unique_ptr<contact::SurfaceOperator> elasticity,
                std::vector<double> heights, const LoadStepsSetting& setting) {
  return std::make_unique<OwnLoadSteps>(std::move(elasticity),
                                        std::move(heights), setting);
}

} // namespace asperity::app
