#pragma once

// Verifies that each state of faces that attract each other is a minimum of the
// energy.

#include "contact/operators/surface_operator.hpp"
#include "mechanics/contact_law.hpp"
#include "suite/robustness/verify.hpp"

#include <optional>
#include <vector>

namespace asperity::robustness {

struct AdhesiveScales {
  double stiffness = 0.0;       ///< k_c of periodic boundaries [Pa/m]
  double gap_tolerance = 0.0;   ///< [m]
  double contact_modulus = 0.0; ///< E* [Pa]
};

/// Verifies one state after another of a loading path.
class AdhesiveCheck {
public:
  /// @param elasticity  in a scratch of its own; must outlive this object, as
  ///                    must the heights
  AdhesiveCheck(contact::SurfaceOperator& elasticity,
                std::span<const double> heights,
                const mechanics::ContactInterface& law,
                const AdhesiveScales& scales)
      : elasticity_(elasticity),
        heights_(heights),
        law_(law),
        scales_(scales) {}

  std::optional<Failure> verify(const mechanics::LoadTarget& target,
                                const contact::ContactSolution& found);

private:
  double energy(const contact::ContactSolution& state, double nominal) const;
  double energy_left(const contact::ContactSolution& state,
                     double nominal) const;
  double solved_nodes() const;
  double pressure_left() const;
  double stiffest() const;
  std::optional<Failure>
  verify_law(const mechanics::LoadTarget& target,
             const contact::ContactSolution& found) const;
  std::optional<Failure>
  verify_balance(const mechanics::LoadTarget& target,
                 const contact::ContactSolution& found) const;
  std::optional<Failure> verify_fields(const contact::ContactSolution& found);
  std::optional<Failure>
  verify_minimum(const mechanics::LoadTarget& target,
                 const contact::ContactSolution& found) const;
  std::optional<Failure> verify_state(const mechanics::LoadTarget& target,
                                      const contact::ContactSolution& found);

  contact::SurfaceOperator& elasticity_;
  std::span<const double> heights_;
  mechanics::ContactInterface law_;
  AdhesiveScales scales_;
  std::optional<contact::ContactSolution> begun_; ///< the state before
};

} // namespace asperity::robustness
