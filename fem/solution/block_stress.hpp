#pragma once

// Stress inside a solved block: at quadrature points, at vertices, and its
// maximum. This file is independent of output files and of the contact law.
// Include this header in .cpp files of fem/ only.

#include "fem/block/material_points.hpp"

#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace asperity::fem {

/// The stress sigma [Pa], positive in tension, with z pointing into the first
/// body.
using StressTensor = dealii::SymmetricTensor<2, 3>;

/// The von Mises stress sqrt(3 J_2) = sqrt(3/2 s : s), where s is the deviator
/// of sigma [Pa] >= 0.
double von_mises(const StressTensor& stress);

/// The largest shear stress: half the difference of the largest and the
/// smallest principal stress [Pa] >= 0.
double largest_shear(const StressTensor& stress);

/// The averages of one stress at the vertices of the mesh, which do not extend
/// over different materials.
class VertexAverages {
public:
  /// @param ratio  of the moduli up to which materials are similar [1] >= 1;
  ///               above 1, averages extend over all cells around the vertex
  ///               with the same nu whose E is within this ratio of that of the
  ///               cell. Their stress is scaled by the ratio of E: the strain
  ///               is averaged, which is continuous where E varies smoothly,
  ///               although each cell has a modulus of its own.
  VertexAverages(std::size_t n_vertices, double ratio);

  /// Adds a cell's value at a vertex.
  /// @param volume  of the cell, its weight [m^3]
  void add(unsigned int vertex, const Moduli& material, double volume,
           const StressTensor& stress);

  /// The average at a vertex for a cell of a material that was added there.
  StressTensor at(unsigned int vertex, const Moduli& material) const;

private:
  /// Sum over the cells of one material around a vertex.
  struct Share {
    Moduli material;
    double volume = 0.0; ///< [m^3]
    /// Integral of sigma over the cells, from its value at the vertex [Pa m^3].
    StressTensor volume_stress;
  };

  double ratio_;
  std::vector<Share> first_; ///< of the first material around each vertex
  /// Of further materials, by vertex.
  std::unordered_map<unsigned int, std::vector<Share>> others_;
};

/// The stress of one displacement field. Every call except at_points is
/// collective.
///
/// In each cell, sigma is computed from the strain at the quadrature points
/// with which the stiffness was integrated. These values are projected onto
/// functions that are linear in the reference coordinates of the cell, by least
/// squares with the quadrature weights. The projections at a vertex are
/// averaged over the cells of one material around it, weighted by cell volume,
/// so the stress remains discontinuous where the moduli differ. Averages do not
/// extend across periodic sides.
class BlockStress {
public:
  using Cell = dealii::DoFHandler<3>::active_cell_iterator;

  /// A callback that receives the stress at the vertices of a cell, in
  /// deal.II's order.
  using TakeVertices =
      std::function<void(const Cell&, std::span<const StressTensor>)>;

  /// @param system        must outlive this object
  /// @param displacement  u over the owned unknowns [m]; its entries at
  ///                      constrained unknowns are not read
  /// @param material      its state; null in a linear block, must outlive this
  ///                      object
  BlockStress(const BlockSystem& system,
              const dealii::TrilinosWrappers::MPI::Vector& displacement,
              const MaterialPoints* material = nullptr);

  /// The displacement u at all unknowns of this rank's cells, including
  /// constrained ones [m].
  const dealii::TrilinosWrappers::MPI::Vector& displacement() const {
    return strains_.displacement();
  }

  /// The stress sigma at the quadrature points of a cell that this rank owns or
  /// borders on. The reference is valid until the next call.
  const std::vector<StressTensor>& at_points(const Cell& cell);

  /// The linear projection of sigma at the vertices of a cell, in deal.II's
  /// order, likewise.
  const std::vector<StressTensor>& projected(const Cell& cell,
                                             const Moduli& material);

  /// The averages of these projections over the cells around each vertex.
  /// @param ratio  see VertexAverages
  VertexAverages averages(double ratio);

  /// The integrals of the products of two linear functions at vertices over a
  /// cell, over its volume [1].
  const dealii::FullMatrix<double>& vertex_mass() const { return mass_; }

  static double volume(const Cell& cell); ///< [m^3]

  /// Calls `take` for each cell of this rank in deal.II's order.
  /// @param ratio  see VertexAverages
  void at_vertices(const TakeVertices& take, double ratio = 1.0);

  /// The largest von Mises stress at a quadrature point over all ranks. Ties
  /// are resolved by the smallest x, then y, then z. See StressPeak.
  StressPeak strongest();

private:
  const BlockSystem& system_;
  const MaterialPoints* material_;
  CellStrains strains_;
  std::vector<StressTensor> stress_;
  std::vector<StressTensor> projected_;
  dealii::FullMatrix<double> to_vertices_; ///< n_vertices x n_quadrature_points
  dealii::FullMatrix<double> mass_;        ///< n_vertices x n_vertices
  std::optional<BoxStrain> at_vertices_;   ///< of hexahedra with Hooke's law
};

} // namespace asperity::fem
