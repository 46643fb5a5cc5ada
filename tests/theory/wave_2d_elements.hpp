#pragma once

// The egg-box contact by boundary elements in real space and a direct solution
// of every active set. It shares neither operator nor iteration with contact/.

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace asperity::theory {

/// The square cell of one crest, h = [cos(2 pi x) + cos(2 pi y)]/2, with E* = 1
/// / pi, so that p* = 1, D = 1 and u = int p/|x - x'| (Boussinesq). Elements of
/// constant pressure, collocated at their centres; those that the symmetries
/// of the cell map onto each other share one unknown.
class Wave2dElements {
public:
  /// @param points        elements per side, even, >= 4
  /// @param crest_offset  of the crest from an element's centre, 0 or 1/2
  Wave2dElements(int points, double crest_offset)
      : points_(points), offset_(crest_offset) {
    number_elements();
    const std::vector<double> influence = influences();
    matrix_ = Eigen::MatrixXd::Zero(size(), size());
    for (Eigen::Index row = 0; row < size(); ++row)
      for (int iy = 0; iy < points_; ++iy)
        for (int ix = 0; ix < points_; ++ix) {
          const auto [x, y] = first_[static_cast<std::size_t>(row)];
          matrix_(row, unknown_of(ix, iy)) +=
              influence[index(folded(ix - x), folded(iy - y))];
        }
  }

  struct Answer {
    double area_fraction = 0.0; ///< counted elements
    double mean_gap = 0.0;
    bool is_solved = false; ///< no tension in contact, no overlap outside
  };

  /// Solves under p/p*, starting from contact everywhere.
  Answer press(double reduced_pressure) const {
    std::vector<Eigen::Index> contact;
    for (Eigen::Index i = 0; i < size(); ++i)
      contact.push_back(i);
    for (int iteration = 0; iteration < 100; ++iteration) {
      const Eigen::VectorXd solved = solve_with(contact, reduced_pressure);
      Eigen::VectorXd pressure = Eigen::VectorXd::Zero(size());
      const auto n = static_cast<Eigen::Index>(contact.size());
      for (Eigen::Index i = 0; i < n; ++i)
        pressure[contact[static_cast<std::size_t>(i)]] = solved[i];
      const double mean_gap = solved[n];
      const Eigen::VectorXd gap =
          (matrix_ * pressure - heights_).array() + mean_gap;
      std::vector<Eigen::Index> next;
      for (Eigen::Index i = 0; i < size(); ++i)
        if (pressure[i] > 0.0 || (pressure[i] == 0.0 && gap[i] < 0.0))
          next.push_back(i);
      if (next == contact)
        return {share_of(contact), mean_gap, true};
      contact = std::move(next);
    }
    return {};
  }

private:
  Eigen::Index size() const { return heights_.size(); }

  std::size_t index(int ix, int iy) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(points_) +
           static_cast<std::size_t>(ix);
  }

  int folded(int i) const { return (i % points_ + points_) % points_; }

  Eigen::Index unknown_of(int ix, int iy) const {
    return unknown_[index(ix, iy)];
  }

  /// Mirror symmetry at the crest and about the diagonal.
  void number_elements() {
    const int twice = static_cast<int>(2.0 * offset_); // 0 or 1
    std::map<std::pair<int, int>, Eigen::Index> numbers;
    unknown_.resize(index(0, points_));
    for (int iy = 0; iy < points_; ++iy)
      for (int ix = 0; ix < points_; ++ix) {
        const int x = std::min(ix, folded(-twice - ix));
        const int y = std::min(iy, folded(-twice - iy));
        const auto [found, is_new] = numbers.try_emplace(
            std::minmax(x, y), static_cast<Eigen::Index>(first_.size()));
        unknown_[index(ix, iy)] = found->second;
        if (is_new) {
          first_.emplace_back(ix, iy);
          weights_.push_back(0.0);
        }
        weights_[static_cast<std::size_t>(found->second)] +=
            1.0 / (points_ * points_);
      }
    heights_.resize(static_cast<Eigen::Index>(first_.size()));
    const double turn = 2.0 * std::numbers::pi / points_;
    for (Eigen::Index i = 0; i < heights_.size(); ++i) {
      const auto [x, y] = first_[static_cast<std::size_t>(i)];
      heights_[i] = 0.5 * (std::cos(turn * (x + offset_)) +
                           std::cos(turn * (y + offset_)));
    }
  }

  /// int 1/r over the rectangle between two corners relative to the origin
  /// (A. E. H. Love, Phil. Trans. R. Soc. A 228, 377 (1929)).
  static double rectangle(double x0, double x1, double y0, double y1) {
    const auto corner = [](double x, double y) {
      const double r = std::hypot(x, y);
      return (x != 0.0 ? x * std::asinh(y / std::abs(x)) : 0.0) +
             (y != 0.0 && r > 0.0 ? y * std::asinh(x / std::abs(y)) : 0.0);
    };
    return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
  }

  /// Displacement at each offset by a loaded element and its images, under a
  /// uniform tension of the same force; of mean zero.
  std::vector<double> influences() const {
    constexpr int images = 12; // the remainder decreases with their cube
    const double half = 0.5 / points_;
    const double edge = images + 0.5;
    std::vector<double> values(index(0, points_));
    double sum = 0.0;
    for (int iy = 0; iy < points_; ++iy)
      for (int ix = 0; ix < points_; ++ix) {
        const double x = static_cast<double>(ix) / points_ - (2 * ix > points_);
        const double y = static_cast<double>(iy) / points_ - (2 * iy > points_);
        double value = -rectangle(-edge - x, edge - x, -edge - y, edge - y) /
                       (points_ * points_);
        for (int jy = -images; jy <= images; ++jy)
          for (int jx = -images; jx <= images; ++jx)
            value += rectangle(jx - x - half, jx - x + half, jy - y - half,
                               jy - y + half);
        values[index(ix, iy)] = value;
        sum += value;
      }
    for (double& value : values)
      value -= sum / (points_ * points_);
    return values;
  }

  /// Pressures of the elements in contact and, last, the mean gap: no gap in
  /// contact, and the load.
  Eigen::VectorXd solve_with(const std::vector<Eigen::Index>& contact,
                             double reduced_pressure) const {
    const auto n = static_cast<Eigen::Index>(contact.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::VectorXd right(n + 1);
    system.topLeftCorner(n, n) = matrix_(contact, contact);
    system.col(n).head(n).setOnes();
    right.head(n) = heights_(contact);
    for (Eigen::Index i = 0; i < n; ++i)
      system(n, i) = weights_[static_cast<std::size_t>(
          contact[static_cast<std::size_t>(i)])];
    right[n] = reduced_pressure;
    return system.partialPivLu().solve(right);
  }

  double share_of(const std::vector<Eigen::Index>& contact) const {
    double share = 0.0;
    for (const Eigen::Index i : contact)
      share += weights_[static_cast<std::size_t>(i)];
    return share;
  }

  int points_;
  double offset_;
  std::vector<Eigen::Index> unknown_;      ///< of every element
  std::vector<std::pair<int, int>> first_; ///< element of every unknown
  std::vector<double> weights_;            ///< fraction of the cell
  Eigen::VectorXd heights_;
  Eigen::MatrixXd matrix_; ///< displacement by unit pressures
};

} // namespace asperity::theory
