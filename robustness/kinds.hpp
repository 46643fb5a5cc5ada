#pragma once

// How each family of instances is run, and the functions that the families
// share. It is internal to the module.

#include "fem/plugin.hpp"
#include "robustness/instance_report.hpp"
#include "robustness/instance_surface.hpp"
#include "robustness/verify.hpp"

#include <filesystem>
#include <vector>

namespace asperity::robustness {

/// Tolerance of an instance's gaps relative to the rms height, equal to the
/// default of a case.
constexpr double relative_tolerance = 1e-8;

/// Unit ratios of the second runs of metamorphic pairs, for length and
/// pressure. The binary ones are powers of two, the decimal ones powers of ten.
inline constexpr double binary_length = 0x1p+20;
inline constexpr double binary_pressure = 0x1p-17;
inline constexpr double decimal_length = 1e-3;
inline constexpr double decimal_pressure = 1e6;

/// Whether each number of the second field is that of the first times the
/// ratio, to the last bit.
bool is_scaled(std::span<const double> first, std::span<const double> second,
               double ratio);

/// Each of these functions runs an instance of its family and fills in the
/// report. A refusal is thrown as an exception, as the modules throw it.
void run_elastic(const Instance& instance, InstanceReport& report);
void run_adhesive(const Instance& instance, InstanceReport& report);
void run_full_block(const Instance& instance, InstanceReport& report);
void run_theory(const Instance& instance, InstanceReport& report);
void run_atoms(const Instance& instance, InstanceReport& report);
void run_flawed(const Instance& instance, InstanceReport& report);

/// Runs the instance as a case file through the program after its family has
/// solved it, and verifies that the rows of the result file lie in their ranges
/// and that the mean gap is the same. A refusal by the program (exit code 2) is
/// thrown as std::domain_error.
void run_program(const Instance& instance, const std::filesystem::path& program,
                 InstanceReport& report);

/// Returns the loading path in SI units. The load of the instance itself is at
/// index load_step().
/// @param height_scale  [m], see InstanceSurface
std::vector<mechanics::LoadTarget> targets_of(const Instance& instance,
                                              double height_scale);
std::size_t load_step(const Instance& instance);

/// Returns true if a larger load may open contact: the block is a plate,
/// thinner than 1/20 length with a traction-free back, which bends over its
/// asperities, its moduli differ from cell to cell, or its elements are nearly
/// incompressible and lock.
bool may_lose_contact(const Instance& instance);

/// Returns the finite-element request of an instance, of degree 1 or 2. The
/// cells of the surface layer are cubic or, in a thin block, half as high.
fem::BlockRequest block_request(const Instance& instance, const Grid& grid,
                                int degree, int threads);

/// Returns the full 3-D model of an instance: the block of a condensed one,
/// with random moduli and, where the instance has one, a meshed counter-body.
/// @throws std::domain_error  a refusal by meshes/ or fem/
std::unique_ptr<fem::FullBlock> full_block_of(const Instance& instance,
                                              const Grid& grid,
                                              mechanics::LinearSolver solver);

/// Returns the surface operator of an elastic instance.
/// @throws std::domain_error  a refusal by contact/, meshes/ or fem/
std::unique_ptr<contact::SurfaceOperator>
operator_of(const Instance& instance, const Grid& grid, int threads);

/// The compliance C of the longest and of the shortest of the waves with 1, 2,
/// 4, ... periods along x [m/Pa].
struct ComplianceRange {
  double longest = 0.0;
  double shortest = 0.0;
};

ComplianceRange compliance_range(const Grid& grid, const Displace& displace);

/// Verifies all pairs of consecutive steps, and the unloading branch of a cycle
/// against its loading branch.
std::optional<Failure> verify_program(const Instance& instance,
                                      const std::vector<StepSummary>& steps);

/// Writes the step of the instance's own load into the report.
/// @param height_scale  [m], see InstanceSurface
void report_load_step(const StepSummary& step, double height_scale,
                      InstanceReport& report);

/// Writes a failure into the report.
void fail(InstanceReport& report, const Failure& failure);

} // namespace asperity::robustness
