#include "theory/persson/height_spectrum.hpp"

#include "base/require.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity::theory {
namespace {

/// All results of one pass over a spectrum.
struct SpectrumIntegrals {
  double height = 0.0;              ///< int q C dq [m^2]
  double full_contact = 0.0;        ///< int q^2 C dq [m]
  double slope = 0.0;               ///< int q^3 C dq = M(q_1) [1]
  double curvature = 0.0;           ///< int q^5 C dq [1/m^2]
  std::vector<RoughnessNode> nodes; ///< descending in root_moment
};

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

/// Composite Gauss rule in t = sqrt(q - q_L), in which m is smooth at q_L, on
/// panels that end at every break, halve t towards q_L and limit the growth of
/// m to a factor of four.
/// @param formula  already checked: breaks ascend and C has roughness from
///                 breaks[0] on
SpectrumIntegrals integrate_formula(const SpectrumFormula& formula) {
  return FormulaPass(formula).run();
}

/// Gauss nodes on octaves of m, with weights that are exact for polynomials
/// times the step function 2/q(m): the step function enters through its
/// Legendre moments, with each step integrated in closed form.
/// @param shells  already checked, ascending in wavevector
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

} // namespace

struct HeightSpectrum::Prepared {
  double wavevector_low = 0.0;
  double wavevector_high = 0.0;
  ProfileMoments moments;
  double full_contact_moment = 0.0;
  std::vector<RoughnessNode> nodes;

  Prepared(double low, double high, SpectrumIntegrals integrals)
      : wavevector_low(low),
        wavevector_high(high),
        full_contact_moment(integrals.full_contact),
        nodes(std::move(integrals.nodes)) {
    using std::numbers::pi;
    moments.height = 2.0 * pi * integrals.height;
    moments.slope = pi * integrals.slope;
    moments.curvature = 0.75 * pi * integrals.curvature;
    require_positive("rms_slope of the spectrum", rms_slope(), "1");
  }

  double rms_slope() const { return std::sqrt(2.0 * moments.slope); }
};

namespace {

void check(const SpectrumFormula& formula) {
  const std::vector<double>& breaks = formula.breaks;
  if (breaks.size() < 2)
    refuse_argument("number of breaks", static_cast<double>(breaks.size()),
                    ">= 2: q_L, kinks, q_1");
  double before = 0.0;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    if (!(breaks[i] > before && std::isfinite(breaks[i])))
      refuse_argument("breaks[" + std::to_string(i) + "]", breaks[i],
                      "finite and above the break before it [rad/m]");
    before = breaks[i];
  }
}

// A spectrum that is zero up to one of its breaks is made to start at that
// break.
void drop_empty_start(SpectrumFormula& formula) {
  std::vector<double>& breaks = formula.breaks;
  const int n_samples = 8;
  const auto is_empty = [&](double low, double high) {
    for (int i = 0; i < n_samples; ++i)
      if (formula.height_spectrum(low + (high - low) * (i + 0.5) / n_samples) !=
          0.0)
        return false;
    return true;
  };
  while (breaks.size() > 2 && is_empty(breaks[0], breaks[1]))
    breaks.erase(breaks.begin());
}

void check(std::vector<SpectrumShell>& shells) {
  for (const SpectrumShell& shell : shells) {
    require_positive("wavevector of a shell", shell.wavevector, "rad/m");
    require_not_negative("mean_square_height of a shell",
                         shell.mean_square_height, "m^2");
  }
  std::erase_if(shells, [](const SpectrumShell& shell) {
    return shell.mean_square_height == 0.0;
  });
  if (shells.empty())
    refuse_argument("number of shells with roughness", 0.0, ">= 1");
  std::sort(shells.begin(), shells.end(), [](const auto& a, const auto& b) {
    return a.wavevector < b.wavevector;
  });
}

SpectrumFormula cut(SpectrumFormula formula, double low, double high) {
  std::vector<double>& breaks = formula.breaks;
  low = std::max(low, breaks.front());
  high = std::min(high, breaks.back());
  std::erase_if(breaks, [&](double q) { return q <= low || q >= high; });
  breaks.insert(breaks.begin(), low);
  breaks.push_back(high);
  return formula;
}

std::vector<SpectrumShell> cut(std::vector<SpectrumShell> shells, double low,
                               double high) {
  std::erase_if(shells, [&](const SpectrumShell& shell) {
    return shell.wavevector <= low || shell.wavevector > high;
  });
  return shells;
}

} // namespace

HeightSpectrum::HeightSpectrum(SpectrumFormula formula) {
  check(formula);
  drop_empty_start(formula);
  prepared_ = std::make_shared<const Prepared>(formula.breaks.front(),
                                               formula.breaks.back(),
                                               integrate_formula(formula));
  source_ = std::move(formula);
}

HeightSpectrum::HeightSpectrum(std::vector<SpectrumShell> shells) {
  check(shells);
  prepared_ = std::make_shared<const Prepared>(shells.front().wavevector,
                                               shells.back().wavevector,
                                               integrate_shells(shells));
  source_ = std::move(shells);
}

bool HeightSpectrum::has_density() const {
  return std::holds_alternative<SpectrumFormula>(source_);
}

double HeightSpectrum::density(double wavevector) const {
  const auto* formula = std::get_if<SpectrumFormula>(&source_);
  if (formula == nullptr)
    refuse_argument("wavevector", wavevector,
                    "of a spectrum that is a formula: shells have no density");
  const bool inside = wavevector >= formula->breaks.front() &&
                      wavevector <= formula->breaks.back();
  return inside ? formula->height_spectrum(wavevector) : 0.0;
}

std::span<const double> HeightSpectrum::breaks() const {
  const auto* formula = std::get_if<SpectrumFormula>(&source_);
  if (formula == nullptr)
    return {};
  return formula->breaks;
}

std::span<const SpectrumShell> HeightSpectrum::shells() const {
  const auto* shells = std::get_if<std::vector<SpectrumShell>>(&source_);
  if (shells == nullptr)
    return {};
  return *shells;
}

double HeightSpectrum::wavevector_low() const {
  return prepared_->wavevector_low;
}

double HeightSpectrum::wavevector_high() const {
  return prepared_->wavevector_high;
}

double HeightSpectrum::rms_height() const {
  return std::sqrt(prepared_->moments.height);
}

double HeightSpectrum::rms_slope() const {
  return prepared_->rms_slope();
}

const ProfileMoments& HeightSpectrum::profile_moments() const {
  return prepared_->moments;
}

double HeightSpectrum::full_contact_moment() const {
  return prepared_->full_contact_moment;
}

std::span<const RoughnessNode> HeightSpectrum::nodes() const {
  return prepared_->nodes;
}

HeightSpectrum HeightSpectrum::between(double low, double high) const {
  if (!(low < high))
    refuse_argument("low", low, "below high [rad/m]");
  return std::visit(
      [&](const auto& source) {
        return HeightSpectrum(cut(source, low, high));
      },
      source_);
}

} // namespace asperity::theory
