#include "fem/solution/block_output.hpp"

#include "base/special_numbers.hpp"
#include "fem/parallel/step_files.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace asperity::fem {
namespace {

using dealii::Point;
using Cell = dealii::DoFHandler<3>::active_cell_iterator;
using Patch = dealii::DataOutBase::Patch<2, 3>;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

const std::vector<std::string> field_names{
    "displacement", "displacement", "displacement", "gap",
    "pressure",     "contact",      "level"};

using VectorRanges = std::vector<std::tuple<
    unsigned int, unsigned int, std::string,
    dealii::DataComponentInterpretation::DataComponentInterpretation>>;

const VectorRanges vector_ranges{
    {0, 2, "displacement",
     dealii::DataComponentInterpretation::component_is_part_of_vector}};

/// The nodes of a face in its reference coordinates, in the order of a patch.
std::vector<Point<2>> face_nodes_of(const BlockSpace& space) {
  if (space.triangulation().all_reference_cells_are_hyper_cube())
    return dealii::QIterated<2>(dealii::QTrapezoid<1>(), space.element().degree)
        .get_points();
  return {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
}

/// A point of a face in the reference coordinates of its cell. It is exact at
/// nodes, so that the functions of other nodes vanish there.
Point<3> unit_point(const dealii::ReferenceCell& cell, unsigned int face,
                    const Point<2>& on_face) {
  constexpr unsigned char standard_orientation = 1;
  const dealii::ReferenceCell shape = cell.face_reference_cell(face);
  Point<3> unit;
  for (unsigned int v = 0; v < shape.n_vertices(); ++v)
    unit += shape.d_linear_shape_function<2>(on_face, v) *
            cell.vertex<3>(
                cell.face_to_cell_vertices(face, v, standard_orientation));
  return unit;
}

/// A node of one face of this rank.
struct SurfaceNode {
  Point<3> unit; ///< in reference coordinates of the cell
  Point<3> place;
  FaceRow row; ///< of w
};

/// A face of this rank on the contact surface.
struct SurfaceFace {
  Cell cell;
  std::vector<SurfaceNode> nodes;
};

class SurfaceFaces {
public:
  explicit SurfaceFaces(const BlockSystem& system)
      : system_(system),
        nodes_(face_nodes_of(system.space())),
        needed_(system.space().owned()) {
    for_contact_faces(system.space(), [&](const Cell& cell, unsigned int f) {
      take_face(cell, f);
    });
    needed_.compress();
  }

  const std::vector<SurfaceFace>& faces() const { return faces_; }

  /// Of all nodes of all faces.
  std::vector<Point<2>> places() const {
    std::vector<Point<2>> places;
    for (const SurfaceFace& face : faces_)
      for (const SurfaceNode& node : face.nodes)
        places.emplace_back(node.place[0], node.place[1]);
    return places;
  }

  /// The vector with all entries that the rows of this rank need.
  Vector ghosted(const Vector& owned) const {
    Vector ghosted(system_.space().owned(), needed_, MPI_COMM_WORLD);
    ghosted = owned;
    return ghosted;
  }

  /// Whether a node is a contact point: it is no hanging node.
  bool is_contact_point(const SurfaceNode& node) const {
    return std::abs(node.row.front().second - 1.0) < 1e-12;
  }

private:
  void take_face(const Cell& cell, unsigned int f) {
    const ContactPoints& points = system_.contact();
    SurfaceFace& face = faces_.emplace_back(SurfaceFace{cell, {}});
    for (const Point<2>& on_face : nodes_) {
      SurfaceNode node;
      node.unit = unit_point(cell->reference_cell(), f, on_face);
      node.place = system_.space().mapping().transform_unit_to_real_cell(
          cell, node.unit);
      node.row = points.row_at(cell, node.unit);
      for (const auto& entry : node.row)
        needed_.add_index(entry.first);
      face.nodes.push_back(std::move(node));
    }
  }

  const BlockSystem& system_;
  std::vector<Point<2>> nodes_;
  std::vector<SurfaceFace> faces_;
  dealii::IndexSet needed_;
};

/// The value at a node that a row of shape values gives.
double value_of(const FaceRow& row, const Vector& unknowns) {
  double value = 0.0;
  for (const auto& [unknown, share] : row)
    value += share * unknowns(unknown);
  return value;
}

/// The displacement u at a node of a face [m].
dealii::Tensor<1, 3> displacement_at(const SurfaceFace& face,
                                     const SurfaceNode& node,
                                     const Vector& displacement) {
  const dealii::FiniteElement<3>& element = face.cell->get_fe();
  dealii::Vector<double> in_cell(element.n_dofs_per_cell());
  face.cell->get_dof_values(displacement, in_cell);
  dealii::Tensor<1, 3> value;
  for (unsigned int i = 0; i < in_cell.size(); ++i)
    value[element.system_to_component_index(i).first] +=
        in_cell(i) * element.shape_value(i, node.unit);
  return value;
}

/// The pressures at the unknowns u_z of their nodes [Pa].
Vector nodal_pressure(const BlockSystem& system,
                      const std::vector<double>& pressure) {
  Vector nodal = system.space().make_vector();
  for (std::size_t i = 0; i < pressure.size(); ++i)
    nodal(system.contact()[i].row.front().first) = pressure[i];
  nodal.compress(dealii::VectorOperation::insert);
  return nodal;
}

Patch patch_of(const SurfaceFace& face, std::size_t index,
               unsigned int degree) {
  const bool is_quadrilateral = face.cell->reference_cell().is_hyper_cube();
  Patch patch;
  patch.reference_cell = is_quadrilateral
                             ? dealii::ReferenceCells::Quadrilateral
                             : dealii::ReferenceCells::Triangle;
  patch.patch_index = static_cast<unsigned int>(index);
  patch.n_subdivisions = degree;
  patch.points_are_available = true;
  patch.data.reinit(static_cast<unsigned int>(field_names.size()) + 3,
                    static_cast<unsigned int>(face.nodes.size()));
  return patch;
}

} // namespace

SurfaceOutput::SurfaceOutput(const FaceMaps& maps, const ContactState& state,
                             const Vector& displacement,
                             std::span<const double> heights) {
  const BlockSystem& system = maps.system();
  SurfaceFaces surface(system);
  const Vector unknowns = surface.ghosted(state.displacement);
  const Vector nodal = surface.ghosted(nodal_pressure(system, state.pressure));
  const auto pressure_at = [&](const SurfaceNode& node) {
    return std::max(0.0, value_of(node.row, nodal));
  };
  const auto status_at = [&](const SurfaceNode& node) {
    if (!surface.is_contact_point(node))
      return not_a_number;
    return pressure_at(node) > 0.0 ? 1.0 : 0.0;
  };
  const auto gap_at = [&](const SurfaceNode& node, double height) {
    return state.rigid_gap + value_of(node.row, unknowns) -
           (height - state.highest);
  };
  const bool is_solved = !heights.empty();
  const std::vector<double> at_nodes =
      is_solved ? maps.values_at(heights, surface.places())
                : std::vector<double>();
  std::size_t n_nodes = 0;
  for (const SurfaceFace& face : surface.faces()) {
    Patch patch =
        patch_of(face, patches_.size(), system.space().element().degree);
    for (unsigned int i = 0; i < face.nodes.size(); ++i) {
      const SurfaceNode& node = face.nodes[i];
      const auto moved = displacement_at(face, node, displacement);
      const std::array<double, 10> column{
          moved[0],
          moved[1],
          moved[2],
          is_solved ? gap_at(node, at_nodes[n_nodes++]) : not_a_number,
          is_solved ? pressure_at(node) : not_a_number,
          is_solved ? status_at(node) : not_a_number,
          static_cast<double>(face.cell->level()),
          node.place[0],
          node.place[1],
          node.place[2]};
      for (unsigned int row = 0; row < column.size(); ++row)
        patch.data(row, i) = static_cast<float>(column[row]);
    }
    patches_.push_back(std::move(patch));
  }
}

StepSeries
SurfaceOutput::series(const std::string& stem,
                      const dealii::DataOutBase::VtkFlags& flags) const {
  return {stem,
          [this, flags](std::ostream& to) {
            dealii::DataOutBase::write_vtu(patches_, field_names, vector_ranges,
                                           flags, to);
          },
          [flags](std::ostream& to, const std::vector<std::string>& parts) {
            dealii::DataOutBase::write_pvtu_record(to, parts, field_names,
                                                   vector_ranges, flags);
          }};
}

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
