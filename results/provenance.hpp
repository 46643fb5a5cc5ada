#pragma once

// Collects the provenance of a result: program, compiler, libraries, machine
// and cost. It defines the names under which these facts are stored.

#include "results/types/result.hpp"

#include <chrono>
#include <string>

namespace asperity::results {

/// Returns facts about the program and the machine: version, commit, dirty
/// ("yes" if the sources had uncommitted changes; both are "unknown" outside a
/// checkout), compiler, build type, library versions, processor, cores, memory
/// and host system. A report warns of results that were computed by a program
/// with uncommitted changes.
Provenance program_facts();

/// Returns a SHA-256 hash of everything that determines the computed numbers:
/// all sources except those of reports and the command line, the compiler, its
/// flags and the libraries. Programs with equal stamps compute the same numbers
/// on the same processor.
std::string build_stamp();

/// Returns the "model name" of the first processor, or "unknown" if the system
/// does not provide it.
std::string processor_name();

/// Returns the current time, e.g. "2026-01-31T12:34:56Z" [UTC].
std::string utc_now();

/// Measures the cost of a run from its construction on.
class RunClock {
public:
  RunClock();

  /// Returns the current time [UTC], the wall time [s], the CPU time of the
  /// process so far [s] and the peak memory [MiB].
  /// @param peak_memory  of the largest process of the run [B]
  Provenance facts(double peak_memory) const;

private:
  std::chrono::steady_clock::time_point start_;
};

} // namespace asperity::results
