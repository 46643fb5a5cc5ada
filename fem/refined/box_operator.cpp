#include "fem/refined/box_operator.hpp"

#include "ranks/rank_sums.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>

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

/// The numbers of the cells of a group as a BoxProduct has them. The cells that
/// fill up the last group have edges but no stiffness.
template <class Number>
std::array<Number, boxes_in_group * numbers_in_box>
numbers_of_group(const BoxMesh& mesh, std::size_t group) {
  std::array<Number, boxes_in_group * numbers_in_box> numbers{};
  for (std::size_t lane = 0; lane < boxes_in_group; ++lane) {
    const std::size_t cell = group * boxes_in_group + lane;
    const bool is_real = cell < mesh.edges.size();
    const CellModuli moduli = is_real ? mesh.moduli[cell] : CellModuli{};
    const std::array<double, 3> edge =
        is_real ? mesh.edges[cell] : std::array<double, 3>{1.0, 1.0, 1.0};
    std::size_t place = lane;
    for (const double number :
         {edge[0], edge[1], edge[2], moduli.lame, moduli.shear}) {
      numbers[place] = static_cast<Number>(number);
      place += boxes_in_group;
    }
  }
  return numbers;
}

} // namespace

SharedNodes shared_nodes(std::vector<std::uint32_t> nodes) {
  constexpr std::size_t in_group = boxes_in_group * nodes_in_box;
  nodes.resize((nodes.size() + in_group - 1) / in_group * in_group, 0);
  return std::make_shared<const std::vector<std::uint32_t>>(std::move(nodes));
}

MeshUnits units_of(const BoxMesh& mesh) {
  double shortest = std::numeric_limits<double>::max(), stiffest = 0.0;
  for (const auto& cell : mesh.edges)
    shortest = std::min(shortest, std::ranges::min(cell));
  for (const CellModuli& cell : mesh.moduli)
    stiffest = std::max(stiffest, cell.shear);
  RankGroup* const ranks = mesh.unknowns.ranks();
  return {-rank_max(ranks, -shortest), rank_max(ranks, stiffest)};
}

BoxMesh scaled(const BoxMesh& mesh, const MeshUnits& units) {
  BoxMesh result = mesh;
  for (auto& cell : result.edges)
    for (double& edge : cell)
      edge /= units.length;
  for (CellModuli& cell : result.moduli)
    cell = {cell.lame / units.modulus, cell.shear / units.modulus};
  return result;
}

std::vector<double> diagonal_of(const BoxMesh& mesh) {
  std::vector<double> sum(mesh.unknowns.size, 0.0);
  for (std::size_t cell = 0; cell < mesh.edges.size(); ++cell) {
    const auto own = box_diagonal(mesh.edges[cell], mesh.moduli[cell]);
    for (std::size_t a = 0; a < nodes_in_box; ++a)
      for (std::size_t i = 0; i < 3; ++i)
        sum[(*mesh.nodes)[cell * nodes_in_box + a] + i] += own[i];
  }
  mesh.unknowns.constraints->condense_diagonal(sum);
  mesh.unknowns.collect(sum.data());
  return sum;
}

template <class Number>
BoxOperator<Number>::BoxOperator(const BoxMesh& mesh)
    : MeshOperator<Number>(mesh.unknowns), nodes_(mesh.nodes) {
  constexpr std::size_t in_group = boxes_in_group * numbers_in_box;
  std::map<std::array<Number, in_group>, std::uint32_t> known;
  const std::size_t groups = nodes_->size() / (nodes_in_box * boxes_in_group);
  for (std::size_t group = 0; group < groups; ++group) {
    const auto own = numbers_of_group<Number>(mesh, group);
    const auto next = static_cast<std::uint32_t>(known.size());
    const auto [kind, is_new] = known.emplace(own, next);
    if (is_new)
      boxes_.insert(boxes_.end(), own.begin(), own.end());
    kinds_.push_back(kind->second);
  }
}

template <class Number>
void BoxOperator<Number>::add_cells(const Number* displacement, Number* force,
                                    Number factor) const {
  BoxProduct<Number> product;
  product.from = displacement;
  product.to = force;
  product.groups = kinds_.size();
  product.nodes = nodes_->data();
  product.boxes = boxes_.data();
  product.kinds = kinds_.data();
  product.factor = factor;
  multiply_boxes(product);
}

template <class Number>
std::size_t BoxOperator<Number>::bytes() const {
  const std::size_t nodes = std::is_same_v<Number, float> ? nodes_->size() : 0;
  return (nodes + kinds_.size()) * sizeof(std::uint32_t) +
         boxes_.size() * sizeof(Number);
}

template class BoxOperator<float>;
template class BoxOperator<double>;

} // namespace asperity::fem
