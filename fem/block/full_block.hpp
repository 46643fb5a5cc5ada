#pragma once

// The full 3-D finite-element block in contact, solved without condensation. It
// serves as reference for the condensed solver and implements
// `solver = "full"`. This header does not depend on deal.II.

#include "fem/waves/elastic_layers.hpp"
#include "mechanics/contact_law.hpp"
#include "mechanics/fem_settings.hpp"
#include "mechanics/loading.hpp"

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

using mechanics::LinearSolver;

/// The state of a load step while it is solved.
struct BlockProgress {
  int mesh_pass = 0; ///< solutions of an adaptive mesh before this one
  std::size_t unknowns = 0;
  int iterations = 0;        ///< Newton steps begun
  int linear_iterations = 0; ///< CG iterations
  /// After the last Newton step, NaN before the first: the unbalanced force
  /// over the largest contact force [1], and the number of points that came
  /// into contact or lost it.
  double residual = std::numeric_limits<double>::quiet_NaN();
  int changed_points = 0;
};

/// Called on rank 0 after each linear solve and each Newton step.
using BlockWatch = std::function<void(const BlockProgress&)>;

/// The contact law, in SI units.
struct BlockContact {
  mechanics::ContactLaw law = mechanics::ContactLaw::penalty;
  double penalty = 0.0; ///< k [Pa/m] > 0; the augmentation parameter if the
                        ///< law is hard or augmented
  /// Tolerance of the gap relative to h_rms (to the node spacing for a flat
  /// surface), and of the unbalanced force relative to the largest contact
  /// force.
  double tolerance = 1e-8;
  int max_iterations = 2000; ///< Newton steps

  double local_compliance() const {
    return mechanics::ContactInterface{law, penalty}.local_compliance();
  }

  BlockWatch watch = {}; ///< may be empty
};

/// The solution of one load step, with fields in the grid's order. The gap is
/// distance + w - heights, where w is the displacement without its mean; means
/// are weighted by nodal area.
struct BlockSolution {
  std::vector<double> pressure;  ///< [Pa] >= 0
  std::vector<double> gap;       ///< [m], negative where penalty contact
                                 ///< penetrates
  double mean_gap = 0.0;         ///< [m]
  double nominal_pressure = 0.0; ///< [Pa]
  /// Larger of the violation of the gap over h_rms and the unbalanced force
  /// over the largest contact force [1].
  double residual = 0.0;
  /// Estimate of the error of mean_gap by the mesh (solution/gap_error.hpp)
  /// [m] >= 0; NaN without contact, or if the step has not converged.
  double estimated_gap_error = std::numeric_limits<double>::quiet_NaN();
  /// Area of the points under pressure over that of the contact surface [1].
  double area_by_points = 0.0;
  /// Sums over the contact points, which the samples on the grid of a second-
  /// order mesh would give wrongly: their nodes have unequal areas.
  double elastic_energy = 0.0; ///< of the block, per nominal area [J/m^2]
  double contact_energy = 0.0; ///< of the penalty springs, likewise
  /// What the material law of the block adds to the result, by the name of its
  /// column; empty for Hooke's law. With another law elastic_energy is NaN.
  std::map<std::string, double> of_material;
  /// Place of the resultant force from the node in column points_x / 2 and row
  /// points_y / 2 of the grid [m]; NaN without contact.
  std::array<double, 2> pressure_centre{
      std::numeric_limits<double>::quiet_NaN(),
      std::numeric_limits<double>::quiet_NaN()};
  /// Whether the points under pressure are exactly the grid's nodes under
  /// pressure.
  bool is_contact_on_grid = true;
  int iterations = 0;            ///< Newton steps
  int linear_iterations = 0;     ///< CG iterations in all solves of this step
  int preconditioner_setups = 0; ///< or factorisations, in this step
  double memory = 0.0;           ///< matrix and preconditioner, on all ranks
                                 ///< [bytes]
  std::string linear_solver;     ///< such as "direct (MUMPS)"
  bool converged = false;
  /// Why the step did not converge, or that the active-set method of hard
  /// contact did not converge and which method found the solution; empty
  /// otherwise.
  std::string note;
};

/// The incremental stiffness of a contact, of all its points together: the
/// force of the rigid surface per unit of its displacement against the clamped
/// far boundary.
struct ContactStiffness {
  /// Without friction: the nodes in contact move along z and may slide [N/m].
  double normal = 0.0;
  /// All nodes in contact stick to the surface, which moves along x or y; the
  /// mean of both directions [N/m].
  double tangential = 0.0;
  int linear_iterations = 0; ///< CG iterations of all solves
  bool converged = false;
};

/// Conduction of heat or current from the nodes in contact through a block of
/// uniform conductivity k, by Laplace's equation on its mesh.
struct BlockConduction {
  /// Flux to the far boundary over k and the difference of temperature [m].
  double conductance = 0.0;
  /// G/k of the contact of two such bodies per nominal area [1/m], without the
  /// uniform resistance of the block: 1/(2 (A/conductance - depth)). Infinite
  /// if all nodes are in contact.
  double relative = 0.0;
  int linear_iterations = 0; ///< CG iterations
  bool converged = false;
};

/// The largest von Mises stress sqrt(3 J_2) over the quadrature points of all
/// cells and its place. The place is known to about one cell size, because the
/// stress is evaluated only inside of cells.
struct StressPeak {
  double von_mises = 0.0;        ///< [Pa]
  double largest_shear = 0.0;    ///< at that point [Pa]
  double depth = 0.0;            ///< |z|, below the contact surface [m]
  std::array<double, 3> place{}; ///< [m]; z < 0 in a second body
};

/// The points of a plane section: each x with each depth, x fastest.
struct SectionPlane {
  double y = 0.0;            ///< of the plane [m]
  bool is_counter = false;   ///< whether it lies in the second body
  std::vector<double> x;     ///< [m], in any order
  std::vector<double> depth; ///< |z| [m] >= 0, in any order
};

/// Contact of the block with a rigid surface of heights h, at the points c of
/// the contact surface:
///
///     K u = B^T a p - P g,    gap_c = d + (B u)_c - h_c,               (F.1)
///     p_c = (lambda_c - k gap_c)+,    P A = sum_c a_c p_c,
///
/// where K is the stiffness matrix assembled with deal.II, B u the displacement
/// u_z at the points, a their areas, d the rigid approach, and P g the
/// balancing load on a pressure-loaded far boundary. P or the mean gap is
/// prescribed. Points are nodes: B selects u_z, and a is the row sum of the
/// mass matrix of the contact surface. With two bodies B u is the difference of
/// their displacements.
///
/// Penalty and augmented Lagrangian contact use a semi-smooth Newton method.
/// One step solves (F.1) exactly for a given contact set; the iteration ends
/// when the contact set no longer changes. The multiplier lambda is 0 for a
/// penalty; otherwise lambda <- p is repeated until no gap in contact exceeds
/// the tolerance.
///
/// Hard contact uses the primal-dual active-set method. Active nodes
/// are constrained to u_z = h - d, and p is the constraint force per area. A
/// node becomes active if it penetrates and inactive if its constraint force is
/// tensile. With second-order elements this method may cycle, because a force
/// on one node may lift another node. If no active set is found in 30 steps,
/// the augmented Lagrangian method, which has the same solution, continues.
///
/// A penalty acts on the primal unknowns: beyond some 1e7 E/h the roundoff of
/// the gap would exceed 1e-8 of the pressure. Therefore k is bounded by
/// 1e5 mu/h, and a stiffer penalty k_0 is reached by augmentation,
/// lambda <- (1 - k/k_0) p, until gap + p/k_0 is within the tolerance. The
/// augmentation parameter k is not less than 1e3 mu/h, because a softer one
/// would need many augmentations.
///
/// Fields of the solution are node-wise if the nodes of the contact surface are
/// those of the grid. Otherwise they are samples at the nodes of the grid: the
/// gap is computed with the displacement of the contact surface there; the
/// pressure is interpolated like u_z from nodal values and truncated at 0.
/// Scalars are always sums over the contact points.
///
/// Under mpirun every call is collective and needs equal arguments on every
/// rank; every rank receives the complete solution.
class FullBlock {
public:
  virtual ~FullBlock() = default;

  virtual const Grid& grid() const = 0;

  virtual std::size_t unknowns() const = 0;

  /// Row sums of the mass matrix of the contact surface over their mean; all
  /// ones if the fields are samples.
  virtual std::span<const double> nodal_weights() const = 0;

  /// The displacement under a given pressure, without its mean.
  /// @param pressure  grid().size() values [Pa]
  /// @return          grid().size() values [m]; empty if CG did not converge
  /// @throws std::domain_error  the number of values is wrong, or one is not
  ///                            finite
  virtual std::vector<double>
  displacement(std::span<const double> pressure) = 0;

  /// Lines of text on mesh, unknowns, contact points and ranks.
  virtual std::string report() const = 0;

  /// Solves one load step, starting from the displacement at the end of the
  /// last call.
  /// @param heights  grid().size() values [m]; used exactly at points that are
  ///                 nodes of the grid and interpolated elsewhere
  /// @throws std::domain_error  an argument is outside its range or not finite
  virtual BlockSolution solve(std::span<const double> heights,
                              const mechanics::LoadTarget& load,
                              const BlockContact& contact) = 0;

  /// What solve() starts from, as numbers: the state of the material, and what
  /// it takes to continue bit for bit; empty for an elastic block, whose
  /// solution does not depend on the steps before.
  virtual std::vector<double> memory() const { return {}; }

  /// Continues from the memory of an equal block.
  /// @param memory  read on rank 0 only
  /// @return        false if it is not that of an equal block on as many ranks;
  ///                nothing has then changed
  virtual bool recall(std::span<const double> memory) { return memory.empty(); }

  /// The stiffness of the contact of the last solution, for unchanged nodes in
  /// contact: one linear solve per direction. Zeros without contact.
  /// @throws std::domain_error  there are two bodies, or the far boundary is
  /// not
  ///                            clamped
  virtual ContactStiffness stiffness() = 0;

  /// What the contact of the last solution conducts. Zeros without contact.
  /// @throws std::domain_error  there are two bodies
  virtual BlockConduction conduction() const = 0;

  /// The largest stress of the last solution; zeros before the first.
  virtual StressPeak strongest_stress() const = 0;

  /// Von Mises stress of the last solution in a plane, from the averages at
  /// vertices (block_stress.hpp), interpolated linearly in the reference
  /// coordinates of each cell.
  /// @return  [Pa], plane.x.size() times plane.depth.size() values; on a common
  ///          boundary of cells the value of the cell whose centre is nearest
  ///          to the contact surface; NaN outside of the mesh
  virtual std::vector<double> section(const SectionPlane& plane) const = 0;

  /// Writes the last solution as a further step for ParaView:
  /// <stem>_<step>.pvtu with its parts .vtu, <stem>.pvd over the steps, and the
  /// same for the contact surface as <stem>_surface. Each file is written
  /// completely or not at all. block_output.hpp lists the fields.
  /// @param folder_and_stem  for example "out/block"; the folder is created if
  ///                         necessary
  /// @throws std::runtime_error  a file could not be written
  virtual void write(const std::string& folder_and_stem) = 0;
};

/// Builds a full 3-D block on a regular node grid.
/// @param degree  1 or 2; the grid's nodes are all nodes of the contact surface
/// @throws std::domain_error  the grid or the block is outside its range
std::unique_ptr<FullBlock>
make_full_block(const Grid& grid, int degree, const LayeredBlock& block,
                LinearSolver linear_solver = LinearSolver::automatic);

} // namespace asperity::fem
