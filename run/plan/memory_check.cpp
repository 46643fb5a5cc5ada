#include "run/plan/memory_check.hpp"

#include "base/available_memory.hpp"
#include "input/input_error.hpp"

#include <fmt/format.h>

namespace asperity::run {
std::string refusal_of(const Plan& plan) {
  const std::string shortage = memory_shortage(plan.memory);
  return shortage.empty()
             ? ""
             : shortage +
                   "; reduce surface.points, surface.realizations or --threads";
}

void require_memory(const cases::Case& contact_case,
                    const RunOptions& options) {
  if (!contact_case.surface.points)
    return;
  const std::string refusal = refusal_of(make_plan(contact_case, options));
  if (!refusal.empty())
    throw input::InputError(
        fmt::format("{}: surface.points = {} with {} realisation(s) {}",
                    contact_case.path, *contact_case.surface.points,
                    contact_case.surface.realizations, refusal));
}

} // namespace asperity::run
