#include "reports/pages/drawn_groups.hpp"

#include "base/json.hpp"

#include <stdexcept>

namespace asperity::reports {

std::string bytes_of(std::span<const DrawnGroup> groups) {
  using json = nlohmann::ordered_json;
  json list = json::array();
  for (const DrawnGroup& group : groups) {
    json figures = json::array();
    for (const DrawnFigure& figure : group.figures)
      figures.push_back({figure.name, figure.title, figure.caption, figure.svg,
                         figure.problem, figure.explore});
    list.push_back({group.heading, figures});
  }
  std::string bytes;
  json::to_cbor(list, bytes);
  return bytes;
}

std::vector<DrawnGroup> drawn_groups_in(std::string_view bytes) {
  using json = nlohmann::ordered_json;
  try {
    std::vector<DrawnGroup> groups;
    const json list = json::from_cbor(bytes.begin(), bytes.end());
    for (const json& entry : list) {
      DrawnGroup group{entry.at(0), {}};
      for (const json& figure : entry.at(1))
        group.figures.push_back({figure.at(0), figure.at(1), figure.at(2),
                                 figure.at(3), figure.at(4), figure.at(5)});
      groups.push_back(std::move(group));
    }
    return groups;
  } catch (const json::exception& error) {
    throw std::runtime_error(std::string("figures cannot be read: ") +
                             error.what());
  }
}

} // namespace asperity::reports
