#pragma once

// A scene from its numbers to its outcome.

#include <filesystem>

#include "robustness/scene.hpp"
#include "robustness/scene_report.hpp"

namespace asperity::robustness {

/// Runs the scene and every check on it. Nothing is thrown: a std::domain_error
/// or cases::CaseError is a refusal, any other exception is reported as such. A
/// refusal must say a reason with what is allowed, and a flawed scene that is
/// not refused has failed the check "refusal".
/// @param program  `asperity`, for the scenes that go through it; empty: this
///                 process' own
SceneReport run_scene(const Scene& scene,
                      const std::filesystem::path& program = {});

} // namespace asperity::robustness
