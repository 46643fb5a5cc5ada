#include "fem/multigrid/contact_pairs.hpp"

namespace asperity::fem {

template <class Number>
double ContactPairs::on_face(std::size_t pair,
                             const Number* displacement) const {
  double sum = 0.0;
  for (std::size_t i = faces.start[pair]; i < faces.start[pair + 1]; ++i)
    sum += faces.weight[i] * static_cast<double>(displacement[faces.column[i]]);
  return sum;
}

template <class Number>
void ContactPairs::add_common(Number* displacement) const {
  if (!exist)
    return;
  if (ghosts != nullptr)
    ghosts->fill_ghosts(displacement);
  for (std::size_t pair = 0; pair < nodes.size(); ++pair)
    displacement[nodes[pair]] +=
        static_cast<Number>(on_face(pair, displacement));
}

template <class Number>
void ContactPairs::add_to_faces(Number* force) const {
  if (!exist)
    return;
  for (std::size_t pair = 0; pair < nodes.size(); ++pair)
    for (std::size_t i = faces.start[pair]; i < faces.start[pair + 1]; ++i)
      force[faces.column[i]] += static_cast<Number>(
          faces.weight[i] * static_cast<double>(force[nodes[pair]]));
  if (ghosts != nullptr)
    ghosts->add_to_owners(force);
}

void ContactPairs::add_spring_force(const double* displacement,
                                    double* force) const {
  for (std::size_t pair = 0; pair < nodes.size(); ++pair) {
    const double own = springs[pair] * (displacement[nodes[pair]] -
                                        on_face(pair, displacement));
    force[nodes[pair]] += own;
    for (std::size_t i = faces.start[pair]; i < faces.start[pair + 1]; ++i)
      force[faces.column[i]] -= faces.weight[i] * own;
  }
}

template void ContactPairs::add_common(float*) const;
template void ContactPairs::add_common(double*) const;
template void ContactPairs::add_to_faces(float*) const;
template void ContactPairs::add_to_faces(double*) const;

} // namespace asperity::fem
