#pragma once

// Runs a problem instance from its parameters to its outcome.

#include "robustness/instance.hpp"
#include "robustness/instance_report.hpp"

#include <filesystem>

namespace asperity::robustness {

/// Runs the instance and every check on it. Nothing is thrown:
/// std::domain_error and input::InputError count as a refusal, and any other
/// exception is reported as such. A refusal must state a reason and what is
/// allowed. A flawed instance that is not refused fails the check "refusal".
/// @param program  path of `asperity`, for the instances that go through it;
///     empty: the executable of this process
InstanceReport run_instance(const Instance& instance,
                            const std::filesystem::path& program = {});

} // namespace asperity::robustness
