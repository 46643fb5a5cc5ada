#include "contact/solvers/adhesive.hpp"

#include "contact/solvers/adhesive_state.hpp"
#include "contact/solvers/lowest_mode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

// A tour: solve_adhesive() below is the loop. AdhesiveState holds the gap, the
// residual and the free nodes, and finds what a step does to the energy
// (adhesive_state.hpp). Quasi-Newton directions are in Directions, here, and
// lowest_mode.hpp tells a minimum from a saddle.

namespace asperity::contact {
namespace {

constexpr std::size_t n_pairs = 4;

/// Share of the first order of a step that the energy must fall by (Armijo).
constexpr double least_fall = 1e-4;
constexpr double shortening = 0.4;
/// Of the step while no curvature is known.
constexpr double lengthening = 2.0;
constexpr int most_trials = 25;

/// k_c over the stiffness of short waves: M is a difference in single
/// precision, of which this share is left for them.
constexpr double softest = 1e-4;

/// Saddles that are left before the solver gives up.
constexpr int most_saddles = 20;
/// Largest change of a gap on the way from a saddle, relative to the range.
constexpr double leap_from_saddle = 0.1;

/// A change of the gap [m] and that of the gradient [Pa].
struct Pair {
  std::vector<float> step, bend;
};

/// L-BFGS directions on the free nodes.
class QuasiNewton {
public:
  explicit QuasiNewton(std::size_t nodes) : r_(nodes), direction_(nodes) {}

  /// The direction -H r, where H is M with the corrections of the pairs, as
  /// far as these have a positive curvature on the free nodes of now.
  std::span<const double> direction(AdhesiveState& state) {
    state.residual(r_);
    std::array<Products, n_pairs> of{};
    has_curvature_ = false;
    for (std::size_t k = 0; k < n_used_; ++k) { // newest first
      of[k] = products(state, pair(k));
      if (!(of[k].curvature > 0.0))
        continue;
      has_curvature_ = true;
      of[k].share = dot(state, pair(k).step, r_) / of[k].curvature;
      add(state, -of[k].share, pair(k).bend, of[k].mean_bend, r_);
    }
    state.precondition(r_, direction_);
    for (std::size_t k = n_used_; k-- > 0;) {
      if (!(of[k].curvature > 0.0))
        continue;
      double product = dot(state, pair(k).bend, direction_);
      if (state.by_spring())
        product -= of[k].mean_bend *
                   state.sum([this](std::size_t i) { return direction_[i]; });
      const double share = of[k].share - product / of[k].curvature;
      add(state, share, pair(k).step, of[k].mean_step, direction_);
    }
    state.each([&](std::size_t i) { direction_[i] = -direction_[i]; });
    return direction_;
  }

  /// The direction -r over the stiffness of the shortest waves: that of a step
  /// whose projection lowers the energy, where that of M r may not.
  std::span<const double> steepest(AdhesiveState& state) {
    state.residual(direction_);
    state.each([&](std::size_t i) { direction_[i] /= -state.stiffest_waves; });
    return direction_;
  }

  /// rms(F M r) [m]. Without a wall the scale of M hides what repulsion and
  /// surface miss of the load, which counts as well, over k_c.
  double error(AdhesiveState& state) {
    state.residual(r_);
    const double missing = std::isfinite(state.wall())
                               ? 0.0
                               : state.sum([r = r_.data()](std::size_t i) {
                                   return r[i];
                                 }) / state.n_nodes();
    state.precondition(r_, r_);
    return std::hypot(state.rms(r_),
                      missing / state.problem.preconditioner_stiffness);
  }

  /// Adopts the last step of a state as the newest pair.
  void take(AdhesiveState& state) {
    newest_ = (newest_ + 1) % n_pairs;
    n_used_ = std::min(n_pairs, n_used_ + 1);
    Pair& own = pairs_.at(newest_);
    own.step.resize(r_.size());
    own.bend.resize(r_.size());
    state.take(own.step, own.bend);
  }

  bool has_pairs() const { return n_used_ > 0; }

  /// Whether some pair had a positive curvature in the last direction(), so
  /// that its length is a guess of the distance to a minimum.
  bool has_curvature() const { return has_curvature_; }

  void forget() { n_used_ = 0; }

private:
  struct Products {
    double curvature = 0.0; ///< step . bend
    /// Parts of all nodes that do not count: the means under gap control; the
    /// load of a spring that the bend lacks.
    double mean_step = 0.0, mean_bend = 0.0;
    double share = 0.0;
  };

  const Pair& pair(std::size_t age) const {
    return pairs_.at((newest_ + n_pairs - age) % n_pairs);
  }

  /// The products of a pair as restrict_to_free() would leave it.
  static Products products(const AdhesiveState& state, const Pair& pair) {
    const auto [product, step, bend] =
        several_sums<3>(pair.step.size(), state.workers,
                        [f = state.free.data(), s = pair.step.data(),
                         y = pair.bend.data()](std::size_t i, auto& own) {
                          if (f[i] != 0) {
                            const double own_step = s[i];
                            const double own_bend = y[i];
                            own[0] += own_step * own_bend;
                            own[1] += own_step;
                            own[2] += own_bend;
                          }
                        });
    if (state.by_spring()) {
      const double load = state.target.spring * step / state.n_nodes();
      return {product + load * step, 0.0, -load, 0.0};
    }
    if (!state.by_gap() || state.n_free == 0.0)
      return {product, 0.0, 0.0, 0.0};
    return {product - step * bend / state.n_free, step / state.n_free,
            bend / state.n_free, 0.0};
  }

  static double dot(const AdhesiveState& state, std::span<const float> of_pair,
                    std::span<const double> field) {
    return state.sum([a = of_pair.data(), b = field.data()](std::size_t i) {
      return static_cast<double>(a[i]) * b[i];
    });
  }

  static void add(const AdhesiveState& state, double factor,
                  std::span<const float> of_pair, double mean,
                  std::span<double> field) {
    state.each([=, &state](std::size_t i) {
      if (state.free[i] != 0)
        field[i] += factor * (static_cast<double>(of_pair[i]) - mean);
    });
  }

  std::vector<double> r_, direction_;
  std::array<Pair, n_pairs> pairs_;
  std::size_t newest_ = 0, n_used_ = 0;
  bool has_curvature_ = false;
};

/// Shortens a step until the energy falls. Returns false if it does not.
bool falls(AdhesiveState& state, std::span<const double> direction,
           double length, double share) {
  for (int trial = 0; trial < most_trials; ++trial) {
    const AdhesiveState::Change change = state.try_step(direction, length);
    if (change.energy < 0.0 && change.energy <= share * change.slope)
      return true;
    length *= shortening;
  }
  return false;
}

/// Leaves a saddle along the eigenvector, to the side where the energy falls.
bool leave_saddle(AdhesiveState& state, std::vector<double>& mode) {
  const double largest = largest_size(mode, state.workers);
  const double leap =
      leap_from_saddle * state.problem.law.adhesion_range / largest;
  for (const double sign : {1.0, -1.0})
    if (falls(state, mode, sign * leap, 0.0)) {
      state.take();
      return true;
    }
  return false;
}

/// How a minimisation ended.
struct End {
  double error = std::numeric_limits<double>::infinity(); ///< rms(F M r) [m]
  double missing_load = 0.0;                              ///< [Pa]
  double accepted_load = 0.0;                             ///< [Pa]
  double smallest_stiffness = std::numeric_limits<double>::quiet_NaN();
  bool converged = false;
  std::string note = {};
};

void find_errors(AdhesiveState& state, QuasiNewton& directions, End& end) {
  end.error = directions.error(state);
  end.missing_load = state.missing_load();
  end.accepted_load = state.accepted_load();
}

/// Whether the load that the law misses is the roundoff of the energy: it is
/// within that, and in so many iterations it has not come down to a half. The
/// energy then falls or rises by its roundoff, and the way leads nowhere.
class RoundoffOfLoad {
public:
  bool is_reached(const End& end, const AdhesiveState& state) {
    constexpr int patience = 20;
    if (!(end.missing_load <= state.unresolved_load()))
      return false;
    if (end.missing_load <= 0.5 * least_) {
      least_ = end.missing_load;
      since_ = 0;
    }
    return ++since_ > patience;
  }

private:
  double least_ = std::numeric_limits<double>::infinity(); ///< [Pa]
  int since_ = 0;
};

/// Goes downhill until the residual is small, the surfaces part, or the
/// iterations end.
void minimise(AdhesiveState& state, QuasiNewton& directions, int& iterations,
              End& end) {
  end.converged = false;
  bool is_lowest = false;
  RoundoffOfLoad roundoff;
  double stride = 1.0;
  while (!state.is_detached()) {
    std::span<const double> direction = directions.direction(state);
    const double size = state.rms(direction);
    if (!(size > state.problem.gap_tolerance)) {
      find_errors(state, directions, end);
      end.converged = end.error <= state.problem.gap_tolerance &&
                      end.missing_load <= end.accepted_load;
      if (end.converged || !std::isfinite(size))
        return;
      is_lowest = end.error <= state.problem.gap_tolerance &&
                  roundoff.is_reached(end, state);
      if (is_lowest)
        break;
      direction = directions.direction(state);
    }
    if (iterations == state.problem.max_iterations)
      break;
    // Where the energy is concave along the way, no length is known: the faces
    // jump into contact or part. They do not pass their range in one step.
    stride = directions.has_curvature()
                 ? 1.0
                 : std::clamp(state.problem.law.adhesion_range / size, 1.0,
                              lengthening * stride);
    if (!falls(state, direction, stride, least_fall)) {
      stride = 1.0;
      const bool had_pairs = directions.has_pairs();
      directions.forget();
      if (had_pairs)
        continue;
      is_lowest = !falls(state, directions.steepest(state), 1.0, 0.0);
      if (is_lowest)
        break;
    }
    directions.take(state);
    ++iterations;
  }
  if (state.is_detached())
    return;
  find_errors(state, directions, end);
  if (is_lowest) {
    end.accepted_load = std::max(end.accepted_load, state.unresolved_load());
    end.converged = end.error <= state.problem.gap_tolerance &&
                    end.missing_load <= end.accepted_load;
  }
}

ContactSolution solution_of(AdhesiveState&& state) {
  ContactSolution answer;
  const std::size_t nodes = state.gap.size();
  const double n = state.n_nodes();
  answer.is_detached = state.is_detached();
  answer.pressure.assign(nodes, 0.0);
  answer.displacement.assign(nodes, 0.0);
  const double* const h = state.problem.heights.data();
  const double mean_height = state.sum([=](std::size_t i) { return h[i]; }) / n;
  if (answer.is_detached) {
    const double level =
        state.least_gap + largest_of(state.problem.heights, state.workers);
    state.each([&](std::size_t i) { state.gap[i] = level - h[i]; });
  }
  answer.mean_gap =
      state.sum([g = state.gap.data()](std::size_t i) { return g[i]; }) / n;
  if (!answer.is_detached)
    state.each([&](std::size_t i) {
      answer.pressure[i] = state.elastic[i] + state.load;
      answer.displacement[i] =
          state.gap[i] + h[i] - answer.mean_gap - mean_height;
    });
  answer.nominal_pressure =
      state.sum([p = answer.pressure.data()](std::size_t i) { return p[i]; }) /
      n;
  answer.gap = std::move(state.gap);
  answer.transforms = state.transforms;
  return answer;
}

} // namespace

std::string detached_note(double nominal_pressure) {
  return fmt::format(
      "detached: the contact does not hold a nominal pressure of {:.4g} Pa",
      nominal_pressure);
}

double adhesive_scale(SurfaceOperator& elasticity,
                      std::span<const double> heights) {
  std::vector<double> pressure(heights.size());
  elasticity.pressure_of(heights, pressure);
  const Workers workers = elasticity.workers();
  const double mean = weighted_sum({}, heights, workers) /
                      static_cast<double>(workers.all_nodes(heights.size()));
  const double square = weighted_sum({}, heights.size(), workers,
                                     [=, h = heights.data()](std::size_t i) {
                                       return (h[i] - mean) * (h[i] - mean);
                                     });
  const double scale = weighted_dot({}, heights, pressure, workers) / square;
  const double short_waves = 1.0 / elasticity.short_wave_compliance();
  return scale > 0.0 && std::isfinite(scale)
             ? std::max(scale, softest * short_waves)
             : short_waves / 16.0;
}

ContactSolution solve_adhesive(SurfaceOperator& elasticity,
                               const AdhesiveProblem& problem,
                               const mechanics::LoadTarget& target,
                               std::vector<double> start) {
  AdhesiveState state(elasticity, problem, target, std::move(start));
  QuasiNewton directions(state.gap.size());
  int iterations = 0;
  End end;
  for (int saddles = 0;; ++saddles) {
    minimise(state, directions, iterations, end);
    if (!end.converged)
      break;
    LowestMode mode = lowest_mode(state);
    end.smallest_stiffness = mode.eigenvalue;
    if (std::isnan(mode.eigenvalue)) {
      end.converged = false;
      end.note = "the smallest eigenvalue of the Hessian was not found";
      break;
    }
    if (!mode.is_saddle)
      break;
    if (saddles == most_saddles || !leave_saddle(state, mode.vector)) {
      end.converged = false;
      end.note = "the energy has a saddle here, from which no way leads down";
      break;
    }
    directions.forget();
  }
  ContactSolution answer = solution_of(std::move(state));
  answer.iterations = iterations;
  answer.gap_error = answer.is_detached ? 0.0 : end.error;
  answer.load_tolerance = end.accepted_load;
  answer.converged = end.converged || answer.is_detached;
  answer.smallest_stiffness = end.smallest_stiffness;
  answer.note = end.note;
  if (answer.is_detached)
    answer.note = detached_note(target.amount);
  else if (!answer.converged && answer.note.empty())
    answer.note = fmt::format(
        "not converged after {} iterations: a correction of the gap of {:.3g} "
        "m remains (rms), and the law misses {:.3g} Pa of the load, {:.3g} Pa "
        "more than accepted",
        iterations, end.error, end.missing_load,
        std::max(0.0, end.missing_load - end.accepted_load));
  return answer;
}

} // namespace asperity::contact
