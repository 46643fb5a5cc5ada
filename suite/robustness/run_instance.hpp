#pragma once

// Runs a problem instance from its case to its outcome.

#include "suite/robustness/instance.hpp"
#include "suite/robustness/instance_report.hpp"

#include <filesystem>

namespace asperity::robustness {

/// Reads the case of the instance, runs its method by the library as a run
/// does, and every check on each load step. Nothing is thrown:
/// std::domain_error and input::InputError count as a refusal, and any other
/// exception is reported as such. A refusal must state what is allowed, or the
/// place in a file. A flawed instance that is not refused fails the check
/// "refusal".
/// @param program  path of `asperity`, for the instances that go through it;
///     empty: the executable of this process
InstanceReport run_instance(const Instance& instance,
                            const std::filesystem::path& program = {});

} // namespace asperity::robustness
