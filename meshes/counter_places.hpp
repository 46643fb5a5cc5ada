#pragma once

// The places of the nodes of a counter-body: a fine box at the centre of its
// end, shells that fan out from it, and the rings of a cylinder.

#include "meshes/counter_body.hpp"

#include <cstddef>
#include <tuple>
#include <vector>

namespace asperity::meshes {

/// Nodes of the body: those of the fine box (shell 0), and shells around it,
/// which consist of the nodes on its sides and its bottom.
struct BodyNode {
  int shell = 0;
  int i = 0, j = 0; ///< along x and y, 0..across
  int k = 0;        ///< downwards, 0..down

  bool operator<(const BodyNode& other) const {
    return std::tie(shell, i, j, k) <
           std::tie(other.shell, other.i, other.j, other.k);
  }
};

/// The largest half width of a fine box around which the cells of the fans are
/// well shaped [m]. Its corners reach sqrt(2) times as far, and on a ball its
/// bottom is lower by as much as its end.
double widest_fine_box(const CounterBody& body);

/// The dimensions of the lattice of nodes and their places relative to the
/// highest point.
class BodyPlaces {
public:
  explicit BodyPlaces(const CounterBody& body);

  Place operator()(const BodyNode& node) const;

  int across() const { return across_; }

  int down() const { return static_cast<int>(layers_.size()) - 1; }

  /// Shells on the sides and at the bottom of the box, then those on the sides
  /// only.
  int n_fans() const { return static_cast<int>(fans_.size()) - 1; }

  int n_rings() const { return static_cast<int>(rings_.size()) - 1; }

private:
  void divide_column();
  void divide_fan(double outer);
  void divide_rings(double size);
  double rise(double r) const;
  Place in_box(double u, double v, double depth) const;
  Place on_outside(double u, double v, double w) const;
  Place on_arc(const Place& first, const Place& chord, double share) const;
  Place on_ring(double u, double v, const Place& inside, double share) const;

  CounterBody body_;
  double box_ = 0.0;       ///< half the width of the fine box [m]
  double inner_ = 0.0;     ///< the same of the column inside of the rings [m]
  double roundness_ = 0.0; ///< of the box, 0 for a square
  int across_ = 1;
  std::vector<double> layers_;     ///< depths of the box's layers [m]
  std::vector<double> fans_{0.0};  ///< shares of the way out, 0..1
  std::vector<double> rings_{0.0}; ///< the same of the rings
};

} // namespace asperity::meshes
