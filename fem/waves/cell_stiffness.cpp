#include "fem/waves/cell_stiffness.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <cmath>

namespace asperity::fem {
namespace {

using dealii::FE_Q;
using dealii::FESystem;
using dealii::FEValues;
using dealii::Point;
using dealii::QGauss;

/// The row, in the order of CellStiffness, of each of deal.II's local unknowns.
std::vector<std::size_t> rows_by_place(const FESystem<3>& element,
                                       const CellStiffness& stiffness) {
  std::vector<std::size_t> rows(element.n_dofs_per_cell());
  for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i) {
    const Point<3> unit = element.unit_support_point(i);
    std::array<std::size_t, 3> place{};
    for (unsigned int axis = 0; axis < 3; ++axis)
      place[axis] =
          static_cast<std::size_t>(std::lround(unit[axis] * stiffness.degree));
    rows[i] = stiffness.row(place[0], place[1], place[2],
                            element.system_to_component_index(i).first);
  }
  return rows;
}

} // namespace

CellStiffness cell_stiffness(int degree, double dx, double dy,
                             const ElasticLayer& layer) {
  CellStiffness stiffness{degree, {}};
  stiffness.entries.assign(stiffness.size() * stiffness.size(), 0.0);
  dealii::Triangulation<3> triangulation;
  dealii::GridGenerator::hyper_rectangle(triangulation, Point<3>(),
                                         Point<3>(dx, dy, layer.thickness));
  const FESystem<3> element(FE_Q<3>(static_cast<unsigned int>(degree)), 3);
  const QGauss<3> quadrature(static_cast<unsigned int>(degree) + 1);
  FEValues<3> values(element, quadrature,
                     dealii::update_gradients | dealii::update_JxW_values);
  values.reinit(triangulation.begin_active());
  const dealii::FEValuesExtractors::Vector displacement(0);
  const std::vector<std::size_t> rows = rows_by_place(element, stiffness);

  for (const unsigned int q : values.quadrature_point_indices())
    for (const unsigned int i : values.dof_indices()) {
      const auto strain_i = values[displacement].symmetric_gradient(i, q);
      for (const unsigned int j : values.dof_indices()) {
        const auto strain_j = values[displacement].symmetric_gradient(j, q);
        stiffness.entries[rows[i] * stiffness.size() + rows[j]] +=
            (layer.lame_modulus * trace(strain_i) * trace(strain_j) +
             2.0 * layer.shear_modulus * (strain_i * strain_j)) *
            values.JxW(q);
      }
    }
  return stiffness;
}

std::vector<double> relative_nodal_areas(int degree) {
  dealii::Triangulation<2> triangulation;
  dealii::GridGenerator::hyper_cube(triangulation);
  const FE_Q<2> element(static_cast<unsigned int>(degree));
  const QGauss<2> quadrature(static_cast<unsigned int>(degree) + 1);
  FEValues<2> values(element, quadrature,
                     dealii::update_values | dealii::update_JxW_values);
  values.reinit(triangulation.begin_active());
  std::vector<double> area(4, 0.0);
  for (const unsigned int i : values.dof_indices()) {
    const Point<2> unit = element.unit_support_point(i);
    const auto a = std::lround(unit[0] * degree) % degree;
    const auto b = std::lround(unit[1] * degree) % degree;
    for (const unsigned int q : values.quadrature_point_indices())
      area[static_cast<std::size_t>(a + 2 * b)] +=
          values.shape_value(i, q) * values.JxW(q) * degree * degree;
  }
  if (degree == 1)
    area = {area[0], area[0], area[0], area[0]};
  return area;
}

} // namespace asperity::fem
