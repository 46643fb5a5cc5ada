#pragma once

// FullBlock on one mesh. It ties the linear system, the contact problem and the
// output together.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_problem.hpp"
#include "fem/newton/contact_newton.hpp"
#include "fem/solution/block_output.hpp"
#include "fem/solution/face_maps.hpp"

namespace asperity::fem {

class MeshedBlock final : public FullBlock {
public:
  /// @param triangulation  the mesh in place of that of the problem, which must
  ///                       cover the same box; null for that of the problem
  /// @throws std::domain_error  under the conditions of make_full_block
  explicit MeshedBlock(
      const BlockProblem& problem,
      const std::shared_ptr<dealii::parallel::TriangulationBase<3>>&
          triangulation = {});

  const Grid& grid() const override { return system_.grid(); }

  std::size_t unknowns() const override { return system_.n_unknowns(); }

  std::span<const double> nodal_weights() const override { return weights_; }

  std::string report() const override { return report_; }

  std::vector<double> displacement(std::span<const double> pressure) override;

  BlockSolution solve(std::span<const double> heights,
                      const mechanics::LoadTarget& load,
                      const BlockContact& contact) override;

  std::vector<double> memory() const override;
  bool recall(std::span<const double> memory) override;

  /// solve() without the estimate of the error.
  BlockSolution solve_contact(std::span<const double> heights,
                              const mechanics::LoadTarget& load,
                              const BlockContact& contact);

  /// BlockSolution::estimated_gap_error of the last solution [m].
  /// @param ratio  of the moduli up to which materials are similar [1] >= 1
  double estimated_gap_error(const BlockSolution& solution, double ratio) const;

  ContactStiffness stiffness() override;

  BlockConduction conduction() const override;

  StressPeak strongest_stress() const override;

  std::vector<double> section(const SectionPlane& plane) const override;

  void write(const std::string& folder_and_stem) override;

  const BlockSystem& system() const { return system_; }

  const FaceMaps& maps() const { return maps_; }

  ContactNewton& newton() { return newton_; }

  const ContactNewton& newton() const { return newton_; }

  /// The files written so far, whose numbers the block on another mesh
  /// continues.
  const BlockOutput& output() const { return output_; }

  void continue_output(const BlockOutput& output) { output_ = output; }

  /// Refuses arguments of solve() that are outside their range.
  /// @throws std::domain_error  as solve()
  void require_arguments(std::span<const double> heights,
                         const mechanics::LoadTarget& load,
                         const BlockContact& contact) const;

private:
  bool is_contact_on_grid(std::span<const double> pressure) const;
  double weighted_mean(std::span<const double> field) const;
  void require_field(const char* name, std::span<const double> field,
                     const char* unit) const;

  BlockSystem system_;
  FaceMaps maps_;
  std::vector<double> weights_;
  std::string report_; ///< computed on all ranks together
  ContactNewton newton_;
  BlockOutput output_;
  mechanics::FarBoundary far_boundary_;
  double depth_; ///< [m]
  // Of the last solution.
  std::vector<double> heights_;   ///< of the grid [m]; empty before the first
  double nominal_pressure_ = 0.0; ///< [Pa]
};

} // namespace asperity::fem
