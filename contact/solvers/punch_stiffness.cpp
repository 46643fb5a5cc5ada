#include "contact/solvers/punch_stiffness.hpp"

#include "base/require.hpp"
#include "contact/solvers/node_kernels.hpp"
#include "contact/solvers/preconditioner.hpp"
#include "ranks/node_sums.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace asperity::contact {
namespace {

constexpr int most_punch_iterations = 1000;

/// Share of the energy that may be left to gain, by the preconditioner.
constexpr double energy_tolerance = 1e-10;

/// The energy e = <q (C + c) q> of a pressure q of mean 1, which is minimised
/// over the nodes in contact.
class PunchEnergy {
public:
  /// @param share  of the area in contact [1] > 0
  PunchEnergy(SurfaceOperator& elasticity,
              std::span<const std::uint8_t> is_in_contact, double compliance,
              double share)
      : elasticity_(elasticity),
        workers_(elasticity.workers()),
        preconditioner_(elasticity),
        compliance_(compliance),
        share_(share),
        freedom_(is_in_contact.size()),
        blocks_(blocks_of(is_in_contact.size())),
        residual_(is_in_contact.size()),
        direction_(is_in_contact.size()),
        product_(is_in_contact.size()),
        estimate_(is_in_contact.size()),
        scratch_(is_in_contact.size()),
        single_(is_in_contact.size()) {
    for (std::size_t i = 0; i < freedom_.size(); ++i)
      if (is_in_contact[i] != 0) {
        freedom_[i] = may_shift;
        blocks_[i / block_nodes] = 1;
        direction_[i] = 1.0 / share;
      }
    preconditioner_.build(elasticity_, compliance_, {freedom_, blocks_});
  }

  PunchStiffness minimised() {
    PunchStiffness found;
    apply(); // to the uniform q
    double energy = dot(direction_, product_);
    const double unit = energy;
    center(product_);
    each([&](std::size_t i) {
      residual_[i] = -product_[i];
      direction_[i] = 0.0;
    });
    for (double before = 0.0; found.iterations < most_punch_iterations;
         ++found.iterations) {
      const double overlap = before > 0.0 ? dot(residual_, estimate_) : 0.0;
      precondition(unit);
      const double left = dot(residual_, estimate_);
      found.converged = left >= 0.0 && left <= energy_tolerance * energy;
      if (found.converged || !(left > 0.0))
        break;
      // Polak-Ribiere, because the preconditioner has single precision.
      const double beta =
          before > 0.0 ? std::max(0.0, (left - overlap) / before) : 0.0;
      before = left;
      each([&](std::size_t i) {
        direction_[i] = estimate_[i] + beta * direction_[i];
      });
      apply();
      const double slope = dot(residual_, direction_);
      const double length = slope / dot(direction_, product_);
      energy -= length * slope;
      center(product_);
      each([&](std::size_t i) { residual_[i] -= length * product_[i]; });
    }
    found.stiffness = 1.0 / energy;
    return found;
  }

private:
  template <class Update>
  void each(const Update& update) {
    chunked(freedom_.size(), workers_.threads,
            [&](std::size_t begin, std::size_t end) {
              for (std::size_t i = begin; i < end; ++i)
                update(i);
            });
  }

  double dot(std::span<const double> a, std::span<const double> b) const {
    return weighted_dot(elasticity_.nodal_weights(), a, b, workers_) /
           static_cast<double>(workers_.all_nodes(a.size()));
  }

  /// Takes from a field its mean over the contact, and sets it to 0 elsewhere.
  void center(std::vector<double>& field) {
    each([&](std::size_t i) { field[i] = freedom_[i] != 0 ? field[i] : 0.0; });
    const double mean =
        weighted_sum(elasticity_.nodal_weights(), field, workers_) /
        static_cast<double>(workers_.all_nodes(field.size())) / share_;
    each([&](std::size_t i) { field[i] -= freedom_[i] != 0 ? mean : 0.0; });
  }

  /// estimate = E^T (C + c)^-1 E residual, of mean 0.
  /// @param unit  size of the residual in single precision
  void precondition(double unit) {
    each([&](std::size_t i) {
      single_[i] = static_cast<float>(residual_[i] / unit);
    });
    preconditioner_.apply(elasticity_, compliance_, {freedom_, blocks_},
                          single_, scratch_, single_);
    each([&](std::size_t i) {
      estimate_[i] = static_cast<double>(single_[i]) * unit;
    });
    center(estimate_);
  }

  /// product = (C + c) direction
  void apply() {
    elasticity_.displacement(direction_, product_);
    each([&](std::size_t i) { product_[i] += compliance_ * direction_[i]; });
  }

  SurfaceOperator& elasticity_;
  Workers workers_;
  Preconditioner preconditioner_;
  double compliance_, share_;
  std::vector<std::uint8_t> freedom_;
  BlockFlags blocks_;
  std::vector<double> residual_, direction_, product_, estimate_;
  std::vector<float> scratch_, single_;
};

} // namespace

PunchStiffness punch_stiffness(SurfaceOperator& elasticity,
                               std::span<const std::uint8_t> is_in_contact,
                               double local_compliance) {
  const std::size_t nodes = elasticity.n_nodes();
  if (is_in_contact.size() != nodes)
    refuse_argument("is_in_contact.size()",
                    static_cast<double>(is_in_contact.size()),
                    "equal to " + std::to_string(nodes));
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  const Workers workers = elasticity.workers();
  const auto all = workers.all_nodes(nodes);
  const std::size_t count = total_count(
      workers,
      nodes - static_cast<std::size_t>(std::ranges::count(is_in_contact, 0)));
  if (count == 0)
    return {0.0, 0, true};
  if (count == all && elasticity.is_periodic() && local_compliance == 0.0)
    return {std::numeric_limits<double>::infinity(), 0, true};
  const double share = weighted_sum(elasticity.nodal_weights(), nodes, workers,
                                    [s = is_in_contact.data()](std::size_t i) {
                                      return s[i] != 0 ? 1.0 : 0.0;
                                    }) /
                       static_cast<double>(all);
  return PunchEnergy(elasticity, is_in_contact, local_compliance, share)
      .minimised();
}

} // namespace asperity::contact
