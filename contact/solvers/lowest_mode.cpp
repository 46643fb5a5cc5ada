#include "contact/solvers/lowest_mode.hpp"

#include "base/symmetric_eigen.hpp"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace asperity::contact {
namespace {

constexpr int most_products = 100;

/// Eigenvalue of a saddle and accuracy of a small one, relative to k_c.
constexpr double saddle_threshold = 1e-3;
/// Residual at which an eigenvalue is known well enough, relative to it.
constexpr double eigenvalue_accuracy = 0.1;

/// A number between -1 and 1 that follows from the number of a node
/// (SplitMix64).
double noise(std::uint64_t node) {
  std::uint64_t bits = (node + 1) * 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>(bits ^ (bits >> 31U)) * 0x1p-63 - 1.0;
}

/// A vector and its product with the Hessian.
struct Image {
  std::vector<double> vector, product;

  explicit Image(std::size_t nodes) : vector(nodes), product(nodes) {}
};

/// x, the preconditioned residual w, and the last change p.
class Basis {
public:
  explicit Basis(AdhesiveState& state)
      : state_(state), images_{Image(nodes()), Image(nodes()), Image(nodes())} {
    state.each([&](std::size_t i) { x().vector[i] = noise(i); });
    // Smooth: short waves are stiff.
    state.restrict_to_free(x().vector);
    state.precondition(x().vector, x().vector);
    state.apply_hessian(x().vector, x().product);
    scale(x());
  }

  Image& x() { return images_[0]; }

  double eigenvalue() { return state_.dot(x().vector, x().product) / all(); }

  /// w = M (H x - eigenvalue x); returns the rms of the residual [Pa/m].
  double find_residual(double eigenvalue) {
    Image& w = images_[1];
    state_.each([&](std::size_t i) {
      w.vector[i] = x().product[i] - eigenvalue * x().vector[i];
    });
    return state_.rms(w.vector);
  }

  /// Minimises the Rayleigh quotient over x, w and p.
  void improve() {
    Image& w = images_[1];
    state_.precondition(w.vector, w.vector);
    state_.apply_hessian(w.vector, w.product);
    scale(w);
    const Eigen::Vector3d share = smallest_of_basis();
    Image& p = images_[2];
    state_.each([&](std::size_t i) {
      for (const auto field : {&Image::vector, &Image::product}) {
        const double change =
            share[1] * (w.*field)[i] + share[2] * (p.*field)[i];
        (p.*field)[i] = change;
        (x().*field)[i] = share[0] * (x().*field)[i] + change;
      }
    });
    scale(x());
    has_change_ = scale(p);
  }

private:
  std::size_t nodes() const { return state_.gap.size(); }

  double all() const { return state_.n_nodes(); }

  /// Scales a vector to rms 1; false if it is 0.
  bool scale(Image& image) {
    const double size = state_.rms(image.vector);
    if (!(size > 0.0 && std::isfinite(size)))
      return false;
    state_.each([&](std::size_t i) {
      image.vector[i] /= size;
      image.product[i] /= size;
    });
    return true;
  }

  /// The shares of x, w and p in the best vector.
  Eigen::Vector3d smallest_of_basis() {
    const int n = has_change_ ? 3 : 2;
    Eigen::Matrix3d overlap = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d energy = Eigen::Matrix3d::Identity();
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b) {
        const Image& left = images_[static_cast<std::size_t>(a)];
        const Image& right = images_[static_cast<std::size_t>(b)];
        overlap(a, b) = overlap(b, a) =
            state_.dot(left.vector, right.vector) / all();
        energy(a, b) = energy(b, a) =
            state_.dot(left.vector, right.product) / all();
      }
    const Eigen::Index used =
        has_change_ && overlap.determinant() < 1e-12 ? 2 : n;
    // In the orthonormal basis of the columns of `to_basis`.
    const SymmetricEigen of_overlap =
        symmetric_eigen(overlap.topLeftCorner(used, used));
    Eigen::Matrix3d to_basis = Eigen::Matrix3d::Zero();
    to_basis.topLeftCorner(used, used) =
        of_overlap.vectors *
        of_overlap.values.cwiseSqrt().cwiseInverse().asDiagonal();
    const Eigen::Matrix3d in_basis = to_basis.transpose() * energy * to_basis;
    Eigen::Vector3d share = Eigen::Vector3d::Zero();
    share.head(used) =
        symmetric_eigen(in_basis.topLeftCorner(used, used)).vectors.col(0);
    return to_basis * share;
  }

  AdhesiveState& state_;
  std::array<Image, 3> images_;
  bool has_change_ = false;
};

} // namespace

LowestMode lowest_mode(AdhesiveState& state) {
  if (state.n_free <= (state.by_gap() ? 1.0 : 0.0))
    return {std::numeric_limits<double>::infinity(), {}, false};
  const double least =
      saddle_threshold * state.problem.preconditioner_stiffness;
  Basis basis(state);
  double eigenvalue = basis.eigenvalue();
  for (int step = 0; step < most_products; ++step) {
    const double error = basis.find_residual(eigenvalue);
    if (error <= eigenvalue_accuracy * std::abs(eigenvalue) ||
        error <= 0.5 * least)
      break;
    basis.improve();
    eigenvalue = basis.eigenvalue();
  }
  return {eigenvalue, std::move(basis.x().vector), eigenvalue < -least};
}

} // namespace asperity::contact
