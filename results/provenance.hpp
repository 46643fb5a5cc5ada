#pragma once

// What made a result: program, compiler, libraries, machine, cost. Owns the
// names of these facts in the file.

#include "results/types/result.hpp"

#include <chrono>
#include <string>

namespace asperity::results {

/// Facts of the program and the machine: version, commit, dirty ("yes" if the
/// sources had uncommitted changes; both are "unknown" outside a checkout),
/// compiler, build type, library versions, processor, cores, memory, host
/// system. A report warns of numbers from a dirty program.
Provenance program_facts();

/// What decides the numbers a program computes, as one SHA-256: every source
/// but those of reports and command line, compiler, flags, libraries. Equal
/// stamps: the same numbers on the same processor.
std::string build_stamp();

/// "model name" of the first processor; "unknown" where the system says none.
std::string processor_name();

/// "2026-01-31T12:34:56Z" [UTC]
std::string utc_now();

/// What a run costs, from construction on.
class RunClock {
public:
  RunClock();

  /// Wall time [s], CPU time of the process so far [s], its peak memory [MiB].
  Provenance facts() const;

private:
  std::chrono::steady_clock::time_point start_;
};

} // namespace asperity::results
