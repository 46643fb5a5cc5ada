#pragma once

// The symbol of the inverse of a convolution and a local compliance.

#include "base/require.hpp"
#include "ranks/convolution.hpp"

namespace asperity::contact {

/// The symbol of (C + c)^-1, which is found again when c changes.
class InverseSymbol {
public:
  using Symbol = Convolution<float>::Symbol;

  /// @param convolution       always the same one
  /// @param compliance        C [m/Pa] > 0 of the columns of this rank
  /// @param local_compliance  c [m/Pa] >= 0
  const Symbol& of(const Convolution<float>& convolution,
                   const EvenColumn& compliance, double local_compliance) {
    require_not_negative("local_compliance", local_compliance, "m/Pa");
    if (local_compliance_ != local_compliance) {
      symbol_ = convolution.arranged([&](int jx, std::span<double> of_jy) {
        compliance(jx, of_jy);
        for (double& value : of_jy)
          value = 1.0 / (value + local_compliance);
      });
      local_compliance_ = local_compliance;
    }
    return symbol_;
  }

private:
  double local_compliance_ = -1.0; ///< that of symbol_ [m/Pa]
  Symbol symbol_;
};

} // namespace asperity::contact
