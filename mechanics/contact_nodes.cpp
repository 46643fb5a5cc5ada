#include "mechanics/contact_nodes.hpp"

namespace asperity::mechanics {

std::vector<std::uint8_t> ContactNodes::contact_set() const {
  std::vector<std::uint8_t> set(size());
  for (std::size_t i = 0; i < set.size(); ++i)
    set[i] = in_contact(i) ? 1 : 0;
  return set;
}

std::vector<std::uint8_t> ContactNodes::open_set() const {
  std::vector<std::uint8_t> set(size());
  for (std::size_t i = 0; i < set.size(); ++i)
    set[i] = is_open(i) ? 1 : 0;
  return set;
}

std::vector<double> ContactNodes::open_gaps() const {
  std::vector<double> open(size());
  for (std::size_t i = 0; i < open.size(); ++i)
    if (is_open(i))
      open[i] = gap_[i];
  return open;
}

} // namespace asperity::mechanics
