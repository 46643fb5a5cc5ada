#include "run/method_job.hpp"

#include "base/array_memory.hpp"
#include "base/cpu_clock.hpp"
#include "fem/plugin.hpp"
#include "results/types/curve_columns.hpp"
#include "run/interrupt.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/theory_method.hpp"
#include "run/new_output.hpp"
#include "studies/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace asperity::run {
namespace {

using results::CurvePoint;

methods::StepTarget target_of(const mechanics::LoadingPath& load,
                              std::size_t step,
                              const mechanics::Scales& scales) {
  return {load.target(step, scales), static_cast<int>(step)};
}

/// Returns true for methods that write files of their own, such as atom dumps
/// and VTU files. Their steps are not cached, because the cache does not
/// contain these files.
bool leaves_files(const cases::MethodSpec& method,
                  const cases::ReportSpec& report) {
  const auto* md = std::get_if<mechanics::MdSettings>(&method.settings);
  return (md != nullptr && md->dump) ||
         (methods::is_full_block(method) && report.vtu);
}

bool has_failed(const CurvePoint& row) {
  return row.status == results::StepStatus::not_converged;
}

/// Lines, of which the last one may end with a line break, as parts of one
/// sentence.
std::string in_one_line(std::string lines) {
  while (lines.ends_with('\n'))
    lines.pop_back();
  for (std::size_t at = lines.find('\n'); at != std::string::npos;
       at = lines.find('\n', at))
    lines.replace(at, 1, lines[at - 1] == ':' ? " " : "; ");
  return lines;
}

/// The part of a step of a full block that is done; 0 if it is not known, as on
/// an adaptive mesh, where finer meshes follow.
double share_of(const cases::Case& contact_case,
                const cases::MethodSpec& method, double residual) {
  const auto& fem = std::get<mechanics::FemSettings>(method.settings);
  return fem.full.uses_case_mesh &&
                 contact_case.mesh.kind == mechanics::MeshKind::adaptive
             ? 0.0
             : share_done(residual, fem.contact.tolerance);
}

} // namespace

MethodJob::MethodJob(const RunContext& context, const cases::MethodSpec& method,
                     int realization, RootWork& root)
    : context_(context),
      method_(method),
      realization_(realization),
      root_(root),
      chain_(leaves_files(method, context.contact_case.report) ? no_cache_
                                                               : context.cache,
             context.keys.steps(method, realization)) {}

void MethodJob::run() {
  const std::vector<std::size_t> missing = root_.value([&] {
    return is_interrupted() ? std::vector<std::size_t>() : take_kept();
  });
  if (missing.empty() || is_to_end())
    return;
  if (!method_.has_fields())
    compute_theory(missing);
  else
    compute_elastic(missing);
}

/// Whether the run is interrupted, of which rank 0 decides.
bool MethodJob::is_to_end() {
  return root_.value(is_interrupted);
}

bool MethodJob::needs_maps(std::size_t step) const {
  return realization_ == 0 && context_.field_steps.contains(step) &&
         method_.has_fields();
}

bool MethodJob::needs_section(std::size_t step) const {
  return realization_ == 0 && methods::is_full_block(method_) &&
         step == methods::step_with_section(
                     context_.contact_case, method_,
                     context_.surfaces.of(method_, realization_).scales);
}

/// Writes the cached steps to the result file.
///
/// @return  the steps that remain to be computed
std::vector<std::size_t> MethodJob::take_kept() {
  std::vector<std::size_t> missing;
  std::vector<CurvePoint> rows;
  KeptWork work;
  results::MethodChange last;
  for (std::size_t step = 0; step < context_.contact_case.load.targets.size();
       ++step) {
    if (context_.writer->has_step(method_.name, realization_,
                                  static_cast<int>(step)))
      continue;
    std::optional<results::Change> kept =
        chain_.read(step, needs_maps(step), needs_section(step));
    if (!kept || (needs_maps(step) && has_less_precision(*kept))) {
      missing.push_back(step);
      continue;
    }
    last = kept->methods.front();
    ++work.steps;
    work.cpu_time += last.points.front().cpu_time;
    take(step, std::move(*kept), rows);
  }
  if (work.steps == 0)
    return missing;
  context_.writer->append_steps(method_.name, realization_, rows);
  if (missing.empty()) {
    const double setup_time = last.setup_cpu_time.value_or(0.0);
    context_.writer->record_setup_time(method_.name, realization_, setup_time);
    work.cpu_time += setup_time;
  }
  describe_found(last.description.value_or(""));
  context_.tally.add_kept(method_.name, work);
  context_.progress.steps_kept(method_.name, realization_, work.steps);
  return missing;
}

/// Whether the pressure of a cached step was kept in single precision, and the
/// result is to have it in double.
bool MethodJob::has_less_precision(const results::Change& kept) const {
  return context_.contact_case.report.has_double_maps &&
         !kept.methods.front().fields.front().has_double_maps;
}

/// Takes over a cached step, whose index was that of the run that computed it:
/// with its fields it is written at once, without fields it is appended to
/// `rows`.
void MethodJob::take(std::size_t step, results::Change kept,
                     std::vector<CurvePoint>& rows) {
  CurvePoint& row = kept.methods.front().points.front();
  row.step = static_cast<int>(step);
  row.is_unloading = context_.contact_case.load.is_unloading[step];
  studies::rescale_studies(context_.contact_case, row);
  context_.tally.failed_steps += has_failed(row);
  for (results::FieldsChange& fields : kept.methods.front().fields) {
    fields.step = row.step;
    fields.has_double_maps = context_.contact_case.report.has_double_maps;
  }
  if (needs_maps(step))
    record(std::move(kept));
  else
    rows.push_back(row);
}

/// A step, with maps that the answer holds.
results::Change MethodJob::change_of(const methods::StepAnswer& answer) const {
  const CurvePoint& row = answer.row;
  const results::SurfaceRecord& pressed =
      context_.surfaces.of(method_, realization_).record;
  results::MethodChange method{.points = {row}};
  if (!answer.pressure.empty()) {
    method.fields = {{row.step,
                      row.nominal_pressure,
                      answer.grid,
                      {results::rows_of_map(answer.pressure)},
                      {results::rows_of_map(answer.gap)},
                      context_.contact_case.report.has_double_maps,
                      pressed.map.on(pressed.grid, answer.grid)}};
  }
  results::Change change{.methods = {std::move(method)}};
  if (answer.section)
    change.tables = {*answer.section};
  return change;
}

/// Writes of a step what the result is to have of it.
void MethodJob::record(results::Change change) {
  results::MethodChange& method = change.methods.front();
  const auto step = static_cast<std::size_t>(method.points.front().step);
  method.name = method_.name;
  method.realization = realization_;
  method.description.reset();
  method.setup_cpu_time.reset();
  if (!needs_maps(step))
    method.fields.clear();
  if (method.fields.empty() || !needs_section(step))
    change.tables.clear();
  context_.writer->append(change);
}

void MethodJob::describe_found(const std::string& found) {
  if (found.empty())
    return;
  const methods::MethodDescription description =
      methods::describe(method_, context_.contact_case.material);
  context_.writer->begin_method(method_.name, description.kind,
                                description.text + "; " + in_one_line(found),
                                name_of(method_.contact_criterion(0.0).field));
}

void MethodJob::compute_theory(const std::vector<std::size_t>& steps) {
  const cases::Case& contact_case = context_.contact_case;
  const auto& settings = std::get<mechanics::TheorySettings>(method_.settings);
  const CpuClock clock;
  const methods::TheoryInput input = methods::theory_input(
      contact_case, method_, context_.surfaces, realization_);
  std::vector<CurvePoint> rows =
      methods::theory_rows(settings, contact_case.load, input);
  const double setup_time = clock.seconds();
  std::erase_if(rows, [&](const CurvePoint& row) {
    return std::ranges::find(steps, static_cast<std::size_t>(row.step)) ==
           steps.end();
  });
  if (settings.loss_factor == mechanics::LossFactor::yang_persson) {
    const theory::PerssonContact contact(
        input.spectrum, input.scales.contact_modulus, settings.gamma);
    for (CurvePoint& row : rows)
      studies::evaluate_studies(contact_case, contact, row);
  }
  context_.writer->record_setup_time(method_.name, realization_, setup_time);
  context_.writer->append_steps(method_.name, realization_, rows);
  for (const CurvePoint& row : rows) {
    chain_.keep(static_cast<std::size_t>(row.step),
                {.methods = {{.setup_cpu_time = setup_time, .points = {row}}}});
    ++context_.tally.computed_steps;
    context_.tally.failed_steps += has_failed(row);
    context_.progress.step_done(method_.name, realization_, row,
                                input.scales.rms_height);
  }
}

void MethodJob::compute_elastic(const std::vector<std::size_t>& steps) {
  const bool uses_fem =
      std::holds_alternative<mechanics::FemSettings>(method_.settings);
  if (uses_fem) // loading deal.II is no part of the set-up
    fem::load_fem_module();
  const CpuClock clock(context_.pool.threads_per_job());
  const std::unique_ptr<methods::StepSolver> solver = set_up();
  const double setup_time = clock.seconds() + solver->saved_setup_time();
  if (uses_fem)
    context_.tally.uses_fem = true;
  if (solver->saved_setup_time() > 0.0)
    context_.tally.add_kept(method_.name + ", operator",
                            {0, solver->saved_setup_time()});
  root_.act([&] {
    context_.writer->record_setup_time(method_.name, realization_, setup_time);
    describe_found(solver->found_at_setup());
  });
  std::size_t next = 0; // the step with which the solver would continue
  for (const std::size_t step : steps) {
    if (!go_to(*solver, next, step) || !compute_step(*solver, step, setup_time))
      return;
    next = step + 1;
  }
}

std::unique_ptr<methods::StepSolver> MethodJob::set_up() {
  const Progress::Activity activity(context_.progress, activity_text("set-up"));
  return context_.solvers.make(method_,
                               context_.surfaces.of(method_, realization_),
                               realization_, resources());
}

std::string progress_text(const fem::BlockProgress& work) {
  std::string words = fmt::format("Newton step {}", work.iterations);
  if (std::isfinite(work.residual))
    words += fmt::format(", residual {:.1e}, {} points changed", work.residual,
                         work.changed_points);
  words += fmt::format(", {} CG iterations", work.linear_iterations);
  if (work.mesh_pass > 0)
    words += fmt::format(", mesh pass {}", work.mesh_pass + 1);
  return words + fmt::format(", {} unknowns", work.unknowns);
}

std::string MethodJob::activity_text(const std::string& part) const {
  return Progress::job_text(method_.name, realization_) + part;
}

/// Brings a solver, which would continue with step `next`, to the state before
/// `step` of an uninterrupted run: restores the last cached state and computes
/// the steps after it again.
///
/// @return  false if the run is to end
bool MethodJob::go_to(methods::StepSolver& solver, std::size_t next,
                      std::size_t step) {
  std::vector<double> state;
  const std::size_t found = root_.value([&] {
    for (std::size_t known = step; known > next; --known)
      if (auto kept = chain_.state_after(known - 1)) {
        state = std::move(*kept);
        return known;
      }
    return next;
  });
  if (found > next && solver.restore(state))
    next = found;
  if (next < step)
    fmt::print("{}, realization {}: steps {} to {} are computed again, because "
               "the state after them was not saved\n",
               method_.name, realization_, next, step - 1);
  const mechanics::Scales& scales =
      context_.surfaces.of(method_, realization_).scales;
  for (; next < step && !is_to_end(); ++next) {
    const Progress::Activity activity(
        context_.progress, activity_text(fmt::format("step {} again", next)));
    methods::StepTarget target =
        target_of(context_.contact_case.load, next, scales);
    target.needs_maps = false;
    solver.solve(target);
    ++context_.tally.repeated_steps;
  }
  return !is_to_end();
}

/// Solves one step and records it.
///
/// @return  false if the step was interrupted and remains to be done
bool MethodJob::compute_step(methods::StepSolver& solver, std::size_t step,
                             double setup_time) {
  const methods::SurfaceOfCase& surface =
      context_.surfaces.of(method_, realization_);
  const CpuClock clock(context_.pool.threads_per_job());
  const Progress::Activity activity(
      context_.progress, activity_text(fmt::format("step {}", step)));
  methods::StepTarget target =
      target_of(context_.contact_case.load, step, surface.scales);
  target.needs_maps =
      needs_maps(step) || studies::needs_all_maps(context_.contact_case);
  methods::StepAnswer answer = solver.solve(target);
  CurvePoint row = answer.row;
  if (has_failed(row) && is_to_end())
    return false;
  row.step = static_cast<int>(step);
  row.is_unloading = context_.contact_case.load.is_unloading[step];
  row.cpu_time = clock.seconds();
  ++context_.tally.computed_steps;
  context_.tally.failed_steps += has_failed(row);
  answer.row = row;
  keep_and_record(solver, answer, setup_time);
  context_.progress.step_done(method_.name, realization_, row,
                              surface.scales.rms_height);
  return true;
}

/// Rank 0 writes a step to the cache and to the result.
void MethodJob::keep_and_record(methods::StepSolver& solver,
                                methods::StepAnswer& answer,
                                double setup_time) {
  std::vector<double> state;
  if (root_.value([&] { return chain_.is_on(); }))
    state = solver.state();
  root_.act([&] {
    study(answer);
    const results::SurfaceRecord& pressed =
        context_.surfaces.of(method_, realization_).record;
    results::state_of_map(answer.row, pressed.map.share(pressed.grid));
    if (!needs_maps(static_cast<std::size_t>(answer.row.step)))
      free_memory(answer.pressure, answer.gap);
    results::Change change = change_of(answer);
    change.methods.front().setup_cpu_time = setup_time;
    change.methods.front().description = solver.found_at_setup();
    chain_.keep(static_cast<std::size_t>(answer.row.step), change, state);
    free_memory(state);
    record(std::move(change));
  });
}

/// Adds to the row of a step what the case asks of its maps.
void MethodJob::study(methods::StepAnswer& answer) {
  const cases::Case& contact_case = context_.contact_case;
  if (!studies::needs_all_maps(contact_case) || answer.gap.empty() ||
      has_failed(answer.row))
    return;
  const methods::SurfaceOfCase& surface =
      context_.surfaces.of(method_, realization_);
  const int threads = context_.pool.threads_per_job();
  studies::Step step = studies::step_with_maps(
      contact_case, method_, surface, answer.grid, answer.pressure, answer.gap);
  step.threads = threads;
  step.elasticity = [&] {
    return context_.solvers.operator_of(method_, surface, threads);
  };
  studies::evaluate_studies(step, answer.row);
}

methods::Resources MethodJob::resources() const {
  return {context_.pool.threads_per_job(),
          context_.folder / files_of_method(method_.name, realization_),
          [this](const md::Progress& work) {
            context_.progress.at_work(
                method_.name, realization_,
                fmt::format("{} evaluations  residual {:.1e}  energy {:.6e} J",
                            work.evaluations, work.residual, work.energy));
            return !is_interrupted();
          },
          &root_,
          context_.threads_a_rank,
          [this](const fem::BlockProgress& work) {
            context_.progress.at_work(
                method_.name, realization_, progress_text(work),
                share_of(context_.contact_case, method_, work.residual));
          }};
}

void Tally::add_kept(const std::string& thing, const KeptWork& work) {
  const std::lock_guard lock(mutex_);
  KeptWork& sum = kept_[thing];
  sum.steps += work.steps;
  sum.cpu_time += work.cpu_time;
}

std::map<std::string, KeptWork> Tally::kept() const {
  const std::lock_guard lock(mutex_);
  return kept_;
}

int Tally::kept_steps() const {
  int steps = 0;
  for (const auto& [thing, work] : kept())
    steps += work.steps;
  return steps;
}

std::vector<results::Skipped> Tally::failures() const {
  const std::lock_guard lock(mutex_);
  return failures_;
}

void Tally::add_failure(const std::string& what, const std::string& why) {
  const std::lock_guard lock(mutex_);
  failures_.push_back({what, "failed: " + why});
  if (is_told_)
    fmt::print(stderr, "not computed: {}: {}\n", what, why);
}

} // namespace asperity::run
