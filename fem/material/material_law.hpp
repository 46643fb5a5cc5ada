#pragma once

// The interface of a material law of the full block that is not linear: what a
// quadrature point answers to a strain. A law is one class in one file
// (j2_plasticity.cpp); the rest of the block asks it through this interface.
// Include this header in .cpp files of fem/ only.

#include "fem/hexahedra/cell_tangents.hpp"
#include "fem/waves/moduli_field.hpp"

#include <deal.II/base/symmetric_tensor.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// The answer of a point to a strain: the inelastic strain, which has no
/// stress,
///
///     sigma = C : (epsilon - inelastic strain).                        (F.9)
struct PointResponse {
  dealii::SymmetricTensor<2, 3> inelastic_strain;
  PointTangent tangent; ///< d sigma / d epsilon, semidefinite
  /// The inelastic strain and the history are those of before, and the tangent
  /// is C.
  bool is_elastic = true;
};

/// A quantity that a law adds to the result of a step.
struct MaterialQuantity {
  std::string name; ///< of a column of the results
  /// Whether it is a density per volume, of which the result has the integral
  /// over the block per nominal area; else the result has the largest value.
  bool is_density = false;
  std::function<double(std::span<const double> history)> of_point;
};

/// A law for small strains whose elastic part is Hooke's law with the moduli C
/// of the cell. The state of a point is its inelastic strain and the numbers
/// that the law keeps besides, its history; all are zero before the first load.
/// The energy of a load step must be convex in the strain: the solver minimises
/// it.
class MaterialLaw {
public:
  virtual ~MaterialLaw() = default;

  virtual std::size_t n_history() const = 0;

  /// The answer to a strain at the end of a load step.
  /// @param inelastic_before  at the end of the load step before
  /// @param moduli            of the cell
  /// @param history  at the end of the load step before; set to that at the end
  ///                 of this one if the answer is not elastic
  virtual PointResponse
  respond(const dealii::SymmetricTensor<2, 3>& strain,
          const dealii::SymmetricTensor<2, 3>& inelastic_before,
          const Moduli& moduli, std::span<double> history) const = 0;

  virtual std::vector<MaterialQuantity> quantities() const { return {}; }
};

} // namespace asperity::fem
