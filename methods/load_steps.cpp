#include "methods/load_steps.hpp"

#include "base/array_memory.hpp"
#include "base/cpu_clock.hpp"
#include "base/field_sums.hpp"
#include "contact/certificate/certificate.hpp"
#include "methods/timed_operator.hpp"
#include "ranks/node_sums.hpp"
#include "ranks/rank_sums.hpp"
#include "ranks/rows_from_rank_0.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace asperity::methods {
namespace {

/// Passes the memory of all ranks to rank 0, with whole fields: a number, then
/// a number and a field for the imprint, if there is one, and for each step.
void pass_memory(const SharedRows& rows, std::span<const double> own,
                 const results::TakeValues& take) {
  const bool takes = rows.ranks()->rank() == 0;
  if (takes)
    take(own.first(1));
  for (std::size_t at = 1; at < own.size(); at += 1 + rows.size()) {
    if (takes)
      take(own.subspan(at, 1));
    rows.pass_to_rank_0(own.subspan(at + 1, rows.size()), take);
  }
}

/// Divides a memory that rank 0 reads among the ranks.
std::vector<double> own_memory(const SharedRows& rows,
                               const StateReader& memory) {
  const std::size_t nodes = rows.grid().size();
  const std::size_t steps =
      memory.count == 0 ? 0 : (memory.count - 1) / (nodes + 1);
  if (memory.count != 0 &&
      (steps < 1 || steps > 3 || memory.count != 1 + steps * (nodes + 1)))
    throw std::domain_error("a saved state has another number of nodes");
  std::vector<double> own(memory.count == 0 ? 0
                                            : 1 + steps * (rows.size() + 1));
  const auto take_number = [&](double& number) {
    if (rows.ranks()->rank() == 0)
      memory.next(std::span(&number, 1));
    number = of_ranks(rows.ranks(), number).front();
  };
  if (!own.empty())
    take_number(own.front());
  for (std::size_t at = 1; at < own.size(); at += 1 + rows.size()) {
    take_number(own[at]);
    std::ranges::copy(rows_from_rank_0(rows, memory.next),
                      own.begin() + static_cast<std::ptrdiff_t>(at + 1));
  }
  return own;
}

/// Of the mean of many numbers, relative to the largest.
constexpr double rounding_of_sums = 1e-13;

/// The largest absolute value on all ranks.
double largest_of(std::span<const double> field, const Workers& workers) {
  return chunked_sum<Largest>(field.size(), workers,
                              [=](std::size_t begin, std::size_t end) {
                                Largest own{0.0};
                                for (std::size_t i = begin; i < end; ++i)
                                  own += {std::abs(field[i])};
                                return own;
                              })
      .value;
}

class LoadSteps final : public StepSolver {
public:
  LoadSteps(std::unique_ptr<contact::SurfaceOperator> elasticity,
            std::vector<double> heights, const LoadStepsSetting& setting)
      : threads_(setting.threads),
        gap_tolerance_(setting.gap_tolerance),
        saved_setup_time_(setting.saved_setup_time),
        observation_(setting.observation),
        sequence_(std::make_unique<TimedOperator>(std::move(elasticity), tally_,
                                                  setting.threads),
                  std::move(heights), setting.interface, setting.gap_tolerance,
                  setting.max_iterations) {
    const contact::SurfaceOperator& c = sequence_.elasticity();
    surface_.record.grid = c.grid();
    surface_.scales.rms_height = setting.rms_height;
    observation_.nodal_weights = c.nodal_weights();
    observation_.workers = {setting.threads, c.grid(), c.shared_rows()};
  }

  StepAnswer find(const StepTarget& target) override {
    free_memory(pressure_, gap_);
    tally_->cpu_time = 0.0;
    contact::ContactSolution solution = sequence_.solve(target.load);
    const int transforms = solution.transforms;
    const double transform_time = tally_->cpu_time;
    const CpuClock clock(threads_);
    const Reached reached = reached_by(solution);
    StepAnswer answer = observe(std::move(solution), observation_, surface_);
    answer.reached = reached;
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
    if (observation_.workers.rows != nullptr)
      keep_rows(target, answer);
    return answer;
  }

  SavedState state() const override {
    const SharedRows* const rows = observation_.workers.rows;
    std::vector<double> memory = sequence_.memory();
    if (rows == nullptr || memory.empty())
      return saved_state(std::move(memory));
    const std::size_t steps = (memory.size() - 1) / (rows->size() + 1);
    return {1 + steps * (rows->grid().size() + 1),
            [this, rows](const results::TakeValues& take) {
              pass_memory(*rows, sequence_.memory(), take);
            }};
  }

  bool restore(const StateReader& state) override {
    const SharedRows* const rows = observation_.workers.rows;
    sequence_.recall(rows == nullptr ? state.all() : own_memory(*rows, state));
    return true;
  }

  double saved_setup_time() const override { return saved_setup_time_; }

private:
  /// Collective.
  Reached reached_by(const contact::ContactSolution& solution) {
    const Workers& workers = observation_.workers;
    const std::span<const double> heights = sequence_.heights();
    const double* const p = solution.pressure.data();
    const double* const g = solution.gap.data();
    const auto mean_of = [&](const auto& value) {
      return weighted_sum(observation_.nodal_weights, heights.size(), workers,
                          value) /
             static_cast<double>(workers.all_nodes(heights.size()));
    };
    const double borne = mean_of([=](std::size_t i) { return std::abs(p[i]); });
    const double height = largest_of(heights, workers);
    const double depth = std::max(std::abs(solution.mean_gap),
                                  observation_.local_compliance *
                                      largest_of(solution.pressure, workers));
    Reached reached;
    reached.nominal_pressure = solution.nominal_pressure;
    reached.mean_gap = solution.mean_gap;
    reached.imbalance = 0.0; // the gap_error bounds it
    if (observation_.adhesion)
      reached.imbalance =
          mean_of([=, law = *observation_.adhesion](std::size_t i) {
            return g[i] > 0.0 || !mechanics::has_wall(law.law)
                       ? p[i] - law.pressure(g[i])
                       : 0.0;
          });
    const double tolerance = gap_tolerance_ / surface_.scales.rms_height;
    reached.pressure_tolerance = std::max(
        solution.load_tolerance, std::max(tolerance, rounding_of_sums) * borne);
    reached.gap_tolerance =
        std::max(gap_tolerance_, rounding_of_sums * (height + depth));
    reached.is_detached = solution.is_detached;
    return reached;
  }

  /// Keeps the rows of this rank until the next call, if they are needed.
  void keep_rows(const StepTarget& target, StepAnswer& answer) {
    if (target.needs_maps) {
      pressure_ = std::move(answer.pressure);
      gap_ = std::move(answer.gap);
      const auto passed = [this](const std::vector<double>& own) {
        return [this, &own](const results::TakeValues& take) {
          observation_.workers.rows->pass_to_rank_0(own, take);
        };
      };
      answer.rows = {passed(pressure_), passed(gap_)};
    }
    free_memory(answer.pressure, answer.gap);
  }

  /// Bounds the error of the mean gap by one more application of the operator,
  /// which the solver has no part in.
  void certify(StepAnswer& answer) {
    if (!(answer.row.nominal_pressure > 0.0) || observation_.adhesion ||
        answer.row.nominal_pressure > observation_.hardness)
      return; // without contact the mean gap is prescribed; the bound assumes
              // that the problem is convex and has a solution
    results::RowObserver observe(answer.row);
    observe("certified_gap_error", [&] {
      return contact::check_field(
                 sequence_.elasticity(),
                 {sequence_.heights(), observation_.local_compliance,
                  answer.row.nominal_pressure, answer.pressure,
                  answer.row.mean_gap + sequence_.mean_imprint(),
                  observation_.hardness})
          .mean_gap_error;
    });
  }

  int threads_;
  double gap_tolerance_; ///< [m]
  double saved_setup_time_;
  Observation observation_;
  SurfaceOfCase surface_; ///< grid and rms height only
  std::shared_ptr<TimedOperator::Tally> tally_ =
      std::make_shared<TimedOperator::Tally>();
  contact::LoadSequence sequence_;
  /// The rows of this rank of the last maps, if they are needed.
  std::vector<double> pressure_ = {}, gap_ = {};
};

} // namespace

std::unique_ptr<StepSolver>
make_load_steps(std::unique_ptr<contact::SurfaceOperator> elasticity,
                std::vector<double> heights, const LoadStepsSetting& setting) {
  return std::make_unique<LoadSteps>(std::move(elasticity), std::move(heights),
                                     setting);
}

} // namespace asperity::methods
