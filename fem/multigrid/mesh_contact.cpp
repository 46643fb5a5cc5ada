#include "fem/multigrid/mesh_contact.hpp"

#include "base/ranks/rank_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::fem {

template <class Number>
double ContactPairs::on_face(std::size_t pair,
                             const Number* displacement) const {
  double sum = 0.0;
  for (std::size_t i = faces.start[pair]; i < faces.start[pair + 1]; ++i)
    sum += faces.weight[i] * static_cast<double>(displacement[faces.column[i]]);
  return sum;
}

template <class Number>
void ContactPairs::add_common(Number* displacement) const {
  if (!exist)
    return;
  if (ghosts != nullptr)
    ghosts->fill_ghosts(displacement);
  for (std::size_t pair = 0; pair < nodes.size(); ++pair)
    displacement[nodes[pair]] +=
        static_cast<Number>(on_face(pair, displacement));
}

template <class Number>
void ContactPairs::add_to_faces(Number* force) const {
  if (!exist)
    return;
  for (std::size_t pair = 0; pair < nodes.size(); ++pair)
    for (std::size_t i = faces.start[pair]; i < faces.start[pair + 1]; ++i)
      force[faces.column[i]] += static_cast<Number>(
          faces.weight[i] * static_cast<double>(force[nodes[pair]]));
  if (ghosts != nullptr)
    ghosts->add_to_owners(force);
}

void ContactPairs::add_spring_force(const double* displacement,
                                    double* force) const {
  for (std::size_t pair = 0; pair < nodes.size(); ++pair) {
    const double own = springs[pair] * (displacement[nodes[pair]] -
                                        on_face(pair, displacement));
    force[nodes[pair]] += own;
    for (std::size_t i = faces.start[pair]; i < faces.start[pair + 1]; ++i)
      force[faces.column[i]] -= faces.weight[i] * own;
  }
}

template void ContactPairs::add_common(float*) const;
template void ContactPairs::add_common(double*) const;
template void ContactPairs::add_to_faces(float*) const;
template void ContactPairs::add_to_faces(double*) const;

std::vector<std::size_t> MeshContact::held_unknowns(std::size_t step) const {
  std::vector<std::size_t> all = pinned;
  for (const std::size_t normal : held)
    for (std::size_t before = is_sticking ? 3 : 1; before-- > 0;)
      all.push_back(normal - before * step);
  return all;
}

MeshContact MeshContact::in_units_of(double stiffness) const {
  MeshContact scaled = *this;
  for (double& spring : scaled.springs.weight)
    spring /= stiffness;
  for (double& spring : scaled.pairs.springs)
    spring /= stiffness;
  return scaled;
}

template <class Number>
void MeshContact::add_spring_force(const Number* displacement, Number* force,
                                   double factor) const {
  for (std::size_t row = 0; row < springs.rows(); ++row) {
    double sum = 0.0;
    for (std::size_t i = springs.start[row]; i < springs.start[row + 1]; ++i)
      sum += springs.weight[i] *
             static_cast<double>(displacement[unknowns[springs.column[i]]]);
    force[unknowns[row]] += static_cast<Number>(factor * sum);
  }
}

template void MeshContact::add_spring_force(const float*, float*, double) const;
template void MeshContact::add_spring_force(const double*, double*,
                                            double) const;

namespace {

/// Appends the node of a contact pair, the first of the point's row, and the
/// face of the other body, which the row subtracts.
void append_pair(const SparseRows& points, std::size_t point, double spring,
                 ContactPairs& pairs) {
  const std::size_t first = points.start[point];
  pairs.nodes.push_back(points.column[first]);
  pairs.springs.push_back(spring);
  for (std::size_t i = first + 1; i < points.start[point + 1]; ++i) {
    pairs.faces.column.push_back(points.column[i]);
    pairs.faces.weight.push_back(-points.weight[i]);
  }
  pairs.faces.start.push_back(pairs.faces.column.size());
}

} // namespace

MeshContact contact_of_points(const SparseRows& points,
                              const PointContact& contact, std::size_t size,
                              RankGroup* ranks) {
  MeshContact result;
  result.is_sticking = contact.is_sticking;
  SparseRows scaled; // by number of an unknown in result.unknowns
  std::vector<std::size_t> number(size, 0);
  for (std::size_t point = 0; point < points.rows(); ++point) {
    if (contact.held[point])
      result.held.push_back(points.column[points.start[point]]);
    const double spring = contact.springs[point];
    if (spring == 0.0)
      continue;
    if (contact.is_pair != nullptr && !contact.is_pair->empty() &&
        (*contact.is_pair)[point]) {
      append_pair(points, point, spring, result.pairs);
      continue;
    }
    for (std::size_t i = points.start[point]; i < points.start[point + 1];
         ++i) {
      const std::size_t unknown = points.column[i];
      if (number[unknown] == 0) {
        result.unknowns.push_back(unknown);
        number[unknown] = result.unknowns.size();
      }
      scaled.column.push_back(number[unknown] - 1);
      scaled.weight.push_back(points.weight[i] * std::sqrt(spring));
    }
    scaled.start.push_back(scaled.column.size());
  }
  const std::size_t n = result.unknowns.size();
  if (n > 0)
    result.springs = product(transposed(scaled, n), scaled, n);
  result.has_springs = rank_max(ranks, n > 0 ? 1.0 : 0.0) > 0.0;
  result.pairs.exist =
      rank_max(ranks, result.pairs.nodes.empty() ? 0.0 : 1.0) > 0.0;
  return result;
}

MeshContact of_all_ranks(RankGroup& ranks, const MeshContact& own) {
  struct Spring {
    std::size_t row = 0, column = 0;
    double value = 0.0;
  };

  const auto of_all = [&ranks](const auto& values) {
    return values_of_ranks(&ranks, std::span(values));
  };
  MeshContact all;
  all.has_springs = own.has_springs;
  all.is_sticking = own.is_sticking;
  all.held = of_all(own.held);
  all.unknowns = of_all(own.unknowns);
  for (auto* const unknowns : {&all.held, &all.unknowns}) {
    std::ranges::sort(*unknowns);
    unknowns->erase(std::unique(unknowns->begin(), unknowns->end()),
                    unknowns->end());
  }
  std::vector<Spring> springs;
  for (std::size_t row = 0; row < own.springs.rows(); ++row)
    for (std::size_t k = own.springs.start[row]; k < own.springs.start[row + 1];
         ++k)
      springs.push_back({own.unknowns[row], own.unknowns[own.springs.column[k]],
                         own.springs.weight[k]});
  springs = of_all(springs);
  std::ranges::stable_sort(springs, {}, &Spring::row);
  auto next = springs.begin();
  for (const std::size_t row : all.unknowns) {
    for (; next != springs.end() && next->row == row; ++next) {
      all.springs.column.push_back(static_cast<std::size_t>(
          std::ranges::lower_bound(all.unknowns, next->column) -
          all.unknowns.begin()));
      all.springs.weight.push_back(next->value);
    }
    all.springs.start.push_back(all.springs.column.size());
  }
  return all;
}

void ContactTransfer::add_node(std::size_t fine) {
  fine_.emplace_back(fine, fine_.size());
  if (fine_.size() > 1)
    rows_.start.push_back(rows_.column.size());
}

void ContactTransfer::add_master(std::size_t coarse, double weight) {
  rows_.column.push_back(coarse);
  rows_.weight.push_back(weight);
}

/// Numbers the coarse nodes.
void ContactTransfer::finish() {
  if (!fine_.empty())
    rows_.start.push_back(rows_.column.size());
  coarse_ = rows_.column;
  std::ranges::sort(coarse_);
  coarse_.erase(std::unique(coarse_.begin(), coarse_.end()), coarse_.end());
  for (std::size_t& column : rows_.column)
    column = static_cast<std::size_t>(
        std::ranges::lower_bound(coarse_, column) - coarse_.begin());
  std::ranges::sort(fine_);
  std::ranges::sort(held_);
}

MeshContact ContactTransfer::coarse(const MeshContact& fine) const {
  MeshContact found;
  found.has_springs = fine.has_springs;
  found.is_sticking = fine.is_sticking;
  for (const std::size_t unknown : fine.held)
    for (auto pair = std::ranges::lower_bound(held_, Pair(unknown, 0));
         pair != held_.end() && pair->first == unknown; ++pair)
      found.held.push_back(pair->second);
  if (fine.unknowns.empty())
    return found;
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> number(coarse_.size(), none);
  SparseRows face; // P of the nodes with springs, by number in found.unknowns
  for (const std::size_t unknown : fine.unknowns) {
    const auto node = std::ranges::lower_bound(fine_, Pair(unknown, 0));
    if (node != fine_.end() && node->first == unknown)
      for (std::size_t i = rows_.start[node->second];
           i < rows_.start[node->second + 1]; ++i) {
        std::size_t& own = number[rows_.column[i]];
        if (own == none) {
          own = found.unknowns.size();
          found.unknowns.push_back(coarse_[rows_.column[i]]);
        }
        face.column.push_back(own);
        face.weight.push_back(rows_.weight[i]);
      }
    face.start.push_back(face.column.size());
  }
  const std::size_t size = found.unknowns.size();
  if (size > 0)
    found.springs = product(transposed(face, size),
                            product(fine.springs, face, size), size);
  return found;
}

} // namespace asperity::fem
