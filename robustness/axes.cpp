#include "robustness/axes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <stdexcept>

namespace asperity::robustness {
namespace {

/// The lower edges of the bins of a numerical axis; the last bin is unbounded.
struct Edges {
  std::vector<double> low;

  std::string label(std::size_t bin) const {
    return bin + 1 < low.size()
               ? fmt::format("{:g}..{:g}", low[bin], low[bin + 1])
               : fmt::format("{:g}..", low[bin]);
  }

  std::string label_of(double value) const {
    const auto above = std::upper_bound(low.begin() + 1, low.end(), value);
    return label(static_cast<std::size_t>(above - low.begin()) - 1);
  }

  std::vector<std::string> labels() const {
    std::vector<std::string> all;
    for (std::size_t bin = 0; bin < low.size(); ++bin)
      all.push_back(label(bin));
    return all;
  }
};

const Edges penalties{{1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12}};
const Edges loads{{1e-12, 1e-6, 1e-3, 1e-1, 1.0, 10.0}};
const Edges gaps{{-1.0, 0.0, 0.1, 1.0}};
const Edges hursts{{0.0, 0.2, 0.5, 0.8, 1.0}};
const Edges slopes{{1e-6, 1e-4, 1e-2, 1.0}};
const Edges lengths{{1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3}};
const Edges moduli{{1.0, 1e3, 1e6, 1e9}};
const Edges thicknesses{{0.01, 0.05, 0.3, 1.0, 3.0}};
const Edges growths{{1.0, 1.5, 2.0, 2.5}};
const Edges modulus_ratios{{1.0, 10.0, 100.0}};
const std::vector<std::string> coatings{"softer", "none", "stiffer"};

template <class Enum>
std::vector<std::string> names(Enum first, Enum last) {
  std::vector<std::string> all;
  for (int i = static_cast<int>(first); i <= static_cast<int>(last); ++i)
    all.push_back(name_of(static_cast<Enum>(i)));
  return all;
}

std::string plain(double value) {
  return fmt::format("{:g}", value);
}

bool is_elements(Family family) {
  return family == Family::condensed_q1 || family == Family::condensed_q2 ||
         family == Family::full_block;
}

std::string coating_of(const Instance& instance) {
  const double stiffness = instance.coating_stiffness;
  return coatings[stiffness < 1.0 ? 0 : stiffness > 1.0 ? 2 : 1];
}

/// Returns the label if the axis applies to the instance, otherwise an empty
/// string.
std::string where(bool is_meant, const std::string& label) {
  return is_meant ? label : std::string();
}

} // namespace

const std::vector<Axis>& axes() {
  using mechanics::ContactLaw;
  using mechanics::Control;
  using mechanics::FarBoundary;
  using mechanics::MeshKind;
  static const std::vector<Axis> all{
      {"family", names(Family::halfspace, Family::flawed)},
      {"shape", names(Shape::rough, Shape::flat)},
      {"law", names(ContactLaw::penalty, ContactLaw::morse)},
      {"penalty", penalties.labels()},
      {"control", names(Control::nominal_pressure, Control::mean_gap)},
      {"load", loads.labels()},
      {"gap", gaps.labels()},
      {"program", names(Program::increments, Program::cycle)},
      {"points", {"8", "16", "24", "32", "48", "64"}},
      {"shortest-wave", {"2", "2.1", "3", "4", "8"}},
      {"hurst", hursts.labels()},
      {"rms-slope", slopes.labels()},
      {"length", lengths.labels()},
      {"modulus", moduli.labels()},
      {"nu", {"0", "0.3", "0.49", "0.4999"}},
      {"top", names(FarBoundary::clamped, FarBoundary::pressure)},
      {"boundaries", {"periodic", "free"}},
      {"thickness", thicknesses.labels()},
      {"growth", growths.labels()},
      {"element", {"Q1", "Q2"}},
      {"coating", coatings},
      {"metamorphic pair",
       names(MetamorphicRelation::none, MetamorphicRelation::direct_solver)},
      {"flaw", names(Flaw::nan_height, Flaw::infinite_modulus)},
      {"path", names(Path::library, Path::two_ranks)},
      {"threads", {"1", "2", "3"}},
      {"sides", {"periodic", "free"}},
      {"linear-solver", {"auto", "multigrid"}},
      {"modulus-ratio", modulus_ratios.labels()},
      {"mesh", names(MeshKind::layers, MeshKind::gmsh)},
      {"counter-body", names(CounterBody::none, CounterBody::cuboid)}};
  return all;
}

std::vector<std::string> labels_of(const Instance& instance) {
  const Family family = instance.family;
  const bool is_contact = family != Family::theory && family != Family::flawed;
  const bool is_continuum = is_contact && family != Family::atoms;
  const bool is_thick =
      is_continuum && (family == Family::slab || is_elements(family));
  const bool by_pressure =
      family == Family::theory ||
      instance.control == mechanics::Control::nominal_pressure;
  const bool is_rough = family == Family::theory ||
                        instance.shape == Shape::rough ||
                        instance.shape == Shape::terraces;
  const bool is_sound = family != Family::flawed;
  return {
      name_of(family),
      where(is_contact, name_of(instance.shape)),
      where(is_continuum, name_of(instance.law)),
      where(is_continuum && mechanics::needs_penalty(instance.law),
            penalties.label_of(instance.penalty)),
      where(is_contact, name_of(instance.control)),
      where(is_sound && by_pressure, loads.label_of(instance.load)),
      where(is_contact && !by_pressure, gaps.label_of(instance.load)),
      where(is_contact, name_of(instance.program)),
      where(is_contact, plain(instance.points)),
      where(is_sound && is_rough, plain(instance.shortest_wave)),
      where(is_sound && is_rough, hursts.label_of(instance.hurst)),
      where(is_sound, slopes.label_of(instance.rms_slope)),
      where(is_sound, lengths.label_of(instance.length)),
      where(is_sound, moduli.label_of(instance.contact_modulus)),
      where(is_thick, plain(instance.poisson_ratio)),
      where(is_thick, name_of(instance.far_boundary)),
      where(family == Family::halfspace,
            instance.has_free_boundaries ? "free" : "periodic"),
      where(is_thick, thicknesses.label_of(instance.thickness)),
      where(is_elements(family), growths.label_of(instance.growth)),
      where(family == Family::full_block, instance.degree == 1 ? "Q1" : "Q2"),
      where(is_elements(family), coating_of(instance)),
      where(is_continuum, name_of(instance.relation)),
      where(!is_sound, name_of(instance.flaw)),
      name_of(instance.path),
      where(instance.relation == MetamorphicRelation::threads ||
                instance.path != Path::library,
            plain(instance.threads)),
      where(family == Family::full_block,
            instance.has_free_sides ? "free" : "periodic"),
      where(family == Family::full_block, name_of(instance.linear_solver)),
      where(family == Family::full_block,
            modulus_ratios.label_of(instance.modulus_ratio)),
      where(family == Family::full_block, name_of(instance.mesh)),
      where(family == Family::full_block, name_of(instance.counter))};
}

InstanceFilter::InstanceFilter(const std::string& words) {
  const std::size_t equals = words.find('=');
  if (equals != std::string::npos)
    axis_ = words.substr(0, equals);
  label_ = equals == std::string::npos ? words : words.substr(equals + 1);
  if (words.empty())
    return;
  std::vector<std::string> known;
  for (const Axis& axis : axes()) {
    if (!axis_.empty() && axis.name != axis_)
      continue;
    for (const std::string& label : axis.labels) {
      if (label == label_)
        return;
      known.push_back(axis.name + "=" + label);
    }
  }
  if (known.empty())
    for (const Axis& axis : axes())
      known.push_back(axis.name + "=...");
  throw std::domain_error(fmt::format("only = {}, but must be one of: {}",
                                      words, fmt::join(known, ", ")));
}

bool InstanceFilter::takes(const Instance& instance) const {
  if (label_.empty())
    return true;
  const std::vector<std::string> labels = labels_of(instance);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == label_ && (axis_.empty() || axes()[i].name == axis_))
      return true;
  return false;
}

} // namespace asperity::robustness
