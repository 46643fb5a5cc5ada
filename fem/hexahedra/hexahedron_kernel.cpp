#include "fem/hexahedra/hexahedron_kernel.hpp"

#include "base/simd_pack.hpp"

#include <array>

// The values of a line of nodes stay in registers, so its loops are unrolled.
#define ASPERITY_UNROLL _Pragma("GCC unroll 9")

namespace asperity::fem {
namespace {

constexpr double gauss_place = 0.774596669241483377; ///< sqrt(3/5)

/// The second-order shape functions of the three nodes of a line at its first
/// Gauss point; at the last one they are mirrored, and the middle Gauss point
/// is the middle node.
constexpr std::array<double, 3> at_first{
    0.5 * gauss_place * (gauss_place + 1.0), 1.0 - gauss_place* gauss_place,
    0.5 * gauss_place*(gauss_place - 1.0)};

constexpr std::array<double, 3> gauss_weight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

template <class Number, std::size_t bytes>
struct Hexahedra {
  using Pack = typename SimdPack<Number, bytes>::Type;
  static constexpr std::size_t lanes = SimdPack<Number, bytes>::lanes;
  static constexpr std::size_t nodes = nodes_in_hexahedron;

  struct Three {
    Pack entries[3];

    Pack& operator[](std::size_t i) { return entries[i]; }

    const Pack& operator[](std::size_t i) const { return entries[i]; }
  };

  /// The first entry of the line number `line` along an axis whose entries are
  /// `step` apart.
  template <std::size_t step>
  [[gnu::always_inline]] static Pack* line_at(Pack* values, std::size_t line) {
    return values + line / step * step * 3 + line % step;
  }

  /// Nodal values to values at Gauss points along one axis, or the transpose.
  template <std::size_t step, bool is_transposed>
  [[gnu::always_inline]] static void interpolate(Pack* values) {
    constexpr auto near = static_cast<Number>(at_first[0]);
    constexpr auto middle = static_cast<Number>(at_first[1]);
    constexpr auto far = static_cast<Number>(at_first[2]);
    ASPERITY_UNROLL
    for (std::size_t line = 0; line < 9; ++line) {
      Pack* const v = line_at<step>(values, line);
      const Pack first = v[0], last = v[2 * step];
      if constexpr (is_transposed) {
        v[0] = near * first + far * last;
        v[2 * step] = far * first + near * last;
        v[step] += middle * (first + last);
      } else {
        const Pack own = middle * v[step];
        v[0] = near * first + far * last + own;
        v[2 * step] = far * first + near * last + own;
      }
    }
  }

  /// Derivatives by a reference coordinate at the Gauss points from values
  /// there.
  template <std::size_t step>
  [[gnu::always_inline]] static void differentiate(Pack* values,
                                                   Pack* derivatives) {
    constexpr auto half = static_cast<Number>(0.5 / gauss_place);
    constexpr auto two = static_cast<Number>(2.0 / gauss_place);
    ASPERITY_UNROLL
    for (std::size_t line = 0; line < 9; ++line) {
      const Pack* const v = line_at<step>(values, line);
      Pack* const d = line_at<step>(derivatives, line);
      const Pack slope = half * (v[2 * step] - v[0]);
      const Pack bend = half * (v[0] + v[2 * step]) * Number(2) - two * v[step];
      d[0] = slope - bend;
      d[step] = slope;
      d[2 * step] = slope + bend;
    }
  }

  /// The transpose of differentiate(); adds to the values.
  template <std::size_t step>
  [[gnu::always_inline]] static void integrate(Pack* derivatives,
                                               Pack* values) {
    constexpr auto half = static_cast<Number>(0.5 / gauss_place);
    constexpr auto two = static_cast<Number>(2.0 / gauss_place);
    ASPERITY_UNROLL
    for (std::size_t line = 0; line < 9; ++line) {
      const Pack* const d = line_at<step>(derivatives, line);
      Pack* const v = line_at<step>(values, line);
      const Pack slope = half * (d[0] + d[step] + d[2 * step]);
      const Pack bend = d[2 * step] - d[0];
      v[0] += Number(2) * half * bend - slope;
      v[step] -= two * bend;
      v[2 * step] += Number(2) * half * bend + slope;
    }
  }

  [[gnu::always_inline]] static void cross(const Three& a, const Three& b,
                                           Three& product) {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
  }

  /// What the Gauss points of one cell have in common.
  struct Shape {
    std::array<Three, 7> c; ///< of (F.5)
    Pack lame, shear;
    const Number* tangents; ///< of the first cell, or null
    Number factor;          ///< of the product
  };

  /// Reads one number of each cell of a pack.
  [[gnu::always_inline]] static void take(const Number* numbers, Pack& pack) {
    __builtin_memcpy(&pack, numbers, bytes);
  }

  /// Replaces H times `scale` by C H, where C is the tangent (F.6) at a Gauss
  /// point.
  [[gnu::always_inline]] static void
  respond_by_tangent(const Number* tangent, const Pack& scale,
                     const std::array<Three, 3>& h,
                     std::array<Three, 3>& stress) {
    Pack lame, mu, product{};
    take(tangent, lame);
    take(tangent + cells_in_group, mu);
    mu *= scale;
    Three strain, shear, normal_softening, shear_softening;
    ASPERITY_UNROLL
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      take(tangent + (2 + i) * cells_in_group, normal_softening[i]);
      take(tangent + (5 + i) * cells_in_group, shear_softening[i]);
      strain[i] = h[i][i];
      shear[i] = h[j][k] + h[k][j];
      product +=
          normal_softening[i] * strain[i] + shear_softening[i] * shear[i];
    }
    product *= scale;
    const Pack pressure = scale * lame * (strain[0] + strain[1] + strain[2]);
    ASPERITY_UNROLL
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      stress[i][i] =
          pressure + (mu + mu) * strain[i] - product * normal_softening[i];
      stress[j][k] = stress[k][j] =
          mu * shear[i] - product * shear_softening[i];
    }
  }

  /// The same for the moduli of the cell.
  [[gnu::always_inline]] static void
  respond_by_moduli(const Shape& shape, const Pack& scale,
                    const std::array<Three, 3>& h,
                    std::array<Three, 3>& stress) {
    const Pack mu = scale * shape.shear;
    const Pack pressure = scale * shape.lame * (h[0][0] + h[1][1] + h[2][2]);
    const Pack xy = mu * (h[0][1] + h[1][0]);
    const Pack yz = mu * (h[1][2] + h[2][1]);
    const Pack zx = mu * (h[2][0] + h[0][2]);
    const Pack twice = mu + mu;
    stress = {Three{{pressure + twice * h[0][0], xy, zx}},
              Three{{xy, pressure + twice * h[1][1], yz}},
              Three{{zx, yz, pressure + twice * h[2][2]}}};
  }

  /// Replaces the derivatives by the reference coordinates at a Gauss point by
  /// those of the energy by them. With the cofactors A of (F.5) and its
  /// determinant D the gradient is H / D, H_ck = sum over m of u_c,m A_mk, and
  /// the result is w / D times C H A^T.
  [[gnu::always_inline]] static void respond(const Shape& shape,
                                             const std::array<Number, 3>& at,
                                             Number weight, Pack* u,
                                             std::size_t point) {
    std::array<Three, 3> edges, cofactors;
    ASPERITY_UNROLL
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& c = shape.c;
      edges[0][i] =
          c[0][i] + at[1] * c[3][i] + at[2] * (c[5][i] + at[1] * c[6][i]);
      edges[1][i] =
          c[1][i] + at[0] * c[3][i] + at[2] * (c[4][i] + at[0] * c[6][i]);
      edges[2][i] =
          c[2][i] + at[0] * c[5][i] + at[1] * (c[4][i] + at[0] * c[6][i]);
    }
    cross(edges[1], edges[2], cofactors[0]);
    cross(edges[2], edges[0], cofactors[1]);
    cross(edges[0], edges[1], cofactors[2]);
    const Pack scale = weight / (edges[0][0] * cofactors[0][0] +
                                 edges[0][1] * cofactors[0][1] +
                                 edges[0][2] * cofactors[0][2]);
    // u is ordered by component, then derivative, then Gauss point.
    const auto entry = [&](std::size_t c, std::size_t m) -> Pack& {
      return u[(3 * c + m) * nodes + point];
    };
    std::array<Three, 3> h;
    ASPERITY_UNROLL
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        h[c][k] = entry(c, 0) * cofactors[0][k] +
                  entry(c, 1) * cofactors[1][k] + entry(c, 2) * cofactors[2][k];
    std::array<Three, 3> stress;
    if (shape.tangents == nullptr)
      respond_by_moduli(shape, scale, h, stress);
    else
      respond_by_tangent(shape.tangents +
                             point * numbers_in_tangent * cells_in_group,
                         scale, h, stress);
    ASPERITY_UNROLL
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t m = 0; m < 3; ++m)
        entry(c, m) = stress[c][0] * cofactors[m][0] +
                      stress[c][1] * cofactors[m][1] +
                      stress[c][2] * cofactors[m][2];
  }

  [[gnu::always_inline]] static void all_points(const Shape& shape, Pack* u) {
    constexpr auto g = static_cast<Number>(gauss_place);
    constexpr std::array<Number, 3> places{-g, Number(0), g};
    std::size_t point = 0;
    for (std::size_t z = 0; z < 3; ++z)
      for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 3; ++x, ++point)
          respond(shape, {places[x], places[y], places[z]},
                  shape.factor *
                      static_cast<Number>(gauss_weight[x] * gauss_weight[y] *
                                          gauss_weight[z]),
                  u, point);
  }

  /// Multiplies nodal values, ordered by component.
  [[gnu::always_inline]] static void multiply(const Shape& shape,
                                              Pack* values) {
    Pack u[9 * nodes];
    for (std::size_t c = 0; c < 3; ++c) {
      Pack* const own = values + c * nodes;
      interpolate<1, false>(own);
      interpolate<3, false>(own);
      interpolate<9, false>(own);
      differentiate<1>(own, u + (3 * c) * nodes);
      differentiate<3>(own, u + (3 * c + 1) * nodes);
      differentiate<9>(own, u + (3 * c + 2) * nodes);
    }
    all_points(shape, u);
    for (std::size_t c = 0; c < 3; ++c) {
      Pack* const own = values + c * nodes;
      for (std::size_t i = 0; i < nodes; ++i)
        own[i] = Pack{};
      integrate<1>(u + (3 * c) * nodes, own);
      integrate<3>(u + (3 * c + 1) * nodes, own);
      integrate<9>(u + (3 * c + 2) * nodes, own);
      interpolate<9, true>(own);
      interpolate<3, true>(own);
      interpolate<1, true>(own);
    }
  }

  [[gnu::always_inline]] static void read(const Number* shapes, Shape& shape) {
    for (std::size_t i = 0; i < 21; ++i)
      take(shapes + i * cells_in_group, shape.c[i / 3][i % 3]);
    take(shapes + 21 * cells_in_group, shape.lame);
    take(shapes + 22 * cells_in_group, shape.shear);
  }

  /// The cells of one pack.
  [[gnu::always_inline]] static void
  some(const Number* from, Number* to, const std::uint32_t* first,
       const Number* shapes, const Number* tangents, Number factor) {
    Shape shape;
    read(shapes, shape);
    shape.tangents = tangents;
    shape.factor = factor;
    Pack values[3 * nodes];
    auto* const numbers = reinterpret_cast<Number*>(values);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t a = 0; a < nodes; ++a) {
        const Number* const node = from + first[lane * nodes + a];
        for (std::size_t c = 0; c < 3; ++c)
          numbers[(c * nodes + a) * lanes + lane] = node[c];
      }
    multiply(shape, values);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t a = 0; a < nodes; ++a) {
        Number* const node = to + first[lane * nodes + a];
        for (std::size_t c = 0; c < 3; ++c)
          node[c] += numbers[(c * nodes + a) * lanes + lane];
      }
  }

  [[gnu::always_inline]] static void
  all(const HexahedronProduct<Number>& product) {
    constexpr std::size_t numbers =
        points_in_hexahedron * numbers_in_tangent * cells_in_group;
    for (std::size_t group = 0; group < product.groups; ++group) {
      const std::uint32_t place = product.tangent_places == nullptr
                                      ? no_tangents
                                      : product.tangent_places[group];
      for (std::size_t cell = 0; cell < cells_in_group; cell += lanes)
        some(product.from, product.to,
             product.nodes + (group * cells_in_group + cell) * nodes,
             product.shapes + group * cells_in_group * numbers_in_shape + cell,
             place == no_tangents ? nullptr
                                  : product.tangents + place * numbers + cell,
             product.factor);
    }
  }
};

template <class Number>
void multiply_here(const HexahedronProduct<Number>& product) {
  on_this_processor_with_fma([&](auto bytes) __attribute__((always_inline)) {
    Hexahedra<Number, bytes()>::all(product);
  });
}

} // namespace

void multiply_hexahedra(const HexahedronProduct<float>& product) {
  multiply_here(product);
}

void multiply_hexahedra(const HexahedronProduct<double>& product) {
  multiply_here(product);
}

} // namespace asperity::fem

#undef ASPERITY_UNROLL
