#pragma once

// The stiffness of a layer of cells as lateral waves see it: deal.II's cell
// matrix summed with the phases of four wavevectors at once.

#include "fem/waves/cell_stiffness.hpp"
#include "fem/waves/pack.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace asperity::fem {

/// Kinds of nodes of a face, by parity (a, b) of their place: index a + 2 b.
constexpr std::size_t kinds_of(std::size_t degree) {
  return degree * degree;
}

/// Unknowns of a plane at one wavevector: (kind, component), 3 kind + c.
constexpr std::size_t plane_unknowns(std::size_t degree) {
  return 3 * kinds_of(degree);
}

/// Unknowns of a layer above its lower plane: `degree` planes.
constexpr std::size_t layer_unknowns(std::size_t degree) {
  return degree * plane_unknowns(degree);
}

/// Products f(theta_x) g(theta_y) of 1, cos, cos 2, sin and sin 2, f slower;
/// theta is q times the node spacing.
struct WaveProducts {
  std::array<Pack, 25> values;

  /// One wavevector a lane.
  WaveProducts(const Pack& theta_x, const Pack& theta_y);
};

/// Entries of S(q), real by u_x and u_y multiplied by i, in a layout of their
/// own. The cell's mirror images leave few products to each entry.
class LayerSymbol {
public:
  /// Where an entry goes, and by which sign; nowhere if `place` is none.
  struct Target {
    std::size_t place = none;
    double sign = 1.0;
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
  };

  /// Target of entry (row, column), each plane_unknowns * plane + 3 kind + c,
  /// plane 0..degree from below.
  using Layout = Target (*)(std::size_t row, std::size_t column);

  /// @param size  of the layout, in packs
  LayerSymbol(const CellStiffness& cell, std::size_t size, Layout layout);

  /// @param blocks  size() packs, overwritten [N/m]
  void evaluate(const WaveProducts& products, Pack* blocks) const;

private:
  struct Term {
    double amount;
    std::uint16_t target;
    std::uint16_t product;
  };

  std::size_t size_;
  std::vector<Term> terms_; ///< by target
};

} // namespace asperity::fem
