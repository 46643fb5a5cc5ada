#include "fem/refined/mesh_plan.hpp"

#include <algorithm>
#include <stdexcept>

namespace asperity::fem {
namespace {

BoxCell parent_of(const BoxCell& cell) {
  return {cell.level - 1,
          {cell.place[0] / 2, cell.place[1] / 2, cell.place[2] / 2}};
}

/// Calls act(cell) for the cells of one level in a range of places, as far as
/// they are inside of the mesh.
/// @param first, last  places; the last is included
/// @param extent       number of cells of this level
template <class Act>
void for_cells(int level, std::array<int, 3> first, std::array<int, 3> last,
               const std::array<int, 3>& extent, const Act& act) {
  for (std::size_t i = 0; i < 3; ++i) {
    first[i] = std::max(first[i], 0);
    last[i] = std::min(last[i], extent[i] - 1);
  }
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int x = first[0]; x <= last[0]; ++x)
        act(BoxCell{level, {x, y, z}});
}

} // namespace

std::uint64_t BoxCell::key() const {
  constexpr unsigned int bits = 20;
  auto key = static_cast<std::uint64_t>(level);
  for (const int along : place)
    key = key << bits | static_cast<std::uint64_t>(along);
  return key;
}

MeshPlan::MeshPlan(const std::array<int, 3>& coarsest, bool is_periodic,
                   const std::vector<Wish>& cells)
    : is_periodic_(is_periodic), coarsest_(coarsest) {
  std::vector<BoxCell> refining;
  std::unordered_map<std::uint64_t, int> willing; // children, by parent
  for (const auto& [cell, change] : cells) {
    leaves_.emplace(cell.key(), false);
    for (BoxCell above = cell; above.level > 0;) {
      above = parent_of(above);
      if (!inner_.insert(above.key()).second)
        break;
    }
    if (change == CellChange::refine)
      refining.push_back(cell);
    if (change == CellChange::coarsen && cell.level > 0)
      ++willing[parent_of(cell).key()];
  }
  refine(std::move(refining));
  std::vector<BoxCell> parents;
  for (const auto& [cell, change] : cells) {
    // The parent is listed with its first child.
    const bool is_first = cell.place[0] % 2 == 0 && cell.place[1] % 2 == 0 &&
                          cell.place[2] % 2 == 0;
    if (is_first && change == CellChange::coarsen && cell.level > 0 &&
        willing.at(parent_of(cell).key()) == 8)
      parents.push_back(parent_of(cell));
  }
  merge(std::move(parents));
}

/// Number of cells along x, y and z if all have this level.
std::array<int, 3> MeshPlan::extent(int level) const {
  return {coarsest_[0] << level, coarsest_[1] << level, coarsest_[2] << level};
}

/// The cells at the opposite periodic sides.
std::vector<BoxCell> MeshPlan::partners(const BoxCell& cell) const {
  std::vector<BoxCell> found;
  if (!is_periodic_)
    return found;
  const std::array<int, 3> cells = extent(cell.level);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const int last = cells[axis] - 1;
    if (cell.place[axis] != 0 && cell.place[axis] != last)
      continue;
    found.push_back(cell);
    found.back().place[axis] = last - cell.place[axis];
  }
  return found;
}

/// Refines cells and those that must refine with them.
void MeshPlan::refine(std::vector<BoxCell> cells) {
  while (!cells.empty()) {
    const BoxCell cell = cells.back();
    cells.pop_back();
    const auto leaf = leaves_.find(cell.key());
    if (leaf == leaves_.end())
      throw std::logic_error(
          "cells of a mesh that meet, or its periodic sides, differ too much");
    if (leaf->second)
      continue;
    leaf->second = true;
    ++count_.refined;
    for (const BoxCell& partner : partners(cell))
      cells.push_back(partner);
    const auto& at = cell.place;
    for_cells(cell.level, {at[0] - 1, at[1] - 1, at[2] - 1},
              {at[0] + 1, at[1] + 1, at[2] + 1}, extent(cell.level),
              [&](const BoxCell& beside) {
                if (beside.level > 0 && !leaves_.contains(beside.key()) &&
                    !inner_.contains(beside.key()))
                  cells.push_back(parent_of(beside));
              });
  }
}

/// Merges the cells of as many parents as possible.
/// @param parents  all of whose children are cells that are to merge
void MeshPlan::merge(std::vector<BoxCell> parents) {
  for (const BoxCell& parent : parents)
    merging_.insert(parent.key());
  std::size_t before = 0;
  do {
    before = parents.size();
    std::erase_if(parents, [&](const BoxCell& parent) {
      if (may_merge(parent))
        return false;
      merging_.erase(parent.key());
      return true;
    });
  } while (parents.size() < before);
  count_.coarsened = 8 * parents.size();
}

/// Whether the parent may replace its children, if all others that are in
/// merging_ replace theirs.
bool MeshPlan::may_merge(const BoxCell& parent) const {
  for (const BoxCell& partner : partners(parent))
    if (!merging_.contains(partner.key()))
      return false;
  const auto& at = parent.place;
  bool may = true;
  for_cells(parent.level + 1, {2 * at[0] - 1, 2 * at[1] - 1, 2 * at[2] - 1},
            {2 * at[0] + 2, 2 * at[1] + 2, 2 * at[2] + 2},
            extent(parent.level + 1), [&](const BoxCell& cell) {
              const auto leaf = leaves_.find(cell.key());
              if (leaf != leaves_.end() ? leaf->second
                                        : inner_.contains(cell.key()) &&
                                              !merging_.contains(cell.key()))
                may = false;
            });
  return may;
}

CellChange MeshPlan::change_of(const BoxCell& cell) const {
  const auto leaf = leaves_.find(cell.key());
  if (leaf == leaves_.end())
    return inner_.contains(cell.key()) && !merging_.contains(cell.key())
               ? CellChange::refine
               : CellChange::none;
  if (leaf->second)
    return CellChange::refine;
  return cell.level > 0 && merging_.contains(parent_of(cell).key())
             ? CellChange::coarsen
             : CellChange::none;
}

} // namespace asperity::fem
