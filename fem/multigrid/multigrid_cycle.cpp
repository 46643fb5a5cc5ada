#include "fem/multigrid/multigrid_cycle.hpp"

#include "fem/multigrid/box_grid_levels.hpp"
#include "fem/multigrid/box_grid_operator.hpp"
#include "fem/multigrid/box_grid_transfer.hpp"
#include "fem/multigrid/box_stiffness.hpp"
#include "fem/multigrid/rigid_modes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <utility>

namespace asperity::fem {

struct CoarsestBoxGrid::Factors {
  Eigen::MatrixXd stiffness; ///< without contact
  Eigen::LDLT<Eigen::MatrixXd> inverse;
  Eigen::VectorXd vector;
};

CoarsestBoxGrid::CoarsestBoxGrid(const BoxGrid& box_grid)
    : force(NodeLayout(box_grid).size()),
      displacement(force.size()),
      box_grid_(box_grid),
      layout_(box_grid),
      constraints_(unknowns_of(box_grid, BoxGridSlab(box_grid)).constraints),
      numbers_(force.size()),
      factors_(std::make_unique<Factors>()) {
  for (int k = 0; k < static_cast<int>(layout_.planes()); ++k)
    for (int j = 0; j < layout_.nodes_y(); ++j)
      for (int i = 0; i < layout_.nodes_x(); ++i)
        for (int c = 0; c < 3; ++c) {
          const std::size_t place = layout_.index(i, j, k, c);
          numbers_[place] = places_.size();
          places_.push_back(place);
        }
  assemble();
}

CoarsestBoxGrid::~CoarsestBoxGrid() = default;

void CoarsestBoxGrid::assemble() {
  const auto size = static_cast<Eigen::Index>(places_.size());
  Eigen::MatrixXd& matrix = factors_->stiffness;
  matrix.setZero(size, size);
  const int degree = box_grid_.degree;
  std::vector<std::size_t> rows;
  for (int layer = 0; layer < box_grid_.layers(); ++layer)
    for (int y = 0; y < box_grid_.cells_y; ++y)
      for (int x = 0; x < box_grid_.cells_x; ++x) {
        const std::vector<double> cell =
            box_stiffness(degree, box_grid_.cell_size(layer),
                          box_grid_.moduli_of(x, y, layer));
        rows.clear();
        for (int c = 0; c < 3; ++c)
          for (int k = 0; k <= degree; ++k)
            for (int j = 0; j <= degree; ++j)
              for (int i = 0; i <= degree; ++i) {
                const int wrap_x =
                    box_grid_.is_periodic ? layout_.nodes_x() : 1 << 30;
                const int wrap_y =
                    box_grid_.is_periodic ? layout_.nodes_y() : 1 << 30;
                rows.push_back(numbers_[layout_.index((degree * x + i) % wrap_x,
                                                      (degree * y + j) % wrap_y,
                                                      degree * layer + k, c)]);
              }
        for (std::size_t r = 0; r < rows.size(); ++r)
          for (std::size_t s = 0; s < rows.size(); ++s)
            matrix(static_cast<Eigen::Index>(rows[r]),
                   static_cast<Eigen::Index>(rows[s])) +=
                cell[r * rows.size() + s];
      }
}

void CoarsestBoxGrid::set_contact(const MeshContact& contact) {
  Eigen::MatrixXd matrix = factors_->stiffness;
  const double scale = matrix.diagonal().mean();
  const auto row_of = [&](std::size_t number) {
    return static_cast<Eigen::Index>(numbers_[contact.unknowns[number]]);
  };
  const SparseRows& springs = contact.springs;
  for (std::size_t row = 0; row < springs.rows(); ++row)
    for (std::size_t i = springs.start[row]; i < springs.start[row + 1]; ++i)
      matrix(row_of(row), row_of(springs.column[i])) += springs.weight[i];
  for (const auto& mode :
       rigid_modes(box_grid_, BoxGridSlab(box_grid_), !contact.is_free())) {
    Eigen::VectorXd values(matrix.rows());
    for (std::size_t i = 0; i < places_.size(); ++i)
      values[static_cast<Eigen::Index>(i)] = mode[places_[i]];
    matrix += scale / values.squaredNorm() * values * values.transpose();
  }
  std::vector<bool> is_held(layout_.size(), false);
  constraints_->visit([&](std::size_t place) { is_held[place] = true; });
  for (const std::size_t place : contact.held_unknowns(layout_.step()))
    is_held[place] = true;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (is_held[places_[i]]) {
      const auto row = static_cast<Eigen::Index>(i);
      matrix.row(row).setZero();
      matrix.col(row).setZero();
      matrix(row, row) = 1e30 * scale; // the displacement is zero
    }
  factors_->inverse.compute(matrix);
}

void CoarsestBoxGrid::solve() {
  factors_->vector.resize(static_cast<Eigen::Index>(places_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i)
    factors_->vector[static_cast<Eigen::Index>(i)] =
        static_cast<double>(force[places_[i]]);
  factors_->vector = factors_->inverse.solve(factors_->vector).eval();
  for (std::size_t i = 0; i < places_.size(); ++i)
    displacement[places_[i]] =
        static_cast<float>(factors_->vector[static_cast<Eigen::Index>(i)]);
}

std::size_t CoarsestBoxGrid::bytes() const {
  return 2 * places_.size() * places_.size() * sizeof(double);
}

void MultigridCycle::add_level(std::unique_ptr<LevelTransfer> transfer,
                               std::unique_ptr<SmoothedLevel> level) {
  transfers_.push_back(std::move(transfer));
  levels_.push_back(std::move(level));
}

void MultigridCycle::add_box_grids(std::unique_ptr<LevelTransfer> transfer,
                                   BoxGrid box_grid, BoxGridSlab slab) {
  while (has_coarser(box_grid)) {
    auto stiffness = std::make_unique<BoxGridOperator<float>>(
        box_grid, slab, unknowns_of(box_grid, slab));
    const std::vector<double> diagonal = stiffness->diagonal();
    const double bound = stiffness->jacobi_bound();
    add_level(std::move(transfer), std::make_unique<SmoothedLevel>(
                                       std::move(stiffness), diagonal, bound));
    BoxGrid next = coarser(box_grid);
    BoxGridSlab rows = next_slab(box_grid, slab, next);
    transfer = std::make_unique<BoxGridTransfer>(box_grid, slab, next, rows);
    box_grid = std::move(next);
    slab = std::move(rows);
  }
  transfers_.push_back(std::move(transfer));
  coarsest_ = std::make_unique<CoarsestBoxGrid>(box_grid);
}

void MultigridCycle::set_contact(const MeshContact& contact) {
  MeshContact own = transfers_.front()->coarse(contact);
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    MeshContact next = transfers_[i + 1]->coarse(own);
    levels_[i]->set_contact(std::move(own));
    own = std::move(next);
  }
  coarsest_->set_contact(own);
}

void MultigridCycle::add_correction(std::size_t level,
                                    const std::vector<float>& residual,
                                    std::vector<float>& displacement) {
  LevelTransfer& transfer = *transfers_[level];
  if (level == levels_.size()) {
    transfer.restrict_force(residual, coarsest_->force);
    coarsest_->solve();
    transfer.add_interpolated(coarsest_->displacement, displacement);
    return;
  }
  transfer.restrict_force(residual, levels_[level]->residual);
  run(level);
  transfer.add_interpolated(levels_[level]->displacement, displacement);
}

void MultigridCycle::run(std::size_t level) {
  SmoothedLevel& own = *levels_[level];
  const UnknownLayout& layout = own.layout();
  layout.constraints->condense(own.residual.data());
  layout.collect(own.residual.data());
  own.clear_held(own.residual);
  own.smooth_before();
  own.add_correction([&](const auto& residual, auto& displacement) {
    add_correction(level + 1, residual, displacement);
  });
  own.smooth_after();
  layout.complete(own.displacement.data());
}

std::size_t MultigridCycle::bytes() const {
  std::size_t bytes = coarsest_->bytes();
  for (const auto& transfer : transfers_)
    bytes += transfer->bytes();
  for (const auto& level : levels_)
    bytes += level->bytes() + level->layout().constraints->bytes();
  return bytes;
}

BoxGridSlab next_slab(const BoxGrid& box_grid, const BoxGridSlab& slab,
                      const BoxGrid& next) {
  return has_coarser(next) ? coarser(box_grid, slab, next) : BoxGridSlab(next);
}

} // namespace asperity::fem
