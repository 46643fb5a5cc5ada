#include "mechanics/counter_body.hpp"

#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::mechanics {
namespace {

using Mistake = std::optional<CounterMistake>;

Mistake check_between(const char* key, double value, double low, double high) {
  if (value >= low && value <= high)
    return {};
  return CounterMistake{key, value,
                        fmt::format("between {} and {} [m]", number_text(low),
                                    number_text(high))};
}

Mistake check_least(const char* key, double value, double least,
                    const char* what) {
  if (value >= least)
    return {};
  return CounterMistake{
      key, value, fmt::format("at least {} [m], {}", number_text(least), what)};
}

Mistake check_positive(const char* key, double value) {
  if (std::isfinite(value) && value > 0.0)
    return {};
  return CounterMistake{key, value, "finite and > 0 [m]"};
}

/// Half the width of the widest fine region [m].
double widest_fine_region(const CounterBody& body) {
  return body.shape == CounterShape::sphere ? 0.4 * half_width(body)
                                            : body.radius;
}

/// The cells of the fine region. Without their size only the region is checked.
Mistake mistake_in_cells(const CounterBody& body) {
  const double size = body.size_at_contact;
  const double widest = widest_fine_region(body);
  if (size == 0.0)
    return check_between("fine_radius", body.fine_radius, 0.0, widest);
  if (Mistake found = check_positive("size_at_contact", size))
    return found;
  if (Mistake found = check_between("size_at_contact", size, 0.0,
                                    std::min(widest, body.height)))
    return found;
  if (Mistake found =
          check_between("fine_radius", body.fine_radius, size, widest))
    return found;
  if (Mistake found = check_least("size_far", body.size_far, size,
                                  "the size of the cells at the contact"))
    return found;
  constexpr double most_cells = 1e7;
  return check_least("size_at_contact", size,
                     body.fine_radius / std::cbrt(most_cells),
                     "the fine_radius over the cube root of 1e7, the largest "
                     "number of cells of a quarter of the fine region");
}

} // namespace

double half_width(const CounterBody& body) {
  if (body.shape != CounterShape::sphere)
    return body.radius;
  const double below = body.radius - body.height;
  return std::sqrt(
      std::max(0.0, (body.radius - below) * (body.radius + below)));
}

CounterBody counter_body_of(const CounterMeshSpec& spec, const Scales& scales,
                            const OpposedBlock& block) {
  CounterBody body;
  body.shape = spec.shape;
  body.radius = spec.radius.in_si(scales);
  body.height = spec.height ? spec.height->in_si(scales) : body.radius;
  body.size_at_contact =
      spec.size_at_contact ? spec.size_at_contact->in_si(scales) : block.edge;
  body.size_far = std::max(spec.size_far.in_si(scales), body.size_at_contact);
  const double share = spec.shape == CounterShape::sphere ? 0.25 : 1.0;
  body.fine_radius =
      spec.fine_radius ? spec.fine_radius->in_si(scales) : share * body.radius;
  body.centre_x = 0.5 * block.length_x + spec.offset_x.in_si(scales);
  body.centre_y = 0.5 * block.length_y + spec.offset_y.in_si(scales);
  return body;
}

std::optional<CounterMistake> mistake_in(const CounterBody& body) {
  if (Mistake found = check_positive("radius", body.radius))
    return found;
  if (Mistake found = check_positive("height", body.height))
    return found;
  const bool is_sphere = body.shape == CounterShape::sphere;
  if (is_sphere)
    if (Mistake found = check_between("height", body.height, 0.25 * body.radius,
                                      body.radius))
      return found;
  if (Mistake found = mistake_in_cells(body))
    return found;
  if (is_sphere || body.fine_radius < 0.5 * body.radius)
    return check_least("height", body.height, 2.0 * body.fine_radius,
                       "twice the fine_radius");
  return {};
}

std::optional<CounterMistake> mistake_in(const CounterBody& body,
                                         const OpposedBlock& block) {
  // The nodes on periodic sides have their forces on both sides at once.
  constexpr double roundoff = 1e-9;
  const bool is_periodic = block.sides == BlockSides::periodic;
  const auto check = [&](char axis, double offset, double length) -> Mistake {
    const double reach = std::abs(offset) + half_width(body);
    if (reach <= 0.5 * length * (is_periodic ? 1.0 - roundoff : 1.0 + roundoff))
      return {};
    const std::string rule = fmt::format(
        "such that the body, which reaches {} m from the centre of the block "
        "along {}, stays within {} m{}: half of the block",
        number_text(reach), axis, number_text(0.5 * length),
        is_periodic ? " and off its periodic sides" : "");
    if (offset == 0.0)
      return CounterMistake{"radius", body.radius, rule};
    return CounterMistake{fmt::format("offset_{}", axis), offset, rule};
  };
  if (Mistake found =
          check('x', body.centre_x - 0.5 * block.length_x, block.length_x))
    return found;
  if (Mistake found =
          check('y', body.centre_y - 0.5 * block.length_y, block.length_y))
    return found;
  // A finer counter-body would be loaded at single nodes.
  constexpr double finest = 0.9;
  if (block.edge == 0.0 || body.size_at_contact >= finest * block.edge)
    return {};
  return CounterMistake{
      "size_at_contact", body.size_at_contact,
      fmt::format("at least {} m, the edge of the block's cells at the "
                  "contact: contact is tested at the block's nodes, which "
                  "would load a finer counter-body at single nodes",
                  number_text(block.edge))};
}

} // namespace asperity::mechanics
