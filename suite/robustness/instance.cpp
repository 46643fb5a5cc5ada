#include "suite/robustness/instance.hpp"

#include "input/input_error.hpp"
#include "mechanics/contact_law.hpp"
#include "suite/robustness/flaws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace asperity::robustness {
namespace {

std::string bin_label(const std::vector<double>& edges, std::size_t bin) {
  return bin + 1 < edges.size()
             ? fmt::format("{:g}..{:g}", edges[bin], edges[bin + 1])
             : fmt::format("{:g}..", edges[bin]);
}

/// @param edges  lower ones of the bins, the last of which is unbounded
Axis of_numbers(const std::string& name, const std::vector<double>& edges) {
  Axis axis{name, {}, edges};
  for (std::size_t bin = 0; bin < edges.size(); ++bin)
    axis.labels.push_back(bin_label(edges, bin));
  return axis;
}

std::vector<std::string> law_names() {
  const std::vector<const char*> names = mechanics::contact_law_names();
  return {names.begin(), names.end()};
}

} // namespace

const std::vector<Axis>& axes() {
  static const std::vector<Axis> all{
      {"family",
       {"halfspace", "slab", "condensed-q1", "condensed-q2", "full-block",
        "atoms", "theory", "flawed"}},
      {"shape",
       {"rough", "wave", "paraboloid", "spike", "step", "sawtooth", "terraces",
        "checkerboard"}},
      {"edges", {"periodic", "window", "mirror", "free"}},
      {"realizations", {"1", "2"}},
      {"law", law_names()},
      of_numbers("penalty", {1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12}),
      {"control", {"pressure", "gap"}},
      of_numbers("load", {1e-12, 1e-6, 1e-3, 1e-1, 1.0, 10.0}),
      of_numbers("gap", {0.0, 0.1, 1.0}),
      {"program", {"increments", "jump", "cycle"}},
      {"points", {"8", "16", "24", "32", "48", "64"}},
      {"shortest-wave", {"2", "2.1", "3", "4", "8"}},
      of_numbers("hurst", {0.0, 0.2, 0.5, 0.8, 1.0}),
      of_numbers("rms-slope", {1e-6, 1e-4, 1e-2, 1.0}),
      of_numbers("length", {1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3}),
      of_numbers("modulus", {1.0, 1e3, 1e6, 1e9}),
      {"nu", {"0", "0.3", "0.49", "0.4999"}},
      {"top", {"clamped", "sliding", "pressure"}},
      of_numbers("thickness", {0.01, 0.05, 0.3, 1.0, 3.0}),
      of_numbers("growth", {1.0, 1.5, 2.0, 2.5}),
      {"element", {"Q1", "Q2"}},
      {"coating", {"softer", "none", "stiffer"}},
      {"material-law", {"elastic", "plastic"}},
      {"metamorphic pair",
       {"none", "binary-units", "decimal-units", "threads", "direct-solver"}},
      {"flaw", flaw_names()},
      {"path", {"library", "program", "report", "two-ranks"}},
      {"study", {"none", "flow", "spots", "conductance", "friction"}},
      {"threads", {"1", "2", "3"}},
      {"sides", {"periodic", "free"}},
      {"linear-solver", {"auto", "multigrid"}},
      of_numbers("modulus-ratio", {1.0, 10.0, 100.0}),
      {"mesh", {"layers", "hanging", "adaptive", "gmsh"}},
      {"counter-body", {"none", "sphere", "cylinder", "cuboid"}}};
  return all;
}

std::string bin_of(const std::string& axis, double value) {
  const std::vector<double>& edges =
      std::ranges::find(axes(), axis, &Axis::name)->edges;
  const auto above = std::upper_bound(edges.begin() + 1, edges.end(), value);
  return bin_label(edges, static_cast<std::size_t>(above - edges.begin()) - 1);
}

std::string Instance::label(const std::string& axis) const {
  const auto found = labels.find(axis);
  return found == labels.end() ? std::string() : found->second;
}

std::string text_of_map(const surfaces::HeightMap& map) {
  std::string text;
  for (int iy = 0; iy < map.grid.points_y; ++iy)
    for (int ix = 0; ix < map.grid.points_x; ++ix)
      text += fmt::format("{:.17e}{}", map.heights[map.grid.index(ix, iy)],
                          ix + 1 == map.grid.points_x ? '\n' : ' ');
  return text;
}

std::string text_of(const Instance& instance) {
  std::vector<std::string> words;
  for (const Axis& axis : axes())
    if (const std::string label = instance.label(axis.name); !label.empty())
      words.push_back(axis.name + "=" + label);
  return fmt::format("seed {}, problem instance {}: {}\n{}{}{}", instance.seed,
                     instance.index, fmt::join(words, ", "),
                     instance.file.empty() ? instance.text
                                           : instance.file + "\n",
                     fmt::join(instance.overrides, "\n"),
                     instance.overrides.empty() ? "" : "\n");
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
  return label_.empty() ||
         std::ranges::any_of(instance.labels, [&](const auto& label) {
           return label.second == label_ &&
                  (axis_.empty() || label.first == axis_);
         });
}

InstanceSequence::InstanceSequence(std::function<Instance(int)> draw,
                                   InstanceFilter filter, int first,
                                   std::size_t most)
    : draw_(std::move(draw)),
      filter_(std::move(filter)),
      first_(first),
      next_(first),
      most_(most) {}

const Instance* InstanceSequence::at(std::size_t place) {
  constexpr int most_drawn_for_one = 10000;
  while (drawn_.size() <= place && drawn_.size() < most_ &&
         (next_ - first_) / most_drawn_for_one <=
             static_cast<int>(drawn_.size()))
    if (Instance instance = draw_(next_++); filter_.takes(instance))
      drawn_.push_back(std::move(instance));
  return place < drawn_.size() ? &drawn_[place] : nullptr;
}

void InstanceSequence::release_before(std::size_t place) {
  for (; released_ < place; ++released_)
    drawn_[released_] = Instance{};
}

} // namespace asperity::robustness
