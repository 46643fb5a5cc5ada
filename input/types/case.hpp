#pragma once

// A case after it has been read: plain data in SI units, independent of TOML.
// It consists of the physical problem (mechanics/), the methods that solve it,
// and what is computed, saved and expected besides.

#include "input/text/node.hpp"
#include "input/types/methods.hpp"
#include "mechanics/loading.hpp"
#include "mechanics/material.hpp"
#include "mechanics/mesh_spec.hpp"
#include "mechanics/surface_spec.hpp"

#include <any>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

namespace asperity::cases {

/// [report]: what a result contains besides the curves.
struct ReportSpec {
  /// Number of load steps, spread over the loading path, whose pressure and gap
  /// maps (of realisation 0) are saved.
  int fields = 3;
  /// Save the pressure maps in double precision instead of single.
  bool has_double_maps = false;
  /// Compute the subsurface stress for each saved pressure map.
  bool stress_inside = false;
  /// Write the solution of the full block for ParaView at each step whose
  /// fields are saved.
  bool vtu = false;
};

/// One entry of [expect]: the quantity must lie in low..high for each method.
struct Expectation {
  std::string quantity; ///< one of expectation_names(), or one at a load
  double low = 0.0;
  double high = 0.0;
  std::vector<std::string> methods; ///< names of methods of this case
  /// Whether a value whose 95 % interval crosses a limit of the band counts as
  /// passed.
  bool passes_if_undecided = false;
};

/// The settings of the studies that a case asks for, each of a type of its own
/// (studies/).
class AskedStudies {
public:
  template <class Study>
  Study& ask(Study settings) {
    std::any& place = settings_[typeid(Study)];
    place = std::move(settings);
    return *std::any_cast<Study>(&place);
  }

  /// Returns the settings, or null if the study is not asked for.
  template <class Study>
  const Study* find() const {
    const auto found = settings_.find(typeid(Study));
    return found == settings_.end() ? nullptr
                                    : std::any_cast<Study>(&found->second);
  }

private:
  std::map<std::type_index, std::any> settings_;
};

struct Case {
  std::string path; ///< as given by the user, for messages
  std::string text; ///< the file byte for byte, then one line
                    ///< "#--set key=value" per override; reading it again
                    ///< gives the same case
  /// The text, parsed once when it is read, with its overrides applied: what is
  /// asked of the keys as they are written.
  std::shared_ptr<const Node> file = std::make_shared<const Node>();
  std::string name; ///< from the folder or file, e.g. "polymer"
  std::string title;
  mechanics::SurfaceSpec surface;
  mechanics::MaterialSpec material;
  mechanics::MeshSpec mesh;
  mechanics::LoadingPath load;
  std::vector<MethodSpec> methods; ///< theory, halfspace, fem, md, then
                                   ///< variants
  AskedStudies studies;
  ReportSpec report;
  std::vector<Expectation> expectations;

  /// The settings of a study, or null if the case does not ask for it.
  template <class Study>
  const Study* study() const {
    return studies.find<Study>();
  }
};

/// Returns why partial slip does not follow from the normal contact of a
/// method, as "needs ..."; "" for a theory and for a uniform half-space, both
/// without adhesion and hardness.
std::string obstacle_to_partial_slip(const MethodSpec& method,
                                     const mechanics::MaterialSpec& material);

/// Returns whether there is no such obstacle.
bool has_partial_slip(const MethodSpec& method,
                      const mechanics::MaterialSpec& material);

/// Returns the theory that evaluates the studies: the first one that uses the
/// formula of the spectrum, or the first one if the surface is measured; null
/// if there is none.
const MethodSpec* study_theory(const mechanics::SurfaceSpec& surface,
                               const std::vector<MethodSpec>& methods);

} // namespace asperity::cases
