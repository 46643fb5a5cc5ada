#include "contact/operators/gathered_operator.hpp"

#include <utility>

namespace asperity::contact {
namespace {

/// The rows of this process in a field of all nodes.
template <class Value>
std::span<Value> own_part(const SharedRows& rows, std::span<Value> all) {
  return all.subspan(static_cast<std::size_t>(rows.first()) * rows.width(),
                     rows.size());
}

/// Applies apply(own rows of the field, own answer) and gathers the answers.
template <class Real, class Apply>
void apply_to_rows(const SharedRows& rows, std::span<const Real> field,
                   std::span<Real> answer, const Apply& apply) {
  std::vector<Real> own(rows.size());
  apply(own_part(rows, field), std::span<Real>(own));
  std::vector<std::size_t> bytes;
  for (std::size_t r = 0; r + 1 < rows.bounds().size(); ++r)
    bytes.push_back(
        static_cast<std::size_t>(rows.bounds()[r + 1] - rows.bounds()[r]) *
        rows.width() * sizeof(Real));
  rows.ranks()->gather_to_all(std::as_bytes(std::span(own)), bytes,
                              std::as_writable_bytes(answer));
}

} // namespace

GatheredOperator::GatheredOperator(std::unique_ptr<SurfaceOperator> shared)
    : shared_(std::move(shared)) {
  if (const auto own = shared_->nodal_weights(); !own.empty())
    weights_ = shared_->shared_rows()->gathered(own);
}

std::unique_ptr<SurfaceOperator> GatheredOperator::clone() const {
  return std::make_unique<GatheredOperator>(shared_->clone());
}

void GatheredOperator::displacement(std::span<const double> pressure,
                                    std::span<double> displacement) {
  apply_to_rows<double>(*shared_->shared_rows(), pressure, displacement,
                        [&](std::span<const double> p, std::span<double> u) {
                          shared_->displacement(p, u);
                        });
}

void GatheredOperator::displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change) {
  apply_to_rows<float>(*shared_->shared_rows(), pressure_change,
                       displacement_change,
                       [&](std::span<const float> p, std::span<float> u) {
                         shared_->displacement_change(p, u);
                       });
}

void GatheredOperator::pressure_estimate(std::span<const float> gap,
                                         double local_compliance,
                                         std::span<float> pressure) {
  apply_to_rows<float>(*shared_->shared_rows(), gap, pressure,
                       [&](std::span<const float> g, std::span<float> p) {
                         shared_->pressure_estimate(g, local_compliance, p);
                       });
}

} // namespace asperity::contact
