#include "theory/persson/roughness_nodes.hpp"

#include "base/require.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity::theory {
namespace {

constexpr std::size_t n_nodes = 20; // per panel
using NodeRule = boost::math::quadrature::gauss<double, n_nodes>;

// The contribution of m < 2^-n_octaves m_1 to any integral is below roundoff.
constexpr int n_octaves = 50;

struct PanelNode {
  double at = 0.0;     // -1..1, ascending
  double weight = 0.0; // the sum is 2
};

std::array<PanelNode, n_nodes> make_panel_nodes() {
  std::array<PanelNode, n_nodes> nodes;
  for (std::size_t i = 0; i < n_nodes / 2; ++i) {
    const double at = NodeRule::abscissa()[i];
    const double weight = NodeRule::weights()[i];
    nodes[n_nodes / 2 + i] = {at, weight};
    nodes[n_nodes / 2 - 1 - i] = {-at, weight};
  }
  return nodes;
}

const std::array<PanelNode, n_nodes>& panel_nodes() {
  static const std::array<PanelNode, n_nodes> nodes = make_panel_nodes();
  return nodes;
}

// Integrates a formula in one pass over panels in ascending t = sqrt(q - q_L).
class FormulaPass {
public:
  explicit FormulaPass(const SpectrumFormula& formula)
      : formula_(formula), low_(formula.breaks.front()) {}

  SpectrumIntegrals run() {
    double from = 0.0;
    for (std::size_t i = 1; i < formula_.breaks.size(); ++i) {
      const double to = std::sqrt(formula_.breaks[i] - low_);
      if (from == 0.0)
        first_segment(to);
      else
        add_geometric(from, to);
      from = to;
    }
    std::reverse(result_.nodes.begin(), result_.nodes.end());
    return std::move(result_);
  }

private:
  double wavevector(double t) const { return low_ + t * t; }

  // dM/dt = q^3 C dq/dt
  double moment_density(double t) const {
    const double q = wavevector(t);
    return q * q * q * formula_.height_spectrum(q) * 2.0 * t;
  }

  double moment(double from, double to) const {
    return NodeRule::integrate([this](double t) { return moment_density(t); },
                               from, to);
  }

  void first_segment(double to) {
    const double smallest = std::ldexp(to, -n_octaves);
    add_panel(0.0, smallest, moment(0.0, smallest));
    add_geometric(smallest, to);
  }

  void add_geometric(double from, double to) {
    const int n_panels =
        std::max(1, static_cast<int>(std::ceil(std::log2(to / from))));
    const double ratio = std::pow(to / from, 1.0 / n_panels);
    for (int i = 0; i < n_panels; ++i) {
      const double edge = i + 1 == n_panels ? to : from * ratio;
      add_split(from, edge, 0);
      from = edge;
    }
  }

  // Halves a panel (in ln t) until m grows at most fourfold over it.
  void add_split(double from, double to, int depth) {
    const double growth = moment(from, to);
    const int deepest = 8;
    if (growth > 15.0 * result_.slope && depth < deepest) {
      const double middle = std::sqrt(from * to);
      add_split(from, middle, depth + 1);
      add_split(middle, to, depth + 1);
    } else
      add_panel(from, to, growth);
  }

  void add_panel(double from, double to, double growth) {
    const double half = 0.5 * (to - from);
    for (const PanelNode& node : panel_nodes()) {
      const double t = from + half * (1.0 + node.at);
      const double q = wavevector(t);
      const double spectrum = formula_.height_spectrum(q);
      if (!(spectrum >= 0.0 && std::isfinite(spectrum)))
        refuse_argument("height_spectrum", spectrum, "finite and >= 0 [m^4]");
      const double energy_density = q * q * spectrum * 2.0 * t; // q^2 C dq/dt
      const double energy = node.weight * half * energy_density;
      result_.height += energy / q;
      result_.full_contact += energy;
      result_.curvature += energy * q * q * q;
      const double root = std::sqrt(result_.slope + moment(from, t));
      if (root > 0.0)
        result_.nodes.push_back({root, energy / root, // 2 dm = dM/m
                                 node.weight * half * 2.0 * t / (q * q)});
    }
    result_.slope += growth;
  }

  const SpectrumFormula& formula_;
  double low_;
  SpectrumIntegrals result_;
};

using Legendre = std::array<double, n_nodes + 1>;

Legendre legendre(double x) {
  Legendre polynomial{1.0, x};
  for (std::size_t l = 1; l + 1 < polynomial.size(); ++l) {
    const double order = static_cast<double>(l);
    polynomial[l + 1] =
        ((2.0 * order + 1.0) * x * polynomial[l] - order * polynomial[l - 1]) /
        (order + 1.0);
  }
  return polynomial;
}

// int_{-1}^x P_l for l < n_nodes: (P_{l+1} - P_{l-1})/(2l + 1).
Legendre legendre_integral(double x) {
  const Legendre polynomial = legendre(x);
  Legendre integral{x + 1.0};
  for (std::size_t l = 1; l < n_nodes; ++l)
    integral[l] = (polynomial[l + 1] - polynomial[l - 1]) /
                  (2.0 * static_cast<double>(l) + 1.0);
  return integral;
}

// One step of the step function: q is `wavevector` up to m = root_moment.
struct Step {
  double root_moment;
  double wavevector;
};

// int P_l(x(m)) 2 dm/q(m) over the panel, step by step.
Legendre staircase_moments(std::span<const Step> steps, double from,
                           double to) {
  const double half = 0.5 * (to - from);
  Legendre moments{};
  Legendre below = legendre_integral(-1.0);
  const auto higher = [](double m, const Step& s) { return m < s.root_moment; };
  auto step = std::upper_bound(steps.begin(), steps.end(), from, higher);
  for (; step != steps.end(); ++step) {
    const double edge = std::min(step->root_moment, to);
    const Legendre above = legendre_integral((edge - from) / half - 1.0);
    for (std::size_t l = 0; l < n_nodes; ++l)
      moments[l] += 2.0 * half / step->wavevector * (above[l] - below[l]);
    below = above;
    if (edge >= to)
      break;
  }
  return moments;
}

// Interpolating f at the Gauss nodes, f = sum_l P_l (l + 1/2) sum_k w_k
// P_l(x_k) f_k, gives the weights of int f 2 dm/q.
void add_octave(std::span<const Step> steps, double from, double to,
                std::vector<RoughnessNode>& nodes) {
  const Legendre moments = staircase_moments(steps, from, to);
  const double half = 0.5 * (to - from);
  for (std::size_t k = n_nodes; k-- > 0;) {
    const PanelNode& node = panel_nodes()[k];
    const Legendre polynomial = legendre(node.at);
    double weight = 0.0;
    for (std::size_t l = 0; l < n_nodes; ++l)
      weight += (static_cast<double>(l) + 0.5) * polynomial[l] * moments[l];
    nodes.push_back({from + half * (1.0 + node.at), node.weight * weight});
  }
}

} // namespace

SpectrumIntegrals integrate_formula(const SpectrumFormula& formula) {
  return FormulaPass(formula).run();
}

SpectrumIntegrals integrate_shells(std::span<const SpectrumShell> shells) {
  SpectrumIntegrals result;
  std::vector<Step> steps;
  for (const SpectrumShell& shell : shells) {
    const double q = shell.wavevector;
    const double height = shell.mean_square_height / (2.0 * std::numbers::pi);
    result.height += height;
    result.full_contact += height * q;
    result.slope += height * q * q;
    result.curvature += height * q * q * q * q;
    steps.push_back({std::sqrt(result.slope), q});
  }
  double to = std::sqrt(result.slope);
  for (int octave = 0; octave < n_octaves; ++octave, to *= 0.5)
    add_octave(steps, 0.5 * to, to, result.nodes);
  add_octave(steps, 0.0, to, result.nodes);
  return result;
}

} // namespace asperity::theory
