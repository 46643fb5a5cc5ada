#include "reports/figures/figures.hpp"

#include <algorithm>

namespace asperity::reports {

const std::vector<std::string>& figure_names() {
  static const std::vector<std::string> names = {"adhesion-branches",
                                                 "adhesion-equilibrium",
                                                 "adhesion-height",
                                                 "adhesion-loop",
                                                 "area-coefficient",
                                                 "area-pressure",
                                                 "area-theory",
                                                 "conductance",
                                                 "cost",
                                                 "exact-area",
                                                 "exact-gap",
                                                 "flux-",
                                                 "gap-deviation",
                                                 "gap-distribution-",
                                                 "height-distribution",
                                                 "leak-rate",
                                                 "magnification-opening",
                                                 "magnification-parts",
                                                 "magnification-separation",
                                                 "maps-",
                                                 "partial-slip",
                                                 "plastic-area",
                                                 "pressure-difference-",
                                                 "pressure-distribution-",
                                                 "pressure-gap",
                                                 "separation-distributions-",
                                                 "spectrum",
                                                 "spots-",
                                                 "stress-inside",
                                                 "stress-section-",
                                                 "surface",
                                                 "traction-",
                                                 "two-faces"};
  return names;
}

bool is_figure_name(const std::string& name) {
  return std::ranges::any_of(figure_names(), [&](const std::string& known) {
    return known.ends_with('-')
               ? name.size() > known.size() && name.starts_with(known)
               : name == known;
  });
}

} // namespace asperity::reports
