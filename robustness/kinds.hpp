#pragma once

// How each family of scenes is run, and what they have in common. Internal to
// the room.

#include "fem/plugin.hpp"

#include <filesystem>
#include <vector>

#include "robustness/scene_report.hpp"
#include "robustness/scene_surface.hpp"
#include "robustness/verify.hpp"

namespace asperity::robustness {

/// Tolerance of a scene's gaps, relative to the rms height: a case's default.
constexpr double relative_tolerance = 1e-8;

/// Each runs a scene of its family and fills in the report. What is refused is
/// thrown, as the rooms throw it.
void run_elastic(const Scene& scene, SceneReport& report);
void run_full_block(const Scene& scene, SceneReport& report);
void run_theory(const Scene& scene, SceneReport& report);
void run_atoms(const Scene& scene, SceneReport& report);
void run_flawed(const Scene& scene, SceneReport& report);

/// The scene as a case file through the program, after its family has answered
/// it: the result file holds rows in their ranges, and the same mean gap. What
/// the program refuses (exit code 2) is thrown as std::domain_error.
void run_program(const Scene& scene, const std::filesystem::path& program,
                 SceneReport& report);

/// The load program, in SI. The scene's own load is at index load_step().
/// @param height_scale  [m], see SceneSurface
std::vector<contact::LoadTarget> targets_of(const Scene& scene,
                                            double height_scale);
std::size_t load_step(const Scene& scene);

/// The finite elements of a scene, of degree 1 or 2. Surface layers are cubic
/// or, in a thin block, half of it.
fem::BlockRequest block_request(const Scene& scene, const Grid& grid,
                                int degree, int threads);

/// The surface operator of an elastic scene.
/// @throws std::domain_error  what contact/, meshes/ and fem/ refuse
std::unique_ptr<contact::SurfaceOperator>
operator_of(const Scene& scene, const Grid& grid, int threads);

/// C of the flattest and of the steepest of the waves 1, 2, 4, ... along x
/// [m/Pa].
struct ComplianceRange {
  double longest = 0.0;
  double shortest = 0.0;
};

ComplianceRange compliance_range(const Grid& grid, const Displace& displace);

/// All pairs of neighbouring steps, and the way back of a cycle against the
/// way there.
std::optional<Failure> verify_program(const Scene& scene,
                                      const std::vector<StepSummary>& steps);

/// Puts a failure into the report.
void fail(SceneReport& report, const Failure& failure);

} // namespace asperity::robustness
