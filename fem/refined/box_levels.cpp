#include "fem/refined/box_levels.hpp"

#include "base/ranks/rank_sums.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
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
  for (const FlowingBox& box : flowing_)
    add_flow(box, displacement, force, static_cast<double>(factor));
}

template <class Number>
void BoxOperator<Number>::set_tangents(std::span<const CellTangents> cells) {
  flowing_.clear();
  flowing_.reserve(cells.size());
  for (const CellTangents& cell : cells) {
    FlowingBox& box = flowing_.emplace_back();
    std::copy_n(nodes_->begin() +
                    static_cast<std::ptrdiff_t>(cell.cell * nodes_in_box),
                nodes_in_box, box.nodes.begin());
    const auto number = [&](std::size_t i) {
      return static_cast<double>(
          boxes_[(kinds_.at(cell.cell / boxes_in_group) * numbers_in_box + i) *
                     boxes_in_group +
                 cell.cell % boxes_in_group]);
    };
    box.edges = {number(0), number(1), number(2)};
    std::copy_n(cell.points.begin(), nodes_in_box, box.change.begin());
    for (PointTangent& point : box.change) {
      point.lame -= number(3);
      point.shear -= number(4);
    }
  }
}

template <class Number>
std::size_t BoxOperator<Number>::bytes() const {
  const std::size_t nodes = std::is_same_v<Number, float> ? nodes_->size() : 0;
  return (nodes + kinds_.size()) * sizeof(std::uint32_t) +
         boxes_.size() * sizeof(Number) + flowing_.size() * sizeof(FlowingBox);
}

template class BoxOperator<float>;
template class BoxOperator<double>;

namespace {

using Place = std::array<std::uint32_t, 3>; ///< in edges of the smallest cells

constexpr std::uint32_t no_index = UINT32_MAX;

/// The nodes of halved boxes by their places.
class BoxNodes {
public:
  BoxNodes(const BoxGrid& box_grid, const std::vector<BoxCell>& cells)
      : is_periodic_(box_grid.is_periodic) {
    for (const BoxCell& cell : cells)
      depth_ = std::max(depth_, cell.level);
    extent_ = {static_cast<std::uint32_t>(box_grid.cells_x) << depth_,
               static_cast<std::uint32_t>(box_grid.cells_y) << depth_,
               static_cast<std::uint32_t>(box_grid.layers()) << depth_};
    for (const std::uint32_t along : extent_)
      if (along >= 1U << bits)
        throw std::length_error("a mesh has too many cells along an axis");
    keys_.reserve(cells.size() * nodes_in_box);
    for (const BoxCell& cell : cells)
      for (std::uint32_t v = 0; v < nodes_in_box; ++v)
        keys_.push_back(key(at(cell, {v & 1U, v >> 1U & 1U, v >> 2U}, 1)));
    std::ranges::sort(keys_);
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  }

  std::size_t size() const { return keys_.size(); }

  int depth() const { return depth_; }

  /// A place in a cell, in units of its edge divided by `steps`.
  Place at(const BoxCell& cell, const Place& offset,
           std::uint32_t steps) const {
    const std::uint32_t edge = 1U << (depth_ - cell.level);
    Place place{};
    for (std::size_t i = 0; i < 3; ++i)
      place[i] = static_cast<std::uint32_t>(cell.place[i]) * edge +
                 offset[i] * edge / steps;
    return place;
  }

  /// The number of the node at a place, if there is one.
  std::uint32_t number(const Place& place) const {
    const auto found = std::ranges::lower_bound(keys_, key(place));
    return found == keys_.end() || *found != key(place)
               ? no_index
               : static_cast<std::uint32_t>(found - keys_.begin());
  }

  bool is_far(std::uint32_t node) const {
    return keys_[node] >> (2 * bits) == extent_[2];
  }

private:
  static constexpr unsigned int bits = 21;

  std::uint64_t key(Place place) const {
    if (is_periodic_)
      for (std::size_t i = 0; i < 2; ++i)
        place[i] %= extent_[i];
    std::uint64_t key = place[2];
    key = key << bits | place[1];
    return key << bits | place[0];
  }

  bool is_periodic_;
  int depth_ = 0;
  Place extent_{};
  std::vector<std::uint64_t> keys_;
};

/// Nodes in the middle of an edge or a face of a larger cell.
class HangingNodes {
public:
  HangingNodes(const BoxNodes& nodes, const std::vector<BoxCell>& cells)
      : rows_(nodes.size(), no_index) {
    for (const BoxCell& cell : cells)
      if (cell.level < nodes.depth())
        for (std::uint32_t i = 0; i < 27; ++i)
          add({i % 3, i / 3 % 3, i / 9}, nodes, cell);
  }

  bool is_hanging(std::uint32_t node) const { return rows_[node] != no_index; }

  /// Adds the nodes that a node is interpolated from, none of them hanging.
  void resolve(std::uint32_t node, double weight,
               std::map<std::uint32_t, double>& sum) const {
    if (!is_hanging(node)) {
      sum[node] += weight;
      return;
    }
    const std::vector<std::uint32_t>& masters = masters_[rows_[node]];
    for (const std::uint32_t master : masters)
      resolve(master, weight / static_cast<double>(masters.size()), sum);
  }

private:
  /// @param offset  of the node in halves of the edge
  void add(const Place& offset, const BoxNodes& nodes, const BoxCell& cell) {
    const auto middles = std::ranges::count(offset, 1U);
    if (middles == 0 || middles == 3)
      return;
    const std::uint32_t node = nodes.number(nodes.at(cell, offset, 2));
    if (node == no_index || is_hanging(node))
      return;
    rows_[node] = static_cast<std::uint32_t>(masters_.size());
    std::vector<std::uint32_t>& own = masters_.emplace_back();
    for (std::uint32_t v = 0; v < nodes_in_box; ++v) {
      Place corner{};
      bool is_master = true;
      for (std::size_t i = 0; i < 3; ++i) {
        corner[i] = 2 * (v >> i & 1U);
        is_master = is_master && (offset[i] == 1 || offset[i] == corner[i]);
      }
      if (is_master)
        own.push_back(nodes.number(nodes.at(cell, corner, 2)));
    }
  }

  std::vector<std::uint32_t> rows_;
  std::vector<std::vector<std::uint32_t>> masters_;
};

UnknownConstraints constraints_of(const BoxGrid& box_grid,
                                  const BoxNodes& nodes,
                                  const std::vector<BoxCell>& cells) {
  const HangingNodes hanging(nodes, cells);
  const auto is_held = [&](std::uint32_t node, std::size_t component) {
    return nodes.is_far(node) &&
           (component < 2 ? box_grid.holds_lateral : box_grid.holds_normal);
  };
  UnknownConstraints found;
  std::map<std::uint32_t, double> masters;
  for (std::uint32_t node = 0; node < nodes.size(); ++node) {
    masters.clear();
    if (hanging.is_hanging(node))
      hanging.resolve(node, 1.0, masters);
    else if (!nodes.is_far(node))
      continue;
    for (std::size_t c = 0; c < 3; ++c) {
      if (masters.empty() && !is_held(node, c))
        continue;
      for (const auto& [master, weight] : masters)
        if (!is_held(master, c))
          found.add_master(3 * std::size_t{master} + c, weight);
      found.add(3 * std::size_t{node} + c);
    }
  }
  return found;
}

BoxCell parent_of_box(const BoxCell& cell) {
  return {cell.level - 1,
          {cell.place[0] / 2, cell.place[1] / 2, cell.place[2] / 2}};
}

} // namespace

bool HalvedBoxes::is_box_grid() const {
  return std::ranges::all_of(
      cells, [](const BoxCell& cell) { return cell.level == 0; });
}

HalvedBoxes merged(const BoxGrid& box_grid, const HalvedBoxes& boxes,
                   std::vector<std::uint32_t>& merged_in) {
  std::vector<MeshPlan::Wish> wishes;
  wishes.reserve(boxes.cells.size());
  for (const BoxCell& cell : boxes.cells)
    wishes.push_back({cell, CellChange::coarsen});
  const MeshPlan plan({box_grid.cells_x, box_grid.cells_y, box_grid.layers()},
                      box_grid.is_periodic, wishes);
  if (plan.count().coarsened == 0)
    throw std::logic_error("the cells of a mesh do not merge");
  HalvedBoxes result;
  merged_in.clear();
  std::unordered_map<std::uint64_t, std::uint32_t> number;
  for (std::size_t i = 0; i < boxes.cells.size(); ++i) {
    const BoxCell& cell = boxes.cells[i];
    const bool merges = plan.change_of(cell) == CellChange::coarsen;
    const BoxCell own = merges ? parent_of_box(cell) : cell;
    const auto next = static_cast<std::uint32_t>(result.cells.size());
    const std::uint32_t into =
        merges ? number.emplace(own.key(), next).first->second : next;
    if (into == next) {
      result.cells.push_back(own);
      result.moduli.emplace_back();
    }
    const double share = merges ? 0.125 : 1.0;
    result.moduli[into].lame += share * boxes.moduli[i].lame;
    result.moduli[into].shear += share * boxes.moduli[i].shear;
    merged_in.push_back(into);
  }
  return result;
}

std::array<double, 3> edges_of(const BoxGrid& box_grid, const BoxCell& cell) {
  std::array<double, 3> edges =
      box_grid.cell_size(cell.place[2] / (1 << cell.level));
  for (double& edge : edges)
    edge /= 1 << cell.level;
  return edges;
}

BoxLevel::BoxLevel(const BoxGrid& box_grid, HalvedBoxes own)
    : boxes(std::move(own)) {
  const BoxNodes nodes(box_grid, boxes.cells);
  std::vector<std::uint32_t> corners;
  corners.reserve(nodes_in_box * (boxes.cells.size() + boxes_in_group));
  for (const BoxCell& cell : boxes.cells) {
    for (std::uint32_t v = 0; v < nodes_in_box; ++v)
      corners.push_back(
          3 * nodes.number(nodes.at(cell, {v & 1U, v >> 1U & 1U, v >> 2U}, 1)));
    mesh.edges.push_back(edges_of(box_grid, cell));
  }
  mesh.nodes = shared_nodes(std::move(corners));
  mesh.moduli = boxes.moduli;
  mesh.unknowns.size = 3 * nodes.size();
  mesh.unknowns.constraints = std::make_shared<const UnknownConstraints>(
      constraints_of(box_grid, nodes, boxes.cells));
}

bool BoxLevel::is_constrained(std::size_t unknown) const {
  const UnknownConstraints& constraints = *mesh.unknowns.constraints;
  return constraints.row_of(unknown) < constraints.rows();
}

} // namespace asperity::fem
