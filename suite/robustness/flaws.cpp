#include "suite/robustness/flaws.hpp"

#include "base/special_numbers.hpp"

#include <algorithm>

namespace asperity::robustness {
namespace {

/// A mistake as an entry of --set, "*." being the table of the method.
struct FlawedKey {
  const char* name;
  const char* override;

  enum Needs { any, block, elements } needs = any;
};

constexpr FlawedKey flaws[] = {
    {"nan-in-map", "surface.file=map.txt"},
    {"infinity-in-map", "surface.file=map.txt"},
    {"nan-length", "surface.length=nan"},
    {"zero-load", "load.nominal_pressure=[0.0]"},
    {"negative-load", "load.nominal_pressure=[-1.0]"},
    {"infinite-load", "load.nominal_pressure=[inf]"},
    {"nan-load", "load.nominal_pressure=[nan]"},
    {"closed-wall-gap", "load.mean_gap=[0.0]"},
    {"zero-penalty", "*.penalty=0.0"},
    {"infinite-penalty", "*.penalty=inf"},
    {"nan-penalty", "*.penalty=nan"},
    {"zero-tolerance", "*.tolerance=0.0"},
    {"nan-tolerance", "*.tolerance=nan"},
    {"zero-modulus", "material.contact_modulus=0.0"},
    {"nan-modulus", "material.contact_modulus=nan"},
    {"infinite-modulus", "material.contact_modulus=inf"},
    {"nan-poisson-ratio", "material.poisson_ratio=nan", FlawedKey::block},
    {"nan-thickness", "halfspace.thickness=nan", FlawedKey::block},
    {"incompressible", "material.poisson_ratio=0.5", FlawedKey::elements},
    {"shrinking-layers", "fem.growth=0.5", FlawedKey::elements},
    {"sliver", "fem.depth=0.001 h", FlawedKey::elements},
    {"odd-q2-grid", "surface.file=map.txt", FlawedKey::elements},
};

const FlawedKey& flaw_of(const std::string& name) {
  return *std::ranges::find_if(
      flaws, [&](const FlawedKey& flaw) { return flaw.name == name; });
}

/// A map with one height that is not finite, or with an odd number of points.
surfaces::HeightMap spoilt_map(const std::string& flaw,
                               const Instance& instance) {
  const int points = flaw == "odd-q2-grid" ? 9 : 8;
  surfaces::HeightMap map{{points, points, 1.0, 1.0}, {}};
  for (int i = 0; i < points * points; ++i)
    map.heights.push_back((i * 5) % 7);
  double& height = map.heights[static_cast<std::size_t>(instance.index) %
                               map.heights.size()];
  if (flaw == "nan-in-map")
    height = not_a_number;
  if (flaw == "infinity-in-map")
    height = instance.index % 3 == 0 ? -infinity : infinity;
  return map;
}

} // namespace

std::vector<std::string> flaw_names() {
  std::vector<std::string> names;
  for (const FlawedKey& flaw : flaws)
    names.emplace_back(flaw.name);
  return names;
}

bool needs_elements(const std::string& flaw) {
  return flaw_of(flaw).needs == FlawedKey::elements;
}

bool needs_block(const std::string& flaw) {
  return flaw_of(flaw).needs == FlawedKey::block;
}

/// The rest of the case is kept as simple as the mistake allows.
void spoil(const std::string& name, const Draft& draft, Instance& instance) {
  const std::string method = instance.method + ".";
  std::vector<std::string>& overrides = instance.overrides;
  if (name.ends_with("load"))
    overrides.emplace_back("load={ nominal_pressure = [1.0] }");
  if (name == "closed-wall-gap")
    overrides.insert(overrides.end(),
                     {"load={ mean_gap = [1.0] }", method + "contact=hard"});
  if (name.ends_with("penalty"))
    overrides.push_back(method + "contact=penalty");
  std::string entry = flaw_of(name).override;
  if (entry == "surface.file=map.txt") {
    instance.map = spoilt_map(name, instance);
    overrides.push_back("surface={ kind = \"measured\", file = \"map.txt\", "
                        "format = \"plain\", level = \"none\", fill = "
                        "\"none\", edges = \"periodic\", height_unit = 1e-3, "
                        "length = " +
                        draft.length(1.0) + " }");
    return;
  }
  if (entry.starts_with("*."))
    entry = method + entry.substr(2);
  overrides.push_back(entry);
}

} // namespace asperity::robustness
