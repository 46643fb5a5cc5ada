#include "reports/figures/figures.hpp"
#include "reports/study_pages.hpp"

#include <algorithm>

namespace asperity::reports {

std::vector<std::string> figure_names() {
  std::vector<std::string> names = {"adhesion-loop",
                                    "area-coefficient",
                                    "area-pressure",
                                    "area-theory",
                                    "cost",
                                    "exact-area",
                                    "exact-gap",
                                    "gap-deviation",
                                    "gap-distribution-",
                                    "height-distribution",
                                    "maps-",
                                    "plastic-area",
                                    "pressure-difference-",
                                    "pressure-distribution-",
                                    "pressure-gap",
                                    "spectrum",
                                    "stress-inside",
                                    "stress-section-",
                                    "surface",
                                    "two-faces"};
  for (const StudyPages* const study : study_pages())
    names.insert(names.end(), study->figure_names.begin(),
                 study->figure_names.end());
  return names;
}

bool is_figure_name(const std::string& name) {
  const std::vector<std::string> names = figure_names();
  return std::ranges::any_of(names, [&](const std::string& known) {
    return known.ends_with('-')
               ? name.size() > known.size() && name.starts_with(known)
               : name == known;
  });
}

} // namespace asperity::reports
