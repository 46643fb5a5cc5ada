#include "robustness/run_instance.hpp"

#include "input/input_error.hpp"
#include "robustness/kinds.hpp"

#include <ctime>
#include <exception>
#include <stdexcept>

namespace asperity::robustness {
namespace {

void run_family(const Instance& instance, InstanceReport& report) {
  switch (instance.family) {
  case Family::full_block:
    return run_full_block(instance, report);
  case Family::atoms:
    return run_atoms(instance, report);
  case Family::theory:
    return run_theory(instance, report);
  case Family::flawed:
    return run_flawed(instance, report);
  default:
    if (mechanics::is_adhesive(instance.law))
      return run_adhesive(instance, report);
    return run_elastic(instance, report);
  }
}

/// A flawed instance that goes through the program has no library result for
/// comparison.
void run_by_path(const Instance& instance, std::filesystem::path program,
                 InstanceReport& report) {
  if (instance.path == Path::library || instance.family != Family::flawed)
    run_family(instance, report);
  if (instance.path == Path::library || report.outcome != Outcome::verified)
    return;
  if (program.empty())
    program = std::filesystem::read_symlink("/proc/self/exe");
  run_program(instance, program, report);
}

/// A refusal is clear if it states what is allowed, or where in a file the
/// mistake is.
void refuse(const std::string& reason, InstanceReport& report) {
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

InstanceReport run_instance(const Instance& instance,
                            const std::filesystem::path& program) {
  InstanceReport report;
  report.index = instance.index;
  const std::clock_t begin = std::clock();
  try {
    run_by_path(instance, program, report);
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
