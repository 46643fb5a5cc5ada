#include "meshes/counter_body.hpp"

#include "base/require.hpp"
#include "meshes/facets.hpp"
#include "meshes/mesh_quality.hpp"
#include "meshes/valid_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

namespace asperity::meshes {
namespace {

/// Nodes of the body: those of the fine box (shell 0), and shells around it,
/// which consist of the nodes on its sides and its bottom.
struct BodyNode {
  int shell = 0;
  int i = 0, j = 0; ///< along x and y, 0..across
  int k = 0;        ///< downwards, 0..down

  bool operator<(const BodyNode& other) const {
    return std::tie(shell, i, j, k) <
           std::tie(other.shell, other.i, other.j, other.k);
  }
};

/// The dimensions of the grid of boxes of nodes and their places relative to
/// the highest point.
class BodyPlaces {
public:
  explicit BodyPlaces(const CounterBody& body);

  Place operator()(const BodyNode& node) const;

  int across() const { return across_; }

  int down() const { return static_cast<int>(layers_.size()) - 1; }

  /// Shells on the sides and at the bottom of the box, then those on the sides
  /// only.
  int n_fans() const { return static_cast<int>(fans_.size()) - 1; }

  int n_rings() const { return static_cast<int>(rings_.size()) - 1; }

private:
  void divide_column();
  void divide_fan(double outer);
  void divide_rings(double size);
  double rise(double r) const;
  Place in_box(double u, double v, double depth) const;
  Place on_outside(double u, double v, double w) const;
  Place on_arc(const Place& first, const Place& chord, double share) const;
  Place on_ring(double u, double v, const Place& inside, double share) const;

  CounterBody body_;
  double box_ = 0.0;       ///< half the width of the fine box [m]
  double inner_ = 0.0;     ///< the same of the column inside of the rings [m]
  double roundness_ = 0.0; ///< of the box, 0 for a square
  int across_ = 1;
  std::vector<double> layers_;     ///< depths of the box's layers [m]
  std::vector<double> fans_{0.0};  ///< shares of the way out, 0..1
  std::vector<double> rings_{0.0}; ///< the same of the rings
};

using mechanics::CounterShape;

/// Growth of successive layers of a column.
constexpr double layer_growth = 1.25;

/// Half the width of the box inside a cylinder, over the radius.
constexpr double inner_share = 0.58;

/// How far the sides of that box are bent towards a circle, so that the cells
/// of the ring around it are about as wide at its corners as between them.
constexpr double roundness = 0.5;

/// Half the width of the part of a ball's base that lies below its fine box,
/// over the radius of the base.
constexpr double base_share = 0.5;

/// Positions from 0 to length: steps that begin with `first`, grow by a ratio
/// up to `largest`, and are shortened together to fit.
std::vector<double> graded(double first, double ratio, double largest,
                           double length) {
  std::vector<double> ends{0.0};
  constexpr double roundoff = 1e-9;
  for (double step = first; ends.back() < length * (1.0 - roundoff);
       step = std::min(largest, ratio * step))
    ends.push_back(ends.back() + step);
  const double factor = length / ends.back();
  for (double& end : ends)
    end *= factor;
  return ends;
}

/// The number of cells of at most that size.
int cells_along(double length, double size) {
  constexpr double roundoff = 1e-9;
  return std::max(1, static_cast<int>(std::ceil(length / size - roundoff)));
}

/// The direction, of length one, in which a place on the unit square's boundary
/// is moved to the circle: equal steps on the square become equal angles.
std::array<double, 2> on_circle(double u, double v) {
  constexpr double eighth = std::numbers::pi / 4.0;
  const bool is_along_x = std::abs(u) >= std::abs(v);
  const double angle = eighth * (is_along_x ? v / u : u / v);
  const double sign = (is_along_x ? u : v) < 0.0 ? -1.0 : 1.0;
  const double near = sign * std::cos(angle);
  const double off = sign * std::sin(angle);
  return is_along_x ? std::array<double, 2>{near, off}
                    : std::array<double, 2>{off, near};
}

Place between(const Place& first, const Place& last, double share) {
  return {std::lerp(first[0], last[0], share),
          std::lerp(first[1], last[1], share),
          std::lerp(first[2], last[2], share)};
}

/// The largest half width of a fine box around which the cells of the fans are
/// well shaped [m]. Its corners reach sqrt(2) times as far, and on a ball its
/// bottom is lower by as much as its end.
double widest_fine_box(const CounterBody& body) {
  const double across = body.shape == CounterShape::sphere
                            ? 0.4 * mechanics::half_width(body)
                            : 0.5 * body.radius;
  return std::min(across, 0.5 * body.height);
}

BodyPlaces::BodyPlaces(const CounterBody& body) : body_(body) {
  const bool is_sphere = body.shape == CounterShape::sphere;
  if (!is_sphere && body.fine_radius >= 0.5 * body.radius) {
    divide_column();
    return;
  }
  inner_ = body.shape == CounterShape::cylinder ? inner_share * body.radius
                                                : mechanics::half_width(body);
  divide_fan(is_sphere ? 0.5 * (1.0 + base_share) * inner_ : inner_);
}

void BodyPlaces::divide_column() {
  const bool is_round = body_.shape == CounterShape::cylinder;
  box_ = inner_ = is_round ? inner_share * body_.radius : body_.radius;
  roundness_ = is_round ? roundness : 0.0;
  across_ = cells_along(2.0 * box_, body_.size_at_contact);
  layers_ =
      graded(body_.size_at_contact, layer_growth, body_.size_far, body_.height);
  if (is_round)
    divide_rings(body_.size_at_contact);
}

/// @param outer  half the width up to which the fan widens [m]
void BodyPlaces::divide_fan(double outer) {
  const double size = body_.size_at_contact;
  const double widest = widest_fine_box(body_);
  constexpr double roundoff = 1e-9;
  const int most = static_cast<int>(std::floor(widest / size + roundoff));
  across_ = 2 * std::clamp(cells_along(body_.fine_radius, size), 1,
                           std::max(1, most));
  box_ = 0.5 * across_ * size;
  const int down = across_ / 2;
  for (int k = 0; k <= down; ++k)
    layers_.push_back(box_ * k / down);
  fans_ = graded(size, 1.0 + 2.0 / across_, body_.size_far, outer - box_);
  const double last = fans_.back() - fans_[fans_.size() - 2];
  for (double& share : fans_)
    share /= outer - box_;
  if (body_.shape != CounterShape::cylinder)
    return;
  divide_rings(last);
}

/// Divides the ring by its mean width.
void BodyPlaces::divide_rings(double size) {
  const double corner =
      std::lerp(std::numbers::sqrt2, 1.0, roundness_) * inner_;
  const double width = body_.radius - 0.5 * (inner_ + corner);
  const int n_rings = std::max(1, static_cast<int>(std::lround(width / size)));
  for (int ring = 1; ring <= n_rings; ++ring)
    rings_.push_back(static_cast<double>(ring) / n_rings);
}

/// How far the end falls at a distance r from the axis [m].
double BodyPlaces::rise(double r) const {
  if (body_.shape != CounterShape::sphere)
    return 0.0;
  const double radius = body_.radius;
  return std::min(
      body_.height,
      r * r / (radius + std::sqrt(std::max(0.0, radius * radius - r * r))));
}

/// @param u, v  -1..1 across the box
Place BodyPlaces::in_box(double u, double v, double depth) const {
  const double outermost = std::max(std::abs(u), std::abs(v));
  double x = box_ * u;
  double y = box_ * v;
  if (roundness_ > 0.0 && outermost > 0.0) {
    const auto direction = on_circle(u, v);
    x = std::lerp(x, box_ * outermost * direction[0], roundness_);
    y = std::lerp(y, box_ * outermost * direction[1], roundness_);
  }
  return {x, y, -(rise(std::hypot(x, y)) + depth)};
}

/// The end of the fan for a node on a side (|u| or |v| is 1) or the bottom
/// (w = 1) of the box.
Place BodyPlaces::on_outside(double u, double v, double w) const {
  if (body_.shape != CounterShape::sphere)
    return {inner_ * u, inner_ * v, -body_.height * w};
  const double base = base_share * inner_;
  if (std::max(std::abs(u), std::abs(v)) < 1.0)
    return {base * u, base * v, -body_.height};
  const auto direction = on_circle(u, v);
  return {std::lerp(inner_ * direction[0], base * u, w),
          std::lerp(inner_ * direction[1], base * v, w), -body_.height};
}

/// A node of the ring on the way out from a place on the column inside.
Place BodyPlaces::on_ring(double u, double v, const Place& inside,
                          double share) const {
  const auto direction = on_circle(u, v);
  return {std::lerp(inside[0], body_.radius * direction[0], share),
          std::lerp(inside[1], body_.radius * direction[1], share), inside[2]};
}

/// The place on the ball that lies above or below a place on the chord, at
/// equal steps of the angle from the first place on the ball to the rim.
Place BodyPlaces::on_arc(const Place& first, const Place& chord,
                         double share) const {
  const double start = std::asin(std::hypot(first[0], first[1]) / body_.radius);
  const double end = std::acos(1.0 - body_.height / body_.radius);
  const double angle = std::lerp(start, end, share);
  const double r = body_.radius * std::sin(angle);
  const double factor = r / std::hypot(chord[0], chord[1]);
  return {factor * chord[0], factor * chord[1],
          -body_.radius * (1.0 - std::cos(angle))};
}

Place BodyPlaces::operator()(const BodyNode& node) const {
  const double u = 2.0 * node.i / across_ - 1.0;
  const double v = 2.0 * node.j / across_ - 1.0;
  const double w = static_cast<double>(node.k) / down();
  const auto depth = layers_[static_cast<std::size_t>(node.k)];
  if (node.shell > n_fans())
    return on_ring(u, v,
                   n_fans() > 0 ? on_outside(u, v, w) : in_box(u, v, depth),
                   rings_[static_cast<std::size_t>(node.shell - n_fans())]);
  const Place inside = in_box(u, v, depth);
  if (node.shell == 0)
    return inside;
  const double share = fans_[static_cast<std::size_t>(node.shell)];
  const Place outside = on_outside(u, v, w);
  Place place = between(inside, outside, share);
  // The straight way out of the nodes at the end is replaced by an arc on the
  // ball, and that of the nodes below in proportion.
  if (body_.shape == CounterShape::sphere && w < 1.0) {
    const Place chord =
        between(in_box(u, v, 0.0), on_outside(u, v, 0.0), share);
    const Place arc = on_arc(in_box(u, v, 0.0), chord, share);
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] += (1.0 - w) * (arc[axis] - chord[axis]);
  }
  return place;
}

/// Collects cells of nodes, each node once.
class BodyCells {
public:
  BodyCells(const CounterBody& body, BlockMesh& mesh)
      : body_(body), places_(body), mesh_(mesh) {}

  void add_all() {
    const int n = places_.across();
    for (int k = 0; k < places_.down(); ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          add({{{0, i, j, k},
                {0, i + 1, j, k},
                {0, i, j + 1, k},
                {0, i + 1, j + 1, k}}},
              {0, 0, 0, 1});
    const int n_shells = places_.n_fans() + places_.n_rings();
    for (int shell = 0; shell < n_shells; ++shell) {
      add_sides(shell);
      if (shell < places_.n_fans())
        add_bottom(shell);
    }
    mesh_.cell_group.assign(mesh_.cells.size(), 0);
  }

private:
  using Four = std::array<BodyNode, 4>;

  void add_sides(int shell) {
    const int n = places_.across();
    for (int k = 0; k < places_.down(); ++k)
      for (int i = 0; i < n; ++i)
        for (const int end : {0, n}) {
          add({{{shell, i, end, k},
                {shell, i + 1, end, k},
                {shell, i, end, k + 1},
                {shell, i + 1, end, k + 1}}},
              {1, 0, 0, 0});
          add({{{shell, end, i, k},
                {shell, end, i + 1, k},
                {shell, end, i, k + 1},
                {shell, end, i + 1, k + 1}}},
              {1, 0, 0, 0});
        }
  }

  void add_bottom(int shell) {
    const int n = places_.across();
    const int k = places_.down();
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        add({{{shell, i, j, k},
              {shell, i + 1, j, k},
              {shell, i, j + 1, k},
              {shell, i + 1, j + 1, k}}},
            {1, 0, 0, 0});
  }

  unsigned int number_of(const BodyNode& node) {
    const auto [entry, is_new] = numbers_.try_emplace(
        node, static_cast<unsigned int>(mesh_.vertices.size()));
    if (is_new) {
      const Place place = places_(node);
      mesh_.vertices.push_back(
          {place[0] + body_.centre_x, place[1] + body_.centre_y, place[2]});
    }
    return entry->second;
  }

  /// Adds the cell between four nodes and the same four moved by a step, with
  /// the vertices in a right-handed order.
  void add(const Four& four, const BodyNode& step) {
    std::array<unsigned int, 8> cell{};
    for (std::size_t v = 0; v < 4; ++v) {
      BodyNode moved = four[v];
      moved.shell += step.shell;
      moved.k += step.k;
      cell[v] = number_of(four[v]);
      cell[v + 4] = number_of(moved);
    }
    mesh_.cells.push_back(cell);
    if (cell_shape(mesh_, mesh_.cells.size() - 1) < 0.0)
      std::swap_ranges(mesh_.cells.back().begin(),
                       mesh_.cells.back().begin() + 4,
                       mesh_.cells.back().begin() + 4);
  }

  const CounterBody& body_;
  BodyPlaces places_;
  BlockMesh& mesh_;
  std::map<BodyNode, unsigned int> numbers_;
};

void add_faces(const CounterBody& body, BlockMesh& mesh) {
  const double tolerance = 1e-9 * body.height;
  for (const Facet& facet : boundary_facets(mesh)) {
    BoundaryFace face{facet.vertices, FaceGroup::sides};
    const auto all = [&](const auto& holds) {
      return std::ranges::all_of(facet.vertices, [&](unsigned int v) {
        return holds(mesh.vertices[v]);
      });
    };
    if (all([&](const Place& p) { return p[2] < -body.height + tolerance; }))
      face.group = FaceGroup::far_boundary;
    else if (all([&](const Place& p) {
               const double r =
                   std::hypot(p[0] - body.centre_x, p[1] - body.centre_y);
               if (body.shape != CounterShape::sphere)
                 return p[2] > -tolerance;
               return std::abs(std::hypot(r, p[2] + body.radius) -
                               body.radius) < tolerance;
             }))
      face.group = FaceGroup::contact;
    mesh.faces.push_back(face);
  }
}

void check_body(const CounterBody& body) {
  if (const auto mistake = mechanics::mistake_in(body))
    refuse_argument("mesh.counter." + mistake->key, mistake->value,
                    mistake->rule);
}

} // namespace

BlockMesh counter_body(const CounterBody& body) {
  check_body(body);
  BlockMesh mesh;
  mesh.length_x = mesh.length_y = 2.0 * mechanics::half_width(body);
  mesh.depth = body.height;
  mesh.group_names = {"counter"};
  BodyCells(body, mesh).add_all();
  require_positive_cells(mesh);
  add_faces(body, mesh);
  return mesh;
}

double counter_nodes(const CounterBody& body, int degree) {
  check_body(body);
  const BodyPlaces places(body);
  const double across = degree * places.across();
  const double down = degree * places.down();
  const double sides = 4.0 * across * (down + 1.0);
  const double bottom = (across - 1.0) * (across - 1.0);
  return (across + 1.0) * (across + 1.0) * (down + 1.0) +
         degree *
             (places.n_fans() * (sides + bottom) + places.n_rings() * sides);
}

} // namespace asperity::meshes
