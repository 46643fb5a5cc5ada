#include "input/reader/read_case.hpp"
#include "input/reader/read_parts.hpp"

#include <boost/math/special_functions/erf.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace asperity::cases {
namespace {

/// The words of load.sweep.spacing.
enum class Spacing { log, linear, area };

/// Largest pressure of equally spaced areas [E* h'], at which the area differs
/// by 2e-9 from full contact.
constexpr double highest_by_area = 3.0;

/// Contact area at a pressure [E* h'], Eq. (4) of Yang and Persson (2008) on
/// all scales.
double contact_area(double pressure) {
  return std::erf(std::numbers::sqrt2 * pressure);
}

double interpolated(double from, double to, double fraction, Spacing spacing) {
  if (fraction == 0.0)
    return from;
  if (fraction == 1.0)
    return to;
  const auto by_ratio = [&](double first, double last) {
    return first * std::pow(last / first, fraction);
  };
  switch (spacing) {
  case Spacing::log:
    return by_ratio(from, to);
  case Spacing::area:
    return boost::math::erf_inv(
               by_ratio(contact_area(from), contact_area(to))) /
           std::numbers::sqrt2;
  case Spacing::linear:
    break;
  }
  return from + (to - from) * fraction;
}

std::vector<mechanics::Quantity> read_sweep(TableReader part, const Key& key) {
  const Node* const from_node = part.entry("from");
  const Node* const to_node = part.entry("to");
  const mechanics::Quantity from =
      from_node ? part.quantity_in(*from_node, key) : mechanics::Quantity{};
  const mechanics::Quantity to =
      to_node ? part.quantity_in(*to_node, key) : mechanics::Quantity{};
  const int steps = part.integer("steps");
  const std::optional<int> word = part.word("spacing");
  const bool are_positive = from.value > 0.0 && to.value > 0.0;
  if (!from_node || !to_node || steps < 2 || !word ||
      !(are_positive || key.range.contains(0.0)))
    return {};
  const auto spacing = static_cast<Spacing>(*word);
  if (spacing != Spacing::linear && !are_positive) {
    part.refuse(from.value > 0.0 ? *to_node : *from_node,
                "must be > 0, or needs spacing = \"linear\"");
    return {};
  }
  if (from.reference != to.reference) {
    part.refuse(
        *to_node,
        "must have the same kind of unit as from: both in SI or both in " +
            std::string("the same unit of the problem"));
    return {};
  }
  if (spacing == Spacing::area) {
    if (from.reference !=
        mechanics::ReferenceUnit::contact_modulus_times_slope) {
      part.refuse(*from_node, "spacing = \"area\" needs pressures in E* h'");
      return {};
    }
    for (const auto& [end, value] :
         {std::pair(from_node, from.value), std::pair(to_node, to.value)})
      if (value > highest_by_area) {
        part.refuse(*end,
                    fmt::format("spacing = \"area\" needs pressures of at "
                                "most {} E* h', where contact is complete",
                                highest_by_area));
        return {};
      }
  }
  std::vector<mechanics::Quantity> targets;
  targets.reserve(static_cast<std::size_t>(steps));
  for (int step = 0; step < steps; ++step)
    targets.push_back(
        {interpolated(from.value, to.value,
                      static_cast<double>(step) / (steps - 1), spacing),
         from.reference});
  return targets;
}

enum class Cycle { load, load_unload };

/// Whether the answer at a load depends on the loads before it.
bool remembers_loads(const MethodSpec& method) {
  const auto* const fem = method.as<mechanics::FemSettings>();
  return method.is_adhesive() || method.hardness() ||
         (fem != nullptr && fem->full.yield_stress) ||
         std::holds_alternative<mechanics::MdSettings>(method.settings);
}

/// The steps of a list that are lighter than an earlier one. Loads in other
/// units than the first are compared when the surface is known, and not here.
std::vector<bool> lighter_steps(const mechanics::LoadingPath& program) {
  const double sign =
      program.control == mechanics::Control::nominal_pressure ? 1.0 : -1.0;
  std::vector<bool> lighter;
  double heaviest = -std::numeric_limits<double>::infinity();
  for (const mechanics::Quantity& target : program.targets) {
    const bool is_comparable =
        target.value == 0.0 ||
        target.reference == program.targets.front().reference;
    const double weight = sign * target.value;
    lighter.push_back(is_comparable && weight < heaviest);
    if (is_comparable)
      heaviest = std::max(heaviest, weight);
  }
  return lighter;
}

void append_way_back(mechanics::LoadingPath& program) {
  for (std::size_t step = program.targets.size(); step-- > 1;) {
    program.targets.push_back(program.targets[step - 1]);
    program.is_unloading.push_back(true);
  }
}

} // namespace

std::vector<mechanics::Quantity> read_targets(TableReader& table,
                                              const Key& key) {
  const Node& found = *table.node().find(key.name);
  if (found.is_table())
    return read_sweep(table.part(found, "load.sweep"), key);
  if (found.type != NodeType::list)
    return {table.quantity_in(found, key)};
  if (found.list.empty())
    table.refuse(found, "must be " + allowed_text(key));
  std::vector<mechanics::Quantity> targets;
  for (const Node& element : found.list)
    targets.push_back(table.quantity_in(element, key));
  return targets;
}

void read_pressures(TableReader& load, const Key& key,
                    mechanics::LoadingPath& program) {
  Key own = key;
  if (!program.may_be_tensile) {
    own.range = positive();
    own.range.reason = ", unless all methods have adhesion, none of them [md]";
  }
  program.targets = read_targets(load, own);
}

void read_gaps(TableReader& load, const Key& key,
               mechanics::LoadingPath& program) {
  Key own = key;
  if (!load.has("spring"))
    own.range = positive();
  program.targets = read_targets(load, own);
}

mechanics::LoadingPath read_load(TableReader load,
                                 const std::vector<MethodSpec>& methods) {
  mechanics::LoadingPath program;
  program.may_be_tensile =
      std::ranges::all_of(methods, [](const MethodSpec& method) {
        return method.is_adhesive() && method.contact() != nullptr;
      });
  if (load.has("nominal_pressure") && load.has("mean_gap"))
    load.refuse_both("nominal_pressure", "mean_gap");
  if (load.has("mean_gap"))
    program.control = mechanics::Control::mean_gap;
  else if (!load.has("nominal_pressure"))
    load.complain_missing("nominal_pressure", " (or mean_gap)");
  load.read(program);
  if (program.spring && program.control != mechanics::Control::mean_gap)
    load.refuse(load.said_by("spring"), "needs mean_gap");
  else if (program.spring && !program.may_be_tensile)
    load.refuse(load.said_by("spring"),
                "needs adhesion in all methods, none of them [md]");
  program.is_unloading = std::ranges::any_of(methods, remembers_loads)
                             ? lighter_steps(program)
                             : std::vector<bool>(program.targets.size());
  if (load.choice("cycle", Cycle::load) == Cycle::load_unload)
    append_way_back(program);
  return program;
}

void read_fields(TableReader& report, const Key& key, ReportSpec& spec) {
  const Node& fields = *report.node().find(key.name);
  if (fields.text == "none")
    spec.fields = 0;
  else if (fields.text == "all")
    spec.fields = all_fields;
  else if (fields.type == NodeType::integer)
    spec.fields = report.integer(key.name);
  else
    report.refuse(fields, "must be a whole number, \"none\" or \"all\"");
}

} // namespace asperity::cases
