#include "run/distributed/part_run.hpp"

#include "methods/cache/cache.hpp"
#include "methods/chosen.hpp"
#include "run/run_case.hpp"
#include "run/sweeps/earlier_run.hpp"
#include "run/sweeps/sweep_run.hpp"

#include <fmt/format.h>

namespace asperity::run {

ExitCode run_part_of_case(const ReadCase& read, const PartRecord& record,
                          RunOptions options) {
  options.reference = read.reference;
  options.realizations = {record.members.begin(), record.members.end()};
  const auto earlier = [&] {
    return earlier_run(read.contact_case,
                       methods::chosen_methods(read.contact_case,
                                               options.methods,
                                               options.is_exact),
                       options.folder, options.realizations);
  };
  const EarlierRun before = earlier();
  // The parts to be joined are of one text, comments included.
  if (before.state == RunState::complete &&
      before.case_hash == record.case_hashes.front()) {
    fmt::print("is complete already\n");
    return before.has_converged ? exit_good : exit_not_converged;
  }
  options.resume = before.state == RunState::to_resume;
  if (run_case(read.contact_case, options).is_interrupted)
    return exit_interrupted;
  return earlier().has_converged ? exit_good : exit_not_converged;
}

ExitCode run_part_of_sweep(const NamedSweep& named, const PartRecord& record,
                           const std::filesystem::path& folder,
                           const RunOptions& options) {
  SweepRunOptions sweep{named.found.file, named.overrides, options.methods,
                        options.is_exact, folder,          true,
                        options.threads};
  sweep.uses_cache = options.cache != nullptr && options.cache->is_on();
  sweep.is_part = true;
  sweep.points = record.members;
  sweep.has_reports = is_of_maps(named) && options.has_report;
  sweep.write_case = [&] { write_made_case(named); };
  const SweepOutcome outcome = run_sweep(named.sweep, sweep);
  return outcome.is_interrupted ? exit_interrupted : outcome.worst;
}

} // namespace asperity::run
