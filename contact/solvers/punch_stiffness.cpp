#include "contact/solvers/punch_stiffness.hpp"

#include "base/ranks/node_sums.hpp"
#include "base/require.hpp"
#include "contact/solvers/node_kernels.hpp"
#include "contact/solvers/preconditioner.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace asperity::contact {
namespace {

constexpr int most_punch_iterations = 1000;

/// Share of the energy that may be left to gain, by the preconditioner. The
/// pressure is accurate to its root: where it is needed, the share is smaller.
constexpr double energy_tolerance = 1e-10;
constexpr double pressure_tolerance = 1e-18;

struct Descent {
  double gain = 0.0; ///< of energy, a sum of positive numbers
  int iterations = 0;
  bool converged = false;
};

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
        freedom_(is_in_contact.size()),
        blocks_(blocks_of(is_in_contact.size())),
        uniform_(is_in_contact.size()),
        residual_(is_in_contact.size()),
        pressure_(is_in_contact.size()),
        direction_(is_in_contact.size()),
        product_(is_in_contact.size()),
        estimate_(is_in_contact.size()),
        scratch_(Preconditioner::scratch_size(elasticity)),
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
      uniform_[i] = !film.empty() ? 1.0 / (compliances_[i] + shortest)
                    : touches     ? 1.0 / share
                                  : 0.0;
    }
    if (!film.empty()) {
      const double scale = 1.0 / mean(uniform_);
      each([&](std::size_t i) { uniform_[i] *= scale; });
    }
    preconditioner_.build(elasticity_, compliance_, {freedom_, blocks_});
  }

  PunchStiffness minimised(double tolerance) {
    direction_ = pressure_ = uniform_;
    apply();
    const double begun = dot(direction_, product_);
    each([&](std::size_t i) { residual_[i] = -product_[i]; });
    const Descent made =
        descend(begun, [&](double gain) { return tolerance * (begun - gain); });
    return {1.0 / (begun - made.gain), made.iterations, made.converged,
            pressure_};
  }

  /// Minimises <v (C + c) v> - 2 <r v> over the pressures v of mean 0.
  /// @param begun  energy to which v adds
  /// @return       by how much less the sum is
  Descent lowered(double begun, std::vector<double> r) {
    residual_ = std::move(r);
    return descend(begun, [&](double gain) {
      return energy_tolerance * std::min(gain, begun - gain);
    });
  }

  /// q after minimised().
  std::span<const double> pressure() const { return pressure_; }

private:
  /// Conjugate gradients from pressure_ with its residual.
  /// @param unit     size of the energy
  /// @param allowed  of a gain so far, what may be left to gain
  template <class Allowed>
  Descent descend(double unit, const Allowed& allowed) {
    Descent made;
    level(residual_);
    each([&](std::size_t i) { direction_[i] = 0.0; });
    for (double before = 0.0; made.iterations < most_punch_iterations;
         ++made.iterations) {
      const double overlap = before > 0.0 ? dot(residual_, estimate_) : 0.0;
      precondition(unit);
      const double left = dot(residual_, estimate_);
      made.converged = left >= 0.0 && left <= allowed(made.gain);
      if (made.converged || !(left > 0.0))
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
      made.gain += length * slope;
      level(product_);
      each([&](std::size_t i) {
        pressure_[i] += length * direction_[i];
        residual_[i] -= length * product_[i];
      });
    }
    return made;
  }

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

  /// Takes from a displacement the constant that the uniform approach feels,
  /// and sets it to 0 outside the free nodes.
  void level(std::vector<double>& field) {
    each([&](std::size_t i) { field[i] = is_free(i) ? field[i] : 0.0; });
    const double felt = dot(uniform_, field);
    each([&](std::size_t i) { field[i] -= is_free(i) ? felt : 0.0; });
  }

  /// Takes from a pressure its mean, as a uniform approach.
  void balance(std::vector<double>& field) {
    each([&](std::size_t i) { field[i] = is_free(i) ? field[i] : 0.0; });
    const double load = mean(field);
    each([&](std::size_t i) { field[i] -= load * uniform_[i]; });
  }

  /// estimate = E^T (C + c)^-1 E residual, of mean 0.
  /// @param unit  size of the residual in single precision
  void precondition(double unit) {
    each([&](std::size_t i) {
      single_[i] =
          freedom_[i] != 0 ? static_cast<float>(residual_[i] / unit) : 0.0F;
    });
    preconditioner_.apply(elasticity_, compliance_, {freedom_, blocks_},
                          single_, scratch_);
    each([&](std::size_t i) {
      if (freedom_[i] != 0)
        estimate_[i] = static_cast<double>(scratch_[i]) * unit;
      else if (!compliances_.empty())
        estimate_[i] = residual_[i] / compliances_[i];
    });
    balance(estimate_);
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
  double compliance_;
  std::vector<double> compliances_; ///< with a film, of each node
  std::vector<std::uint8_t> freedom_;
  BlockFlags blocks_;
  std::vector<double> uniform_; ///< of mean 1, about that of a uniform approach
  std::vector<double> residual_, pressure_, direction_, product_, estimate_;
  std::vector<float> scratch_, single_;
};

void require_sizes(std::size_t nodes, std::size_t in_contact,
                   std::size_t film) {
  if (in_contact != nodes)
    refuse_argument("is_in_contact.size()", static_cast<double>(in_contact),
                    "equal to " + std::to_string(nodes));
  if (film != nodes)
    refuse_argument("film.size()", static_cast<double>(film),
                    "equal to " + std::to_string(nodes));
}

/// Nodes in contact on all ranks.
std::size_t count_of(std::span<const std::uint8_t> is_in_contact,
                     const Workers& workers) {
  return total_count(workers, is_in_contact.size() -
                                  static_cast<std::size_t>(
                                      std::ranges::count(is_in_contact, 0)));
}

/// The area of contact over that of the surface.
double share_of(std::span<const std::uint8_t> is_in_contact,
                const SurfaceOperator& elasticity) {
  const Workers workers = elasticity.workers();
  const std::size_t nodes = is_in_contact.size();
  return weighted_sum(elasticity.nodal_weights(), nodes, workers,
                      [s = is_in_contact.data()](std::size_t i) {
                        return s[i] != 0 ? 1.0 : 0.0;
                      }) /
         static_cast<double>(workers.all_nodes(nodes));
}

} // namespace

PunchStiffness punch_stiffness(SurfaceOperator& elasticity,
                               std::span<const std::uint8_t> is_in_contact,
                               double local_compliance,
                               std::span<const double> film) {
  const std::size_t nodes = elasticity.n_nodes();
  require_sizes(nodes, is_in_contact.size(),
                film.empty() ? nodes : film.size());
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  const Workers workers = elasticity.workers();
  const std::size_t count = count_of(is_in_contact, workers);
  if (count == 0 && film.empty())
    return {.stiffness = 0.0, .converged = true};
  if (count == workers.all_nodes(nodes) && elasticity.is_periodic() &&
      local_compliance == 0.0)
    return {.stiffness = std::numeric_limits<double>::infinity(),
            .converged = true};
  const double share = film.empty() ? share_of(is_in_contact, elasticity) : 1.0;
  return PunchEnergy(elasticity, is_in_contact, local_compliance, film, share)
      .minimised(energy_tolerance);
}

FilmStiffness film_stiffness(SurfaceOperator& elasticity,
                             std::span<const std::uint8_t> is_in_contact,
                             std::span<const double> film) {
  const std::size_t nodes = elasticity.n_nodes();
  require_sizes(nodes, is_in_contact.size(), film.size());
  const Workers workers = elasticity.workers();
  const std::size_t count = count_of(is_in_contact, workers);
  if (count == workers.all_nodes(nodes))
    return {elasticity.is_periodic() ? std::numeric_limits<double>::infinity()
                                     : 0.0,
            true};
  PunchStiffness alone{.stiffness = 0.0, .converged = true};
  if (count > 0) {
    PunchEnergy energy(elasticity, is_in_contact, 0.0, {},
                       share_of(is_in_contact, elasticity));
    alone = energy.minimised(pressure_tolerance);
    const double begun = 1.0 / alone.stiffness;
    std::vector<double> left(nodes);
    elasticity.displacement(energy.pressure(), left);
    for (std::size_t i = 0; i < nodes; ++i)
      left[i] = is_in_contact[i] != 0 ? 0.0 : begun - left[i];
    const Descent made = PunchEnergy(elasticity, is_in_contact, 0.0, film, 1.0)
                             .lowered(begun, std::move(left));
    if (made.gain < 0.5 * begun)
      return {made.gain / ((begun - made.gain) * begun),
              alone.converged && made.converged};
  }
  // The film is stiffer than the contact.
  const PunchStiffness both =
      punch_stiffness(elasticity, is_in_contact, 0.0, film);
  return {both.stiffness - alone.stiffness, alone.converged && both.converged};
}

} // namespace asperity::contact
