// Formats a plan as readable text.
#include "run/plan/cost_model.hpp"
#include "run/plan/memory_check.hpp"
#include "run/plan/plan.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::run {
namespace {

std::string grid_text(const Grid& grid) {
  return grid.points_x == 0
             ? "formula"
             : fmt::format("{} x {}", grid.points_x, grid.points_y);
}

/// Returns " (CPU 2 min, 4.2 MB)", without what is not known.
std::string cost_text(const results::Skipped& skipped) {
  const bool has_time = !std::isnan(skipped.cpu_time);
  const bool has_size = !std::isnan(skipped.bytes);
  if (!has_time && !has_size)
    return "";
  return fmt::format(" ({}{}{})",
                     has_time ? "CPU " + time_text(skipped.cpu_time) : "",
                     has_time && has_size ? ", " : "",
                     has_size ? size_text(skipped.bytes) : "");
}

} // namespace

std::string time_text(double seconds) {
  if (std::isnan(seconds))
    return "?";
  if (seconds < 60.0)
    return fmt::format("{:.2g} s", seconds);
  return seconds < 3600.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                          : fmt::format("{:.3g} h", seconds / 3600.0);
}

std::string size_text(double bytes) {
  if (std::isnan(bytes))
    return "?";
  if (bytes < 1e7)
    return fmt::format("{:.2g} MB", 1e-6 * bytes);
  return bytes < 1e9 ? fmt::format("{:.0f} MB", 1e-6 * bytes)
                     : fmt::format("{:.3g} GB", 1e-9 * bytes);
}

std::string plan_text(const Plan& plan, const cases::Case& contact_case) {
  std::string text =
      fmt::format("{}: {}\n", contact_case.name, contact_case.title) +
      fmt::format("{:<18} {:>6} {:>6} {:>7} {:>13} {:>9} {:>8} {:>8} {:>8}\n",
                  "method", "realis", "steps", "cached", "grid", "unknowns",
                  "set-up", "CPU", "memory");
  for (const PlannedMethod& method : plan.methods)
    text +=
        fmt::format("{:<18} {:>6} {:>6} {:>7} {:>13} {:>9} {:>8} {:>8} {:>8}\n",
                    method.name, method.realizations, method.steps,
                    method.kept_steps, grid_text(method.grid),
                    count_text(method.unknowns), time_text(method.setup_time),
                    time_text(method.step_time), size_text(method.memory));
  if (plan.study_time > 0.0)
    text += fmt::format(
        "tables of the studies and of the subsurface stress: CPU {}\n",
        time_text(plan.study_time));
  text +=
      fmt::format("predicted: CPU {}, {} on {} thread{}, memory {}, result {}, "
                  "within a factor of {:g} (not including the report)\n",
                  time_text(plan.cpu_time), time_text(plan.wall_time),
                  plan.threads, plan.threads == 1 ? "" : "s",
                  size_text(plan.memory), size_text(plan.disk), plan.factor);
  if (const std::string refusal = refusal_of(plan); !refusal.empty())
    text += "the run would be refused: it " + refusal + "\n";
  if (!plan.skipped.empty())
    text += "skipped, with the cost where it is predicted:\n";
  for (const results::Skipped& one : plan.skipped)
    text += fmt::format("  {}: {}{}\n", one.what, one.why, cost_text(one));
  for (const std::string& warning : plan.warnings)
    text += fmt::format("warning: {}\n", warning);
  return text;
}

std::string shared_rows_text(const Plan& plan) {
  std::string text;
  for (const PlannedMethod& planned : plan.methods)
    if (planned.ranks > 1)
      text += fmt::format(
          "{}: {} ranks share the rows of the surface, {} on each\n",
          planned.name, planned.ranks,
          size_text(planned.rank_memory + base_memory(true)));
    else if (!planned.why_alone.empty())
      text += fmt::format("{}: rank 0 solves it alone, because {}\n",
                          planned.name, planned.why_alone);
  return text;
}

} // namespace asperity::run
