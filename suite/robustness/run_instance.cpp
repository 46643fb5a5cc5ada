#include "suite/robustness/run_instance.hpp"

#include "base/atomic_file.hpp"
#include "base/temporary_folder.hpp"
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "run/methods/chosen.hpp"
#include "run/run_case.hpp"
#include "suite/robustness/case_pass.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <stdexcept>

namespace asperity::robustness {
namespace {

namespace fs = std::filesystem;

/// Ratios of the second runs of metamorphic pairs: powers of two and of ten.
constexpr UnitRatios binary_units{0x1p+20, 0x1p-17};
constexpr UnitRatios decimal_units{1e-3, 1e6};

/// The case of an instance, with its map among the temporary files.
class InstanceCase {
public:
  explicit InstanceCase(const Instance& instance,
                        std::vector<std::string> overrides = {})
      : folder_("asperity-robustness") {
    overrides.insert(overrides.begin(), instance.overrides.begin(),
                     instance.overrides.end());
    if (!instance.map.heights.empty()) {
      write_file_atomically(folder_.path() / "map.txt",
                            text_of_map(instance.map));
      if (!instance.file.empty())
        overrides.push_back("surface.file=" +
                            (folder_.path() / "map.txt").string());
    }
    const fs::path file = instance.file.empty() ? folder_.path() / "case.toml"
                                                : fs::path(instance.file);
    case_ = cases::read_case_text(instance.text, file.string(), overrides);
    method_ = methods::chosen_methods(case_, {{instance.method}, true}).front();
    run::require_runnable(case_, {method_});
  }

  MethodOfCase what() const { return {case_, method_}; }

  const cases::MethodSpec& method() const { return method_; }

  fs::path written() const {
    write_file_atomically(folder_.path() / "case.toml", case_.text);
    return folder_.path();
  }

private:
  TemporaryFolder folder_;
  cases::Case case_;
  cases::MethodSpec method_;
};

/// Whether each number of the second fields is that of the first times the
/// ratio, to the last bit.
bool is_scaled(const std::vector<std::vector<double>>& first,
               const std::vector<std::vector<double>>& second, double ratio) {
  return std::ranges::equal(first, second, [&](const auto& a, const auto& b) {
    return std::ranges::equal(
        a, b, [&](double x, double y) { return x * ratio == y; });
  });
}

/// Whether two steps of a pair have one answer; the report says why not.
bool is_one_answer(const StepSummary& first, const StepSummary& second,
                   const UnitRatios& units, const char* check,
                   InstanceReport& report) {
  report.pair_difference =
      std::max(report.pair_difference,
               std::abs(second.mean_gap / units.length - first.mean_gap) /
                   first.tolerance);
  auto failure = verify_same(first, second, units.length, units.pressure);
  if (failure)
    fail(report, {check, failure->detail});
  return !failure;
}

/// Compares a pass with a second one in other units or on other threads.
void compare(const Pass& first, const Pass& second, const UnitRatios& units,
             bool needs_same_bits, InstanceReport& report) {
  report.has_pair = true;
  report.has_same_bits =
      is_scaled(first.pressures, second.pressures, units.pressure) &&
      is_scaled(first.gaps, second.gaps, units.length);
  if (needs_same_bits) {
    if (!report.has_same_bits)
      fail(report, {"metamorphic pair", "the bits of both runs differ"});
    return;
  }
  for (std::size_t i = 0; i < first.steps.size(); ++i)
    if (!is_one_answer(first.steps[i], second.steps[i], units,
                       "metamorphic pair", report))
      return;
}

/// Compares a full block with that of factorised matrices. Adaptive meshes
/// follow solutions of a loose tolerance, in which the two solvers differ. On
/// two meshes, the results differ by discretisation.
void compare_with_direct(const MethodOfCase& what, const Pass& found,
                         Pass direct, InstanceReport& report) {
  report.has_pair = true;
  const bool has_same_energy =
      is_laterally_uniform(what) && has_nodal_fields(what);
  for (std::size_t i = 0; i < found.steps.size(); ++i) {
    if (found.unknowns[i] != direct.unknowns[i])
      continue;
    if (!has_same_energy)
      direct.steps[i].energy = found.steps[i].energy;
    if (!is_one_answer(found.steps[i], direct.steps[i], {}, "direct solver",
                       report))
      return;
  }
}

/// A pass beside that of the report, which tells only why it failed.
Pass second_pass(const MethodOfCase& what, const PassSettings& settings,
                 const std::string& name, InstanceReport& report) {
  InstanceReport second;
  Pass pass = run_pass(what, settings, second);
  if (pass.steps.empty()) {
    report.outcome = second.outcome;
    report.check = second.check;
    report.reason = "second run, " + name + ": " + second.reason;
  }
  return pass;
}

/// The second run of a metamorphic pair.
void run_pair(const Instance& instance, const Pass& first,
              const std::string& relation, InstanceReport& report) {
  const UnitRatios units = relation == "binary-units"    ? binary_units
                           : relation == "decimal-units" ? decimal_units
                                                         : UnitRatios{};
  const bool is_threads = relation == "threads";
  const InstanceCase again(
      is_threads
          ? instance
          : draw_instance(instance.seed, instance.index, nullptr, units));
  const Pass second = second_pass(
      again.what(), {is_threads ? instance.threads : 1}, "pair", report);
  if (!second.steps.empty())
    compare(first, second, units, relation != "decimal-units", report);
}

void run_library(const Instance& instance, const InstanceCase& read,
                 InstanceReport& report) {
  if (!read.method().has_fields())
    return run_theory(read.what(), report);
  const std::string relation = instance.label("metamorphic pair");
  if (relation != "direct-solver") {
    const Pass pass = run_pass(read.what(), {}, report);
    // Adhesive states are not unique: other roundoff may lead to another one.
    const bool has_pair =
        relation == "binary-units" || relation == "threads" ||
        (relation == "decimal-units" && !read.method().is_adhesive());
    if (!pass.steps.empty() && has_pair)
      run_pair(instance, pass, relation, report);
    return;
  }
  const InstanceCase direct(instance,
                            {instance.method + ".linear_solver=direct"});
  const Pass found = run_pass(read.what(), {1, &direct.method()}, report);
  if (found.steps.empty())
    return;
  Pass expected = second_pass(direct.what(), {}, "direct solver", report);
  if (!expected.steps.empty())
    compare_with_direct(read.what(), found, std::move(expected), report);
}

void run_by_path(const Instance& instance, const fs::path& program,
                 InstanceReport& report) {
  const std::string path = instance.label("path");
  const bool is_flawed = !instance.label("flaw").empty();
  const bool is_program = !path.empty() && path != "library";
  if (is_program && is_flawed) {
    // The program reads what the library would refuse.
    const TemporaryFolder folder("asperity-robustness");
    std::string text = instance.text;
    for (const std::string& entry : instance.overrides)
      text += "#--set " + entry + "\n";
    write_file_atomically(folder.path() / "case.toml", text);
    if (!instance.map.heights.empty())
      write_file_atomically(folder.path() / "map.txt",
                            text_of_map(instance.map));
    return run_program({folder.path(), program, path, instance.threads, true},
                       report);
  }
  const InstanceCase read(instance);
  run_library(instance, read, report);
  if (is_flawed)
    return fail(report,
                {"refusal", instance.label("flaw") + " was not refused"});
  if (is_program && report.outcome == Outcome::verified)
    run_program({read.written(), program, path, instance.threads}, report);
}

/// A refusal is clear if it states what is allowed, or where in a file the
/// mistake is.
void refuse(const std::string& reason, InstanceReport& report) {
  report.reason = reason;
  const auto says = [&](const char* words) {
    return reason.find(words) != std::string::npos;
  };
  if (says("must ") || says("too few") || says("no wave") || says("needs ") ||
      says("case.toml:") || says("map.txt:")) {
    report.outcome = Outcome::refused;
    return;
  }
  fail(report, {"refusal", "unclear: " + reason});
}

} // namespace

InstanceReport run_instance(const Instance& instance, const fs::path& program) {
  InstanceReport report;
  report.index = instance.index;
  const std::clock_t begin = std::clock();
  try {
    run_by_path(instance,
                program.empty() ? fs::read_symlink("/proc/self/exe") : program,
                report);
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
