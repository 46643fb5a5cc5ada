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
/// over the nodes in contact, or with a film over all nodes. The preconditioner
/// is the one of the contact iteration on the contact and where the film is
/// stiffer than the body towards the shortest waves, and 1/c elsewhere.
class PunchEnergy {
public:
  /// @param share  of the area on which q acts [1] > 0
  PunchEnergy(SurfaceOperator& elasticity,
              std::span<const std::uint8_t> is_in_contact, double compliance,
              std::span<const double> film, double share)
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
    compliances_.assign(film.begin(), film.end());
    const double shortest = film.empty() ? 0.0 : shortest_compliance();
    for (std::size_t i = 0; i < freedom_.size(); ++i) {
      const bool touches = is_in_contact[i] != 0;
      if (!film.empty() && touches)
        compliances_[i] = compliance;
      if (touches || (!film.empty() && film[i] < shortest)) {
        freedom_[i] = may_shift;
        blocks_[i / block_nodes] = 1;
      }
      direction_[i] = !film.empty() ? 1.0 / (compliances_[i] + shortest)
                      : touches     ? 1.0 / share
                                    : 0.0;
    }
    if (!film.empty()) {
      const double scale = 1.0 / mean(direction_);
      each([&](std::size_t i) { direction_[i] *= scale; });
    }
    preconditioner_.build(elasticity_, compliance_, {freedom_, blocks_});
  }

  PunchStiffness minimised() {
    PunchStiffness found;
    apply(); // to the first q
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

  bool is_free(std::size_t i) const {
    return freedom_[i] != 0 || !compliances_.empty();
  }

  double compliance_of(std::size_t i) const {
    return compliances_.empty() ? compliance_ : compliances_[i];
  }

  double mean(std::span<const double> field) const {
    return weighted_sum(elasticity_.nodal_weights(), field, workers_) /
           static_cast<double>(workers_.all_nodes(field.size()));
  }

  /// C of pressures that alternate from node to node [m/Pa].
  double shortest_compliance() {
    each([&](std::size_t i) { direction_[i] = i % 2 == 0 ? 1.0 : -1.0; });
    elasticity_.displacement(direction_, product_);
    return dot(direction_, product_) / dot(direction_, direction_);
  }

  /// Takes from a field its mean over the free nodes, and sets it to 0
  /// elsewhere.
  void center(std::vector<double>& field) {
    each([&](std::size_t i) { field[i] = is_free(i) ? field[i] : 0.0; });
    const double of_free = mean(field) / share_;
    each([&](std::size_t i) { field[i] -= is_free(i) ? of_free : 0.0; });
  }

  /// estimate = E^T (C + c)^-1 E residual, of mean 0.
  /// @param unit  size of the residual in single precision
  void precondition(double unit) {
    each([&](std::size_t i) {
      single_[i] =
          freedom_[i] != 0 ? static_cast<float>(residual_[i] / unit) : 0.0F;
    });
    preconditioner_.apply(elasticity_, compliance_, {freedom_, blocks_},
                          single_, scratch_, single_);
    each([&](std::size_t i) {
      if (freedom_[i] != 0)
        estimate_[i] = static_cast<double>(single_[i]) * unit;
      else if (!compliances_.empty())
        estimate_[i] = residual_[i] / compliances_[i];
    });
    center(estimate_);
  }

  /// product = (C + c) direction
  void apply() {
    elasticity_.displacement(direction_, product_);
    each([&](std::size_t i) {
      product_[i] += compliance_of(i) * direction_[i];
    });
  }

  SurfaceOperator& elasticity_;
  Workers workers_;
  Preconditioner preconditioner_;
  double compliance_, share_;
  std::vector<double> compliances_; ///< with a film, of each node
  std::vector<std::uint8_t> freedom_;
  BlockFlags blocks_;
  std::vector<double> residual_, direction_, product_, estimate_;
  std::vector<float> scratch_, single_;
};

} // namespace

PunchStiffness punch_stiffness(SurfaceOperator& elasticity,
                               std::span<const std::uint8_t> is_in_contact,
                               double local_compliance,
                               std::span<const double> film) {
  const std::size_t nodes = elasticity.n_nodes();
  if (is_in_contact.size() != nodes)
    refuse_argument("is_in_contact.size()",
                    static_cast<double>(is_in_contact.size()),
                    "equal to " + std::to_string(nodes));
  if (!film.empty() && film.size() != nodes)
    refuse_argument("film.size()", static_cast<double>(film.size()),
                    "equal to " + std::to_string(nodes));
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  const Workers workers = elasticity.workers();
  const auto all = workers.all_nodes(nodes);
  const std::size_t count = total_count(
      workers,
      nodes - static_cast<std::size_t>(std::ranges::count(is_in_contact, 0)));
  if (count == 0 && film.empty())
    return {0.0, 0, true};
  if (count == all && elasticity.is_periodic() && local_compliance == 0.0)
    return {std::numeric_limits<double>::infinity(), 0, true};
  const double area = weighted_sum(
      elasticity.nodal_weights(), nodes, workers,
      [s = is_in_contact.data(), has_film = !film.empty()](std::size_t i) {
        return has_film || s[i] != 0 ? 1.0 : 0.0;
      });
  return PunchEnergy(elasticity, is_in_contact, local_compliance, film,
                     area / static_cast<double>(all))
      .minimised();
}

} // namespace asperity::contact
