#include "contact/operators/halfspace.hpp"

#include "base/require.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/operators/layered_compliance.hpp"

#include <cmath>

namespace asperity::contact {
std::function<double(double)>
compliance_function(const mechanics::ElasticBlock& block) {
  require_positive("contact_modulus", block.contact_modulus, "Pa");
  if (!(block.thickness > 0.0))
    refuse_argument("thickness", block.thickness, "> 0 [m], or infinite");
  if (block.is_halfspace())
    return [modulus = block.contact_modulus](double q) {
      return 2.0 / (modulus * q);
    };
  return [stack = LayerStack(block)](double q) { return stack.compliance(q); };
}

EvenColumn compliance_column(const Grid& grid,
                             const mechanics::ElasticBlock& block) {
  return [grid, compliance = compliance_function(block)](
             int jx, std::span<double> of_jy) {
    for (std::size_t jy = jx == 0 ? 1 : 0; jy < of_jy.size(); ++jy)
      of_jy[jy] = compliance(wavevector_size(grid, jx, static_cast<int>(jy)));
  };
}

FourierOperator halfspace_operator(const Grid& grid,
                                   const mechanics::ElasticBlock& block,
                                   int threads) {
  if (!block.is_free())
    return FourierOperator(grid, compliance_column(grid, block), threads);
  if (!block.is_halfspace())
    refuse_argument("thickness", block.thickness,
                    "infinite, without layers, with free boundaries");
  return free_halfspace(grid, block.contact_modulus, threads);
}

} // namespace asperity::contact
