#include "fem/solution/block_output.hpp"

#include "fem/parallel/step_files.hpp"

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/numerics/data_out.h>

#include <filesystem>

namespace asperity::fem {
namespace {

using Interpretation =
    dealii::DataComponentInterpretation::DataComponentInterpretation;

/// Converts the six entries of a symmetric stress, in deal.II's order, to the
/// output fields.
class StressFields final : public dealii::DataPostprocessor<3> {
public:
  std::vector<std::string> get_names() const override {
    std::vector<std::string> names(9, "stress");
    names.insert(names.begin(), {"von_mises", "vertical_pressure"});
    return names;
  }

  std::vector<Interpretation>
  get_data_component_interpretation() const override {
    std::vector<Interpretation> kinds(
        11, dealii::DataComponentInterpretation::component_is_part_of_tensor);
    kinds[0] = kinds[1] =
        dealii::DataComponentInterpretation::component_is_scalar;
    return kinds;
  }

  dealii::UpdateFlags get_needed_update_flags() const override {
    return dealii::update_values;
  }

  void evaluate_vector_field(
      const dealii::DataPostprocessorInputs::Vector<3>& input,
      std::vector<dealii::Vector<double>>& fields) const override {
    for (std::size_t point = 0; point < fields.size(); ++point) {
      StressTensor stress;
      for (unsigned int c = 0; c < 6; ++c)
        stress.access_raw_entry(c) = input.solution_values[point](c);
      fields[point](0) = von_mises(stress);
      fields[point](1) = -stress[2][2];
      for (unsigned int i = 0; i < 9; ++i)
        fields[point](2 + i) = stress[i / 3][i % 3];
    }
  }
};

/// A space of discontinuous nodal stresses, numbered by deal.II.
class StressSpace {
public:
  explicit StressSpace(const BlockSpace& space)
      : element_(space.triangulation().all_reference_cells_are_hyper_cube()
                     ? dealii::FESystem<3>(dealii::FE_DGQ<3>(1), 6)
                     : dealii::FESystem<3>(dealii::FE_SimplexDGP<3>(1), 6)),
        dof_handler_(space.triangulation()) {
    dof_handler_.distribute_dofs(element_);
    values_.reinit(dof_handler_.locally_owned_dofs(), MPI_COMM_WORLD);
  }

  void take(BlockStress& stress) {
    dealii::Vector<double> in_cell(element_.n_dofs_per_cell());
    stress.at_vertices([&](const BlockStress::Cell& cell,
                           std::span<const StressTensor> at_vertex) {
      for (unsigned int i = 0; i < in_cell.size(); ++i) {
        const auto [component, vertex] = element_.system_to_component_index(i);
        in_cell(i) = at_vertex[vertex].access_raw_entry(component);
      }
      const dealii::DoFHandler<3>::active_cell_iterator here(
          &dof_handler_.get_triangulation(), cell->level(), cell->index(),
          &dof_handler_);
      here->set_dof_values(in_cell, values_);
    });
  }

  const dealii::DoFHandler<3>& dof_handler() const { return dof_handler_; }

  const dealii::LinearAlgebra::distributed::Vector<double>& values() const {
    return values_;
  }

private:
  dealii::FESystem<3> element_;
  dealii::DoFHandler<3> dof_handler_;
  dealii::LinearAlgebra::distributed::Vector<double> values_;
};

/// Values on all cells of this rank, by active cell index.
struct CellFields {
  explicit CellFields(const BlockSystem& system)
      : youngs_modulus(system.space().triangulation().n_active_cells()),
        subdomain(youngs_modulus.size()),
        level(youngs_modulus.size()) {
    for (const auto& cell :
         system.space().triangulation().active_cell_iterators()) {
      if (cell->is_artificial())
        continue;
      const Moduli material = system.moduli_of(cell);
      const double mu = material.shear_modulus;
      const double lambda = material.lame_modulus;
      youngs_modulus(cell->active_cell_index()) =
          mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu);
      subdomain(cell->active_cell_index()) = cell->subdomain_id();
      level(cell->active_cell_index()) = cell->level();
    }
  }

  dealii::Vector<double> youngs_modulus; ///< [Pa]
  dealii::Vector<double> subdomain;
  dealii::Vector<double> level;
};

/// Fills the output with all fields of the block.
void add_fields(const BlockSystem& system, BlockStress& stress,
                const StressSpace& nodal, const CellFields& cells,
                const StressFields& fields, dealii::DataOut<3>& data) {
  data.attach_triangulation(system.space().triangulation());
  data.add_data_vector(
      system.space().dof_handler(), stress.displacement(),
      std::vector<std::string>(3, "displacement"),
      std::vector<Interpretation>(
          3, dealii::DataComponentInterpretation::component_is_part_of_vector));
  data.add_data_vector(nodal.dof_handler(), nodal.values(), fields);
  data.add_data_vector(cells.youngs_modulus, "youngs_modulus");
  data.add_data_vector(cells.subdomain, "subdomain");
  data.add_data_vector(cells.level, "level");
  data.build_patches(system.space().mapping(), system.space().element().degree,
                     dealii::DataOut<3>::no_curved_cells);
}

} // namespace

void BlockOutput::write(const std::string& folder_and_stem,
                        const BlockSystem& system, BlockStress& stress,
                        const SurfaceOutput& surface, double nominal_pressure) {
  std::vector<double> pressures = steps_[folder_and_stem];
  pressures.push_back(nominal_pressure);
  const StressFields fields;
  StressSpace nodal(system.space());
  nodal.take(stress);
  const CellFields cells(system);
  const dealii::DataOutBase::VtkFlags flags(
      nominal_pressure, static_cast<unsigned int>(pressures.size()) - 1, false,
      dealii::DataOutBase::VtkFlags::best_speed);
  dealii::DataOut<3> data;
  add_fields(system, stress, nodal, cells, fields, data);
  data.set_flags(flags);

  const std::filesystem::path path = folder_and_stem;
  const std::string stem = path.filename().string();
  const StepSeries block{
      stem, [&](std::ostream& to) { data.write_vtu(to); },
      [&](std::ostream& to, const std::vector<std::string>& parts) {
        data.write_pvtu_record(to, parts);
      }};
  write_step(path.parent_path(),
             {block, surface.series(stem + "_surface", flags)}, pressures);
  steps_[folder_and_stem] = std::move(pressures);
}

} // namespace asperity::fem
