#include "fem/refined/box_kernel.hpp"

#include "base/simd_pack.hpp"

// The values of a box stay in registers, so loops over its nodes are unrolled.
#define ASPERITY_UNROLL _Pragma("GCC unroll 8")

namespace asperity::fem {
namespace {

template <class Number, std::size_t bytes>
struct Boxes {
  using Pack = typename SimdPack<Number, bytes>::Type;
  using Unaligned = typename SimdPack<Number, bytes>::Unaligned;
  static constexpr std::size_t lanes = SimdPack<Number, bytes>::lanes;
  static constexpr std::size_t nodes = nodes_in_box;

  /// Nodal values to the factors of the terms times eight, or the transpose:
  /// sums and differences along each axis. The number of a term has bit 0 set
  /// if it contains xi, bit 1 for eta and bit 2 for zeta.
  template <bool is_transposed>
  [[gnu::always_inline]] static void transform(Pack* v) {
    ASPERITY_UNROLL
    for (std::size_t step = 1; step < nodes; step *= 2)
      ASPERITY_UNROLL
    for (std::size_t i = 0; i < nodes; ++i)
      if ((i & step) == 0) {
        const Pack first = v[i], last = v[i + step];
        if constexpr (is_transposed) {
          v[i] = first - last;
          v[i + step] = first + last;
        } else {
          v[i] = first + last;
          v[i + step] = last - first;
        }
      }
  }

  /// Products of moduli and edges (a, b, c along x, y, z).
  struct Coefficients {
    Pack stretch[3]; ///< (lambda + 2 mu) b c / (16 a) and so on
    Pack shear[3];   ///< mu b c / (16 a) and so on
    Pack lame[3];    ///< lambda a / 16 and so on
    Pack turn[3];    ///< mu a / 16 and so on

    [[gnu::always_inline]] Coefficients(const Number* box, Number factor) {
      Pack edge[3];
      ASPERITY_UNROLL
      for (std::size_t i = 0; i < 3; ++i)
        take(box + i * boxes_in_group, edge[i]);
      Pack lambda, mu;
      take(box + 3 * boxes_in_group, lambda);
      take(box + 4 * boxes_in_group, mu);
      lambda *= Number(0.0625) * factor;
      mu *= Number(0.0625) * factor;
      ASPERITY_UNROLL
      for (std::size_t i = 0; i < 3; ++i) {
        const Pack shape = edge[(i + 1) % 3] * edge[(i + 2) % 3] / edge[i];
        shear[i] = mu * shape;
        stretch[i] = (lambda + mu + mu) * shape;
        lame[i] = lambda * edge[i];
        turn[i] = mu * edge[i];
      }
    }
  };

  // Not as a result: a vector returned has another place without AVX.
  [[gnu::always_inline]] static void take(const Number* from, Pack& pack) {
    pack = *reinterpret_cast<const Unaligned*>(from);
  }

  /// Replaces the factors of the terms of the three components by the
  /// derivatives of the energy by them. Component i, whose axis has the bit
  /// x = 2^i, is coupled to the components j and k along y and z.
  [[gnu::always_inline]] static void respond(const Coefficients& of, Pack* u) {
    constexpr auto third = static_cast<Number>(1.0 / 3.0);
    constexpr auto ninth = static_cast<Number>(1.0 / 9.0);
    Pack force[3 * nodes];
    ASPERITY_UNROLL
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const std::size_t x = std::size_t{1} << i, y = std::size_t{1} << j,
                        z = std::size_t{1} << k;
      const Pack *const ux = u + i * nodes, *const uy = u + j * nodes,
                        *const uz = u + k * nodes;
      Pack* const f = force + i * nodes;
      // xy: the edge along the third axis, k.
      const Pack &lame_xy = of.lame[k], &lame_xz = of.lame[j];
      const Pack &turn_xy = of.turn[k], &turn_xz = of.turn[j];
      f[0] = Pack{};
      f[x] = of.stretch[i] * ux[x] + lame_xy * uy[y] + lame_xz * uz[z];
      f[y] = of.shear[j] * ux[y] + turn_xy * uy[x];
      f[z] = of.shear[k] * ux[z] + turn_xz * uz[x];
      f[x | y] = third * ((of.stretch[i] + of.shear[j]) * ux[x | y] +
                          lame_xz * uz[y | z]);
      f[x | z] = third * ((of.stretch[i] + of.shear[k]) * ux[x | z] +
                          lame_xy * uy[y | z]);
      f[y | z] = third * ((of.shear[j] + of.shear[k]) * ux[y | z] +
                          turn_xy * uy[x | z] + turn_xz * uz[x | y]);
      f[7] =
          ninth * (of.stretch[i] + of.shear[j] + of.shear[k]) * ux[x | y | z];
    }
    ASPERITY_UNROLL
    for (std::size_t i = 0; i < 3 * nodes; ++i)
      u[i] = force[i];
  }

  /// The cells of one pack.
  [[gnu::always_inline]] static void some(const Number* from, Number* to,
                                          const std::uint32_t* first,
                                          const Number* box, Number factor) {
    Pack values[3 * nodes];
    auto* const numbers = reinterpret_cast<Number*>(values);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t a = 0; a < nodes; ++a) {
        const Number* const node = from + first[lane * nodes + a];
        for (std::size_t c = 0; c < 3; ++c)
          numbers[(c * nodes + a) * lanes + lane] = node[c];
      }
    for (std::size_t c = 0; c < 3; ++c)
      transform<false>(values + c * nodes);
    respond(Coefficients(box, factor), values);
    for (std::size_t c = 0; c < 3; ++c)
      transform<true>(values + c * nodes);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t a = 0; a < nodes; ++a) {
        Number* const node = to + first[lane * nodes + a];
        for (std::size_t c = 0; c < 3; ++c)
          node[c] += numbers[(c * nodes + a) * lanes + lane];
      }
  }

  [[gnu::always_inline]] static void all(const BoxProduct<Number>& product) {
    for (std::size_t group = 0; group < product.groups; ++group)
      for (std::size_t cell = 0; cell < boxes_in_group; cell += lanes)
        some(product.from, product.to,
             product.nodes + (group * boxes_in_group + cell) * nodes,
             product.boxes +
                 product.kinds[group] * boxes_in_group * numbers_in_box + cell,
             product.factor);
  }
};

template <class Number>
void multiply_boxes_here(const BoxProduct<Number>& product) {
  on_this_processor_with_fma([&](auto bytes) __attribute__((always_inline)) {
    Boxes<Number, bytes()>::all(product);
  });
}

} // namespace

void multiply_boxes(const BoxProduct<float>& product) {
  multiply_boxes_here(product);
}

void multiply_boxes(const BoxProduct<double>& product) {
  multiply_boxes_here(product);
}

} // namespace asperity::fem

#undef ASPERITY_UNROLL
