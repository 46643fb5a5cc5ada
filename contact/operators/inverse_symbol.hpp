#pragma once

// This file contains the symbol of the inverse of a convolution and a local
// compliance, for a convolution of one process or of several ranks.

#include "base/require.hpp"
#include "contact/operators/even_symbol.hpp"

namespace asperity::contact {

/// The symbol of (C + c)^-1, which is found again when c changes.
/// @tparam Convolution  Convolution or SharedConvolution, always the same one
template <class Convolution>
class InverseSymbol {
public:
  using Symbol = typename Convolution::Symbol;

  /// @param compliance        C [m/Pa] > 0 of the columns of this rank
  /// @param local_compliance  c [m/Pa] >= 0
  const Symbol& of(const Convolution& convolution, const EvenSymbol& compliance,
                   double local_compliance) {
    require_not_negative("local_compliance", local_compliance, "m/Pa");
    if (local_compliance_ != local_compliance) {
      symbol_ = convolution.arranged([&](int jx, int jy) {
        return 1.0 / (compliance(jx, jy) + local_compliance);
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
