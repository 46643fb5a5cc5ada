#include "fem/refined/box_operator.hpp"

#include <algorithm>
#include <limits>

#include "ranks/rank_sums.hpp"

namespace asperity::fem {
namespace {

/// The diagonal of the matrix of a box, the same at each node: the sum over the
/// terms of a component (box_kernel.hpp).
std::array<double, 3> box_diagonal(const std::array<double, 3>& edge,
                                   const CellModuli& moduli) {
  std::array<double, 3> shape{}, diagonal{};
  for (std::size_t i = 0; i < 3; ++i)
    shape[i] = edge[(i + 1) % 3] * edge[(i + 2) % 3] / edge[i] / 9.0;
  for (std::size_t i = 0; i < 3; ++i)
    diagonal[i] = (moduli.lame + moduli.shear) * shape[i] +
                  moduli.shear * (shape[0] + shape[1] + shape[2]);
  return diagonal;
}

} // namespace

void BoxMesh::rescale(double length, double modulus) {
  for (auto& cell : edges)
    for (double& edge : cell)
      edge /= length;
  for (CellModuli& cell : moduli)
    cell = {cell.lame / modulus, cell.shear / modulus};
}

BoxUnits units_of(const BoxMesh& mesh) {
  double shortest = std::numeric_limits<double>::max(), stiffest = 0.0;
  for (const auto& cell : mesh.edges)
    shortest = std::min(shortest, std::ranges::min(cell));
  for (const CellModuli& cell : mesh.moduli)
    stiffest = std::max(stiffest, cell.shear);
  return {-rank_max(mesh.ranks(), -shortest), rank_max(mesh.ranks(), stiffest)};
}

BoxMesh normalised(const BoxMesh& mesh, double& unit) {
  const BoxUnits units = units_of(mesh);
  BoxMesh scaled = mesh;
  scaled.rescale(units.length, units.modulus);
  unit = units.stiffness();
  return scaled;
}

template <class Number>
BoxOperator<Number>::BoxOperator(const BoxMesh& mesh)
    : ghosts_(mesh.ghosts), constraints_(mesh.constraints) {
  const std::size_t cells = mesh.nodes.size();
  const std::size_t stored =
      (cells + boxes_in_group - 1) / boxes_in_group * boxes_in_group;
  nodes_.reserve(stored * nodes_in_box);
  for (const auto& nodes : mesh.nodes)
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  nodes_.resize(stored * nodes_in_box, 0);
  boxes_.resize(stored * numbers_in_box);
  for (std::size_t cell = 0; cell < stored; ++cell) {
    // The cells that fill up the last group have edges but no stiffness.
    const bool is_real = cell < cells;
    const CellModuli moduli = is_real ? mesh.moduli[cell] : CellModuli{};
    const std::array<double, 3> edge =
        is_real ? mesh.edges[cell] : std::array<double, 3>{1.0, 1.0, 1.0};
    Number* to = boxes_.data() +
                 cell / boxes_in_group * boxes_in_group * numbers_in_box +
                 cell % boxes_in_group;
    for (const double number :
         {edge[0], edge[1], edge[2], moduli.lame, moduli.shear}) {
      *to = static_cast<Number>(number);
      to += boxes_in_group;
    }
  }
  take_diagonal(mesh);
}

template <class Number>
void BoxOperator<Number>::take_diagonal(const BoxMesh& mesh) {
  std::vector<double> sum(mesh.unknowns, 0.0);
  for (std::size_t cell = 0; cell < mesh.nodes.size(); ++cell) {
    const auto own = box_diagonal(mesh.edges[cell], mesh.moduli[cell]);
    for (const std::uint32_t node : mesh.nodes[cell])
      for (std::size_t i = 0; i < 3; ++i)
        sum[node + i] += own[i];
  }
  constraints_.condense_diagonal(sum);
  collect(sum.data());
  diagonal_.assign(sum.begin(), sum.end());
}

template <class Number>
void BoxOperator<Number>::apply_own(Number* displacement, Number* force) const {
  if (ghosts_ != nullptr)
    ghosts_->fill_ghosts(displacement);
  constraints_.distribute(displacement);
  std::fill_n(force, size(), Number(0));
  BoxProduct<Number> product;
  product.from = displacement;
  product.to = force;
  product.groups = boxes_.size() / (boxes_in_group * numbers_in_box);
  product.nodes = nodes_.data();
  product.boxes = boxes_.data();
  multiply_boxes(product);
  constraints_.condense(force);
}

template <class Number>
std::size_t BoxOperator<Number>::bytes() const {
  return constraints_.bytes() + nodes_.size() * sizeof(std::uint32_t) +
         (boxes_.size() + diagonal_.size()) * sizeof(Number);
}

template class BoxOperator<float>;
template class BoxOperator<double>;

} // namespace asperity::fem
