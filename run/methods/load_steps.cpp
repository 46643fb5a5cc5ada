#include "run/methods/load_steps.hpp"

#include "base/array_memory.hpp"
#include "base/cpu_clock.hpp"
#include "base/field_sums.hpp"
#include "base/ranks/node_sums.hpp"
#include "base/ranks/rank_sums.hpp"
#include "contact/certificate/certificate.hpp"
#include "contact/operators/mirrored_operator.hpp"
#include "results/types/method_columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::methods {
namespace {

/// Replaces the fields of a memory, which is a number, then a number and a
/// field for the imprint, if there is one, and for each step.
/// @param nodes  of a field
template <class Change>
std::vector<double> of_each_field(const std::vector<double>& memory,
                                  std::size_t nodes, const Change& change) {
  if (memory.size() % (nodes + 1) != 1)
    return memory; // empty, or of another grid
  std::vector<double> changed{memory.front()};
  for (std::size_t at = 1; at < memory.size(); at += 1 + nodes) {
    changed.push_back(memory[at]);
    const auto field = change(std::span(memory).subspan(at + 1, nodes));
    changed.insert(changed.end(), field.begin(), field.end());
  }
  return changed;
}

/// Of the mean of many numbers, relative to the largest.
constexpr double rounding_of_sums = 1e-13;

class LoadSteps final : public StepSolver {
public:
  /// @param cell        of the answers
  /// @param elasticity  of its nodes, or of quarter_of(cell)
  LoadSteps(const Grid& cell,
            std::unique_ptr<contact::SurfaceOperator> elasticity,
            std::vector<double> heights, const LoadStepsSetting& setting)
      : threads_(setting.threads),
        gap_tolerance_(setting.gap_tolerance),
        saved_setup_time_(setting.saved_setup_time),
        observation_(setting.observation),
        sequence_(measured(std::move(elasticity)), std::move(heights),
                  setting.interface, setting.gap_tolerance,
                  setting.max_iterations) {
    const contact::SurfaceOperator& c = sequence_.elasticity();
    surface_.record.grid = cell;
    surface_.scales.rms_height = setting.rms_height;
    rows_ = c.rows();
    if (rows_.ranks() != nullptr)
      weights_ = rows_.gathered(c.nodal_weights());
    observation_.nodal_weights =
        rows_.ranks() != nullptr ? weights_ : c.nodal_weights();
    observation_.threads = setting.threads;
  }

  StepAnswer find(const StepTarget& target) override {
    *transform_time_ = 0.0;
    contact::ContactSolution solution = sequence_.solve(target.load);
    const int transforms = solution.transforms;
    const double transform_time = *transform_time_;
    const CpuClock clock(threads_);
    gather(solution);
    const Reached reached = reached_by(solution);
    unfold(solution);
    StepAnswer answer = observe(std::move(solution), observation_, surface_);
    answer.reached = reached;
    certify(answer);
    answer.row[columns::observation_time] = clock.seconds();
    answer.row[columns::transforms] = transforms;
    answer.row[columns::transform_time] = transform_time;
    return answer;
  }

  std::vector<double> state() const override {
    return of_each_field(
        sequence_.memory(), rows_.size(),
        [this](std::span<const double> own) { return rows_.gathered(own); });
  }

  bool restore(const std::vector<double>& state) override {
    sequence_.recall(of_each_field(
        values_of_ranks<double>(rows_.ranks(), state), rows_.grid().size(),
        [this](std::span<const double> whole) { return rows_.own(whole); }));
    return true;
  }

  double saved_setup_time() const override { return saved_setup_time_; }

private:
  std::unique_ptr<contact::SurfaceOperator>
  measured(std::unique_ptr<contact::SurfaceOperator> elasticity) const {
    elasticity->measure(transform_time_);
    return elasticity;
  }

  /// Lets every rank have the whole fields. Collective.
  void gather(contact::ContactSolution& solution) const {
    if (rows_.ranks() == nullptr)
      return;
    for (std::vector<double>* field :
         {&solution.pressure, &solution.gap, &solution.displacement})
      *field = rows_.gathered(*field);
  }

  /// Completes the fields of a quarter by their mirror images.
  void unfold(contact::ContactSolution& solution) {
    if (!sequence_.elasticity().is_mirrored())
      return;
    for (std::vector<double>* field :
         {&solution.pressure, &solution.gap, &solution.displacement})
      *field = contact::unfolded(*field, surface_.record.grid);
  }

  /// The values of a field at the nodes of the operator.
  std::vector<double> at_operator(std::span<const double> field) {
    if (sequence_.elasticity().is_mirrored())
      return contact::first_quarter(field, surface_.record.grid);
    const auto own = rows_.own(field);
    return {own.begin(), own.end()};
  }

  Reached reached_by(const contact::ContactSolution& solution) {
    const int threads = observation_.threads;
    const std::span<const double> heights = sequence_.heights();
    const double* const p = solution.pressure.data();
    const double* const g = solution.gap.data();
    const auto mean_of = [&](const auto& value) {
      return weighted_sum(observation_.nodal_weights, solution.pressure.size(),
                          threads, value) /
             static_cast<double>(solution.pressure.size());
    };
    const double borne = mean_of([=](std::size_t i) { return std::abs(p[i]); });
    const double height =
        largest_size(heights, sequence_.elasticity().workers());
    const double depth = std::max(std::abs(solution.mean_gap),
                                  observation_.local_compliance *
                                      largest_size(solution.pressure, threads));
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

  /// Bounds the error of the mean gap by one more application of the operator,
  /// which the solver has no part in.
  void certify(StepAnswer& answer) {
    if (!(answer.row.nominal_pressure > 0.0) || observation_.adhesion ||
        answer.row.nominal_pressure > observation_.hardness)
      return; // without contact the mean gap is prescribed; the bound assumes
              // that the problem is convex and has a solution
    const std::vector<double> pressure = at_operator(answer.pressure);
    results::RowObserver observe(answer.row);
    observe(columns::certified_gap_error, [&] {
      return contact::check_field(
                 sequence_.elasticity(),
                 {sequence_.heights(), observation_.local_compliance,
                  answer.row.nominal_pressure, pressure,
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
  /// CPU time of the operator in this step [s].
  std::shared_ptr<double> transform_time_ = std::make_shared<double>(0.0);
  contact::LoadSequence sequence_;
  SharedRows rows_{Grid{}};          ///< of this rank
  std::vector<double> weights_ = {}; ///< of all nodes, on ranks
};

} // namespace

std::unique_ptr<StepSolver>
make_load_steps(std::unique_ptr<contact::SurfaceOperator> elasticity,
                std::vector<double> heights, const LoadStepsSetting& setting) {
  const Grid cell = elasticity->grid();
  if (elasticity->shared_rows() == nullptr &&
      contact::equals_mirror_images(heights, cell))
    if (auto quarter = elasticity->mirrored()) {
      heights = contact::first_quarter(heights, cell);
      elasticity = std::move(quarter);
    }
  return std::make_unique<LoadSteps>(cell, std::move(elasticity),
                                     std::move(heights), setting);
}

} // namespace asperity::methods
