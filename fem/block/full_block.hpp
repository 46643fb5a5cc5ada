#pragma once

// The whole three-dimensional block in contact, solved naively: the judge of
// the condensed block, and `solver = "full"`. Nothing of deal.II shows here.

#include "fem/waves/elastic_layers.hpp"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// LinearSolver::automatic is direct up to this size.
inline constexpr unsigned int most_direct_unknowns = 12000;

/// How the block's linear systems are solved.
enum class LinearSolver {
  automatic, ///< direct for small blocks; beyond, fourier where the mesh is a
             ///< periodic lattice, else multigrid
  direct,    ///< MUMPS; KLU on several ranks
  multigrid, ///< CG, Trilinos ML smoothed aggregation
  fourier,   ///< CG, the laterally uniform block by its waves
};

/// What is prescribed at one step.
struct BlockLoad {
  cases::Control control = cases::Control::nominal_pressure;
  double target = 0.0; ///< p_0 [Pa] > 0, or mean gap [m]
};

/// The interface law, in SI.
struct BlockContact {
  cases::ContactLaw law = cases::ContactLaw::penalty;
  double penalty = 0.0;    ///< k [Pa/m] > 0; the spring of the augmentation
                           ///< where the law is hard or augmented
  double tolerance = 1e-8; ///< of gap, relative to h_rms (to the spacing for a
                           ///< flat surface), and of force
  int max_iterations = 2000; ///< Newton steps
};

/// Fields in the grid's order. gap = distance + w - heights, where w is the
/// displacement without its mean; means are weighted by nodal area.
struct BlockSolution {
  std::vector<double> pressure;  ///< [Pa] >= 0
  std::vector<double> gap;       ///< [m], negative where springs are pressed in
  double mean_gap = 0.0;         ///< [m]
  double nominal_pressure = 0.0; ///< [Pa]
  double residual = 0.0; ///< larger of the gap's violation over h_rms and of
                         ///< the unbalanced nodal force over the largest [1]
  double area_by_points = 0.0; ///< area of the points under pressure over that
                               ///< of the contact face [1]
  bool is_contact_on_grid = true; ///< the points under pressure are exactly the
                                  ///< grid's nodes under pressure
  int iterations = 0;             ///< Newton steps
  int linear_iterations = 0;      ///< of CG, in all of this step's solves
  int preconditioner_setups = 0;  ///< or factorisations, in this step
  double memory = 0.0;            ///< matrix and preconditioner, of all ranks
                                  ///< [bytes]
  std::string linear_solver;      ///< "direct (MUMPS)", ...
  bool converged = false;
  std::string note; ///< why it did not converge, or that the wall's own method
                    ///< did not and what found the answer; else empty
};

/// Where a block is strained most: the largest von Mises stress sqrt(3 J_2) at
/// a quadrature point, no cell left out. The place is
/// known to about a cell: the stress is read between the cell's edges only.
struct StressPeak {
  double von_mises = 0.0;        ///< [Pa]
  double largest_shear = 0.0;    ///< at that point [Pa]
  double depth = 0.0;            ///< |z|, below the contact face [m]
  std::array<double, 3> place{}; ///< [m]; z < 0 in a second body
};

/// Where a section is looked at: each x with each depth, x fastest.
struct SectionPlane {
  double y = 0.0;            ///< of the plane [m]
  bool is_counter = false;   ///< of the second body
  std::vector<double> x;     ///< [m], in any order
  std::vector<double> depth; ///< |z| [m] >= 0, in any order
};

/// Contact of the block on rigid heights, at points c of the contact face:
///
///     K u = B^T a p - P g,    gap_c = d + (B u)_c - h_c,               (F.1)
///     p_c = (lambda_c - k gap_c)+,    P A = sum_c a_c p_c,
///
/// with K deal.II's stiffness, B u the displacement u_z at the points, a their
/// areas, d the rigid approach, P g the balancing load on a pressed top, and P
/// or the mean gap prescribed. Points are nodes (B picks u_z, a is the row sum
/// of the face's mass matrix) or Gauss points. With two bodies B u is the
/// difference of their displacements.
///
/// penalty, augmented: semi-smooth Newton. One step solves (F.1) exactly for a
/// contact set; it ends when the set stands still. lambda = 0 for a penalty;
/// otherwise lambda <- p until no gap in contact exceeds the tolerance.
///
/// hard: the primal-dual active set, node-wise. Active nodes are held at
/// u_z = h - d and p is what holds them; a node joins where it overlaps and
/// leaves where it would be pulled. Second-order elements let this method cycle
/// (a force on one node may lift another): where 30 steps find no set that
/// stands, the augmented law goes on, which has the same answer. Gauss points
/// cannot be held one by one and are refused: they have the augmented law.
///
/// A spring acts on the primal unknowns: beyond some 1e7 E/h the rounding of
/// the gap would exceed 1e-8 of the pressure. So k is bounded by 1e5 mu/h, and
/// a stiffer penalty k_0 is reached like a wall, by lambda <- (1 - k/k_0) p
/// until gap + p/k_0 is within the tolerance. Nor is an augmented k softer than
/// 1e3 mu/h, with which it would take many rounds.
///
/// Maps of the answer are node-wise where the contact face's nodes are the
/// grid's. Otherwise they are samples at the grid's nodes: the gap with the
/// displacement of the face there; the pressure interpolated as u_z is from
/// nodes and cut at 0, or that of the nearest Gauss point of the face (the mean
/// of faces that share the node). Scalars are sums over the points always.
///
/// Under mpirun every call is collective, with equal arguments on every rank,
/// and every rank gets the whole answer.
class FullBlock {
public:
  virtual ~FullBlock() = default;

  virtual const Grid& grid() const = 0;

  virtual std::size_t unknowns() const = 0;

  /// Row sums of the contact face's mass matrix over their mean, mean 1; all
  /// ones where the maps are samples.
  virtual std::span<const double> nodal_weights() const = 0;

  /// The displacement under a given pressure, without its mean.
  /// @param pressure  grid().size() values [Pa]
  /// @return          grid().size() values [m]; empty if CG gave up
  /// @throws std::domain_error  another number of values, or one not finite
  virtual std::vector<double>
  displacement(std::span<const double> pressure) = 0;

  /// Lines on mesh, unknowns, contact points and ranks.
  virtual std::string report() const = 0;

  /// @param heights  grid().size() values [m]: exact at points that are nodes
  ///                 of the grid, by periodic bicubic convolution between
  /// A call starts from the displacement the last one ended with.
  /// @throws std::domain_error  an argument is outside its range or not finite
  virtual BlockSolution solve(std::span<const double> heights,
                              const BlockLoad& load,
                              const BlockContact& contact) = 0;

  /// Of the last solution; zeros before the first.
  virtual StressPeak strongest_stress() const = 0;

  /// Von Mises stress of the last solution in a plane, from the averages at
  /// vertices (block_stress.hpp), linear in each cell's own coordinates.
  /// @return  [Pa], plane.x.size() times plane.depth.size() values; where cells
  ///          meet, of the one whose centre is nearest to the face; NaN outside
  ///          of the mesh
  virtual std::vector<double> section(const SectionPlane& plane) const = 0;

  /// Writes the last solution as one more step for ParaView: <stem>_<step>.pvtu
  /// with its parts .vtu, and <stem>.pvd over the steps, each file whole or not
  /// at all. block_output.hpp has the fields.
  /// @param folder_and_stem  "out/block"; the folder is made if need be
  /// @throws std::runtime_error  a file could not be written
  virtual void write(const std::string& folder_and_stem) = 0;
};

/// @param degree 1 or 2; the grid's nodes are all nodes of the contact face
/// @throws std::domain_error  the grid or the block is outside its range
std::unique_ptr<FullBlock>
make_full_block(const Grid& grid, int degree, const LayeredBlock& block,
                LinearSolver linear_solver = LinearSolver::automatic);

} // namespace asperity::fem
