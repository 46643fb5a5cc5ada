#include "robustness/run_scene.hpp"

#include "input/input_error.hpp"

#include <ctime>
#include <exception>
#include <stdexcept>

#include "robustness/kinds.hpp"

namespace asperity::robustness {
namespace {

void run_family(const Scene& scene, SceneReport& report) {
  switch (scene.family) {
  case Family::full_block:
    return run_full_block(scene, report);
  case Family::atoms:
    return run_atoms(scene, report);
  case Family::theory:
    return run_theory(scene, report);
  case Family::flawed:
    return run_flawed(scene, report);
  default:
    return run_elastic(scene, report);
  }
}

/// A flawed instance that goes through the program has no library result for
/// comparison.
void run_by_path(const Scene& scene, std::filesystem::path program,
                 SceneReport& report) {
  if (scene.path == Path::library || scene.family != Family::flawed)
    run_family(scene, report);
  if (scene.path == Path::library || report.outcome != Outcome::verified)
    return;
  if (program.empty())
    program = std::filesystem::read_symlink("/proc/self/exe");
  run_program(scene, program, report);
}

/// A refusal is clear if it states what is allowed, or where in a file the
/// mistake is.
void refuse(const std::string& reason, SceneReport& report) {
  report.reason = reason;
  const auto says = [&](const char* words) {
    return reason.find(words) != std::string::npos;
  };
  if (says("must ") || says("too few") || says("no wave") ||
      says("not a finite number")) {
    report.outcome = Outcome::refused;
    return;
  }
  fail(report, {"refusal", "unclear: " + reason});
}

} // namespace

SceneReport run_scene(const Scene& scene,
                      const std::filesystem::path& program) {
  SceneReport report;
  report.index = scene.index;
  const std::clock_t begin = std::clock();
  try {
    run_by_path(scene, program, report);
  } catch (const std::domain_error& error) {
    refuse(error.what(), report);
  } catch (const input::InputError& error) {
    refuse(error.what(), report);
  } catch (const std::exception& error) {
    report.outcome = Outcome::threw;
    report.reason = error.what();
  }
  report.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return report;
}

} // namespace asperity::robustness
