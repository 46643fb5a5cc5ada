// The range that the vocabulary documents for a number is the one that commands
// enforce: just inside each end a case can be planned, just outside it is
// refused with its key. Expected values are those of the vocabulary itself; the
// solvers' own limits are asked by the plan.
#include "base/require.hpp"
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "input/reader/vocabulary.hpp"
#include "run/plan/plan.hpp"
#include "run/plan/run_options.hpp"
#include "tests/folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace asperity::run::key_ranges_test {

using cases::Key;
using cases::Table;
using cases::ValueType;
using Entries = std::vector<std::string>;

constexpr const char* rough = R"(schema = 1
[surface]
kind = "self-affine"
length = "10 um"
points = 64
seed = 7
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "1 length"
wavelength_short = "0.5 length"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = "0.01 E*"
)";

const Entries block{"fem.contact=hard", "fem.solver=full"};
const Entries adaptive{"fem.contact=hard", "fem.solver=full",
                       "mesh.kind=adaptive"};
const Entries atoms{
    "md.interaction_energy=74.4 meV", "md.interaction_distance=3.28 angstrom",
    "md.cutoff=10 angstrom", "md.contact_distance=4.3615 angstrom"};
const Entries moving{"md.bulk=explicit",     "md.minimizer=dynamics",
                     "md.mass=197 u",        "md.time_step=10 fs",
                     "md.damping=0.5 1/ps",  "md.duration=200 ps",
                     "md.temperature=300 K", "md.seed=1"};
const Entries theory{"theory.gamma=0.4"};
const Entries magnified{
    "theory.gamma=0.4",
    "magnification={ nominal_pressure = 1e6, from = 1.0, to "
    "= 10.0, points = 3 }"};
const Entries leaking{
    "magnification.leak={ density = 1000.0, viscosity = 1e-3, "
    "pressure_drop = 1e4 }"};
const Entries adhesive{"theory.gamma=0.4",
                       "adhesion={ work_of_adhesion = 0.1, from = 0.5, to = "
                       "1.5, points = 3 }"};
const Entries varied{
    "material.variation={ kind = \"random\", spread = 0.5, seed "
    "= 1 }"};
const Entries second_body{"material.counter={ youngs_modulus = 1e9, "
                          "poisson_ratio = 0.3 }"};
const Entries ball{
    "material.inclusion={ radius = \"0.1 length\", depth = \"0.3 "
    "length\", youngs_modulus = 1e9, poisson_ratio = 0.3 }"};

Entries both(Entries one, const Entries& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

/// What makes the keys of a table valid.
Entries surroundings_of(const std::string& table) {
  static const std::map<std::string, Entries> entries{
      {"theory", theory},
      {"halfspace", {"halfspace.contact=hard"}},
      {"fem", block},
      {"md", atoms},
      {"winkler", {"winkler.stiffness=0.1 E*/h"}},
      {"mesh", adaptive},
      {"mesh.counter",
       {"fem.contact=augmented", "fem.penalty=100 E*/h", "fem.solver=full",
        "fem.bodies=2", second_body.front(), "mesh.kind=layers",
        "mesh.counter={ shape = \"cylinder\", radius = \"0.2 length\" }"}},
      {"magnification", magnified},
      {"magnification.leak", both(magnified, leaking)},
      {"adhesion", adhesive},
      {"flow",
       {"halfspace.contact=hard",
        "flow={ viscosity = 1e-3, pressure_drop = 1e4, length = 1e-3, width = "
        "1e-2 }"}},
      {"friction",
       {"halfspace.contact=hard", "material.poisson_ratio=0.3",
        "friction={ coefficient = 0.5, tangential_load = 0.5 }"}},
      {"conductance",
       {"halfspace.contact=hard",
        "conductance={ thermal_conductivity = 1.0, "
        "counter_thermal_conductivity = 1.0, resistivity = 1.0, "
        "counter_resistivity = 1.0, gap_conductivity = 0.1, smallest_gap = "
        "1e-9 }"}},
      {"material", block},
      {"material.counter", both(block, second_body)},
      {"material.inclusion", both(block, ball)},
      {"material.variation", both(block, varied)}};
  const auto found = entries.find(table);
  return found == entries.end() ? Entries{"halfspace.contact=hard"}
                                : found->second;
}

/// A surface of the first kind that has the key; none for the self-affine one,
/// which is small where only small full blocks take all numbers.
Entries surface_of(const Key& key) {
  if (key.name == "poisson_ratio")
    return {"surface.points=8"};
  static const std::map<std::string, Entries> entries{
      {"measured",
       {"surface={ kind = \"measured\", file = \"map.txt\", length = 1e-5, "
        "height_unit = 1e-9, level = \"none\", edges = \"periodic\" }"}},
      {"punch",
       {"surface={ kind = \"punch\", length = 1e-5, points = 64, radius = "
        "1e-6, recess = 1e-6 }"}},
      {"cone",
       {"surface={ kind = \"cone\", length = 1e-5, points = 64, slope = 0.1 "
        "}"}},
      {"rounded-punch",
       {"surface={ kind = \"rounded-punch\", length = 1e-5, points = 64, "
        "radius "
        "= 1e-6, edge_radius = 1e-4 }"}},
      {"sphere",
       {"surface={ kind = \"sphere\", length = 1e-5, points = 64, radius = "
        "1e-3 }"}},
      {"wave-1d",
       {"surface={ kind = \"wave-1d\", length = 1e-5, points = 64, amplitude "
        "= 1e-7, wavelength = 1e-5 }"}}};
  const auto found =
      key.kinds.empty() ? entries.end() : entries.find(key.kinds.front());
  return found == entries.end() ? Entries{} : found->second;
}

/// What else a value needs.
Entries extras_of(const std::string& path, double value) {
  if (path == "fem.bodies" && value > 1.0)
    return both(second_body, {"fem.contact=augmented", "fem.penalty=100 E*/h"});
  if (path == "mesh.interface_halvings")
    return {"mesh.halvings=12", "surface.points=16384"};
  if (path == "mesh.cells_a_level")
    return {"mesh.kind=hanging"};
  if (path == "md.levels")
    return {"md.bulk=explicit", "md.atoms=16384"};
  if (path == "md.damping" || path == "md.duration")
    return moving;
  if (path == "md.temperature" && value > 0.0)
    return moving;
  if (path == "mesh.halvings")
    return {value > 6.0 ? "surface.points=16384" : "surface.points=64"};
  if (path == "surface.points" && value < 8.0)
    return {"surface.wavelength_short=0.75 length"};
  if (path == "surface.rms_height")
    return {"surface.rms_slope="};
  return {};
}

class KeyRanges : public tests::FolderTest {
protected:
  KeyRanges() {
    write_map("map.txt", 16);
    write_map("odd.txt", 15);
  }

  void write_map(const char* name, int points) const {
    std::ofstream map(folder / name);
    for (int row = 0; row < points; ++row) {
      for (int column = 0; column < points; ++column)
        map << (row * 7 + column * column) % 11 << " ";
      map << "\n";
    }
  }

  /// The mistakes of a case with this value; "" if it can be planned.
  std::string answer(const std::string& path, const std::string& table,
                     const std::string& entry, double value,
                     const Entries& surface = {}) const {
    Entries entries = both(surroundings_of(table), surface);
    entries = both(entries, extras_of(path, value));
    entries.push_back(entry);
    try {
      const cases::Case contact_case = cases::read_case_text(
          rough, (folder / "case.toml").string(), entries);
      make_plan(contact_case, {folder / "out", {}, false, 1});
      return "";
    } catch (const input::InputError& error) {
      return error.what();
    } catch (const std::domain_error& error) {
      return std::string("without a place: ") + error.what();
    }
  }
};

bool is_number(const Key& key) {
  return key.type == ValueType::quantity || key.type == ValueType::integer ||
         key.type == ValueType::program || key.type == ValueType::fields;
}

std::string text_of(const Key& key, double value) {
  if (key.type == ValueType::integer || key.type == ValueType::fields)
    return fmt::format("{:.0f}", value);
  const std::string text = number_text(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// An end of a range, and the values next to it.
struct End {
  double inside, outside;
};

std::vector<End> ends_of(const Key& key) {
  const bool is_whole =
      key.type == ValueType::integer || key.type == ValueType::fields;
  const auto step = [&](double end) {
    return is_whole ? 1.0 : 1e-6 * std::max(std::abs(end), 1e-3);
  };
  std::vector<End> ends;
  const cases::Range& range = key.range;
  if (std::isfinite(range.low))
    ends.push_back(
        {range.is_low_allowed ? range.low : range.low + step(range.low),
         range.is_low_allowed ? range.low - step(range.low) : range.low});
  if (std::isfinite(range.high))
    ends.push_back(
        {range.is_high_allowed ? range.high : range.high - step(range.high),
         range.is_high_allowed ? range.high + step(range.high) : range.high});
  return ends;
}

TEST_F(KeyRanges, AreThoseThatAPlanEnforces) {
  int n_ends = 0;
  for (const Table& table : cases::vocabulary())
    for (const Key& key : table.keys) {
      if (table.is_part || !is_number(key))
        continue;
      const std::string path =
          table.name.empty() ? key.name : table.name + "." + key.name;
      const bool is_bounded =
          std::isfinite(key.range.high) ||
          (key.range.is_low_allowed && std::isfinite(key.range.low));
      for (const End& end : ends_of(key)) {
        const auto entry = [&](double value) {
          return path + "=" + text_of(key, value);
        };
        const std::string refused = answer(path, table.name, entry(end.outside),
                                           end.outside, surface_of(key));
        EXPECT_NE(refused.find(path + " = "), std::string::npos)
            << entry(end.outside) << " is not refused: " << refused;
        EXPECT_NE(refused.find("must "), std::string::npos)
            << entry(end.outside) << ": " << refused;
        ++n_ends;
        if (is_bounded) { // other lengths have the limits of their unit
          EXPECT_EQ(answer(path, table.name, entry(end.inside), end.inside,
                           surface_of(key)),
                    "")
              << entry(end.inside);
        }
      }
    }

  EXPECT_GT(n_ends, 100);
}

// A key that no reader asks for would be accepted whatever its value: each one
// refuses a date, which no key takes.
TEST_F(KeyRanges, AreOfKeysThatAreRead) {
  const std::map<std::string, std::string> kinds{
      {"factor", "function"}, {"file", "table"}, {"edge", "random"}};
  for (const Table& table : cases::vocabulary())
    for (const Key& key : table.keys) {
      if (table.is_part || table.name == "sweep")
        continue;
      const std::string path =
          table.name.empty() ? key.name : table.name + "." + key.name;
      Entries surface = surface_of(key);
      if (const auto kind = kinds.find(key.name);
          table.name == "material.variation" && kind != kinds.end())
        surface.push_back("material.variation.kind=" + kind->second);
      if (path == "mesh.file")
        surface = {"mesh.kind=gmsh", "mesh.geometry=file"};
      const std::string refused =
          answer(path, table.name, path + "=1979-05-27", 0.0, surface);
      EXPECT_NE(refused.find("--set: " + path + " "), std::string::npos)
          << path << ": " << refused;
    }
}

// A number that no range of its own excludes, but the block.
TEST_F(KeyRanges, SayWhichKeyOfABlockDoesNotFit) {
  const auto says = [&](const std::string& entry, const std::string& table) {
    return answer("", table, entry, 0.0);
  };

  EXPECT_NE(
      says("fem.depth=0.001 length", "fem")
          .find("fem.depth = \"0.001 length\", which is 1e-08, but must be "
                "at least the thickness of the surface layer"),
      std::string::npos)
      << says("fem.depth=0.001 length", "fem");
  EXPECT_NE(
      says("material.layers=[{ thickness = \"2 length\", youngs_modulus = "
           "1e9, poisson_ratio = 0.3 }]",
           "fem")
          .find("material.layers = "),
      std::string::npos);
  EXPECT_NE(
      says("material.variation={ kind = \"function\", factor = \"0.5 - x\" "
           "}",
           "material.variation")
          .find("material.variation.factor = \"0.5 - x\": fem: "),
      std::string::npos)
      << says(
             "material.variation={ kind = \"function\", factor = \"0.5 - x\" }",
             "material.variation");
  EXPECT_NE(
      says("surface={ kind = \"measured\", file = \"odd.txt\", length = 1e-5, "
           "height_unit = 1e-9, level = \"none\", edges = \"periodic\" }",
           "fem")
          .find("surface.file = \"odd.txt\": fem: points = 15, but must be a "
                "multiple of 2"),
      std::string::npos);
  EXPECT_NE(says("material.inclusion.depth=3 length", "material.inclusion")
                .find("material.inclusion.depth = \"3 length\": "),
            std::string::npos);

  struct Misfit {
    std::string table, entry, other, words;
  };

  for (const Misfit& one : std::vector<Misfit>{
           {"fem", "fem.depth=1e4 length", "fem.growth=1",
            "fem.depth = \"1e4 length\""},
           {"halfspace", "halfspace.thickness=0.1 length",
            "material.layers=[{ thickness = \"0.2 length\", youngs_modulus = "
            "1e9, poisson_ratio = 0.3 }]",
            "halfspace.thickness = \"0.1 length\""},
           {"fem", "mesh.size_far=0.001 length", "mesh.kind=gmsh",
            "mesh.size_far = \"0.001 length\", which is "},
           {"fem", "material.inclusion.radius=0.6 length",
            "mesh={ kind = \"gmsh\", geometry = \"inclusion\" }",
            "material.inclusion.radius = \"0.6 length\": fem: "
            "inclusion_radius"},
           {"halfspace", "surface.points=8", "surface.wavelength_short=2 h",
            "surface.points = 8, but must be >= 10 to resolve"}}) {
    Entries others{one.other};
    if (one.entry.starts_with("material.inclusion"))
      others.push_back("material.inclusion={ depth = \"0.7 length\", "
                       "youngs_modulus = 1e9, poisson_ratio = 0.3 }");
    const std::string found = answer("", one.table, one.entry, 0.0, others);
    EXPECT_NE(found.find(one.words), std::string::npos) << found;
  }
}

} // namespace asperity::run::key_ranges_test
