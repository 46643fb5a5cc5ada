#include "md/interface/interface_curvature.hpp"

#include "base/require.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace asperity::md {
namespace {

struct Vector {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

Vector product(const SymmetricBlock& block, double x, double y, double z) {
  return {block.xx * x + block.xy * y + block.xz * z,
          block.xy * x + block.yy * y + block.yz * z,
          block.xz * x + block.yz * y + block.zz * z};
}

void add(SymmetricBlock& sum, const SymmetricBlock& block) {
  sum.xx += block.xx;
  sum.yy += block.yy;
  sum.zz += block.zz;
  sum.xy += block.xy;
  sum.xz += block.xz;
  sum.yz += block.yz;
}

bool is_zero(const SymmetricBlock& block) {
  return block.xx == 0.0 && block.yy == 0.0 && block.zz == 0.0 &&
         block.xy == 0.0 && block.xz == 0.0 && block.yz == 0.0;
}

} // namespace

template <class Function>
SymmetricBlock
InterfaceCurvature::Axes::of_values(const Function& function) const {
  SymmetricBlock sum;
  for (int axis = 0; axis < 3; ++axis) {
    const double value = function(values[axis]);
    const double x = vectors[0][axis];
    const double y = vectors[1][axis];
    const double z = vectors[2][axis];
    sum.xx += value * x * x;
    sum.yy += value * y * y;
    sum.zz += value * z * z;
    sum.xy += value * x * y;
    sum.xz += value * x * z;
    sum.yz += value * y * z;
  }
  return sum;
}

InterfaceCurvature::InterfaceCurvature(std::size_t atoms, double bulk_stiffness,
                                       bool is_normal)
    : bulk_stiffness_(bulk_stiffness),
      is_normal_(is_normal),
      taken_(atoms),
      blocks_(atoms),
      scales_(atoms),
      axes_(atoms) {
  require_positive("bulk_stiffness", bulk_stiffness, "N/m");
}

void InterfaceCurvature::take(const Interface& interface,
                              const LayerView& atoms) {
  interface.second_derivatives(atoms, taken_);
  mean_stiffness_ = 0.0;
  for (SymmetricBlock& block : taken_) {
    if (is_normal_)
      block = {.zz = block.zz};
    mean_stiffness_ += std::max(0.0, block.zz);
  }
  mean_stiffness_ /= static_cast<double>(blocks_.size());

  blocks_ = taken_;

  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const SymmetricBlock& block = blocks_[i];
    Axes& axes = axes_[i];
    axes = {{}, {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    if (!is_zero(block)) {
      Eigen::Matrix3d matrix;
      matrix << block.xx, block.xy, block.xz, block.xy, block.yy, block.yz,
          block.xz, block.yz, block.zz;
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
      solver.computeDirect(matrix);
      for (int axis = 0; axis < 3; ++axis) {
        axes.values[axis] = solver.eigenvalues()(axis);
        for (int k = 0; k < 3; ++k)
          axes.vectors[k][axis] = solver.eigenvectors()(k, axis);
      }
    }
    scales_[i] = axes.of_values([&](double value) {
      return std::sqrt((bulk_stiffness_ + mean_stiffness_) /
                       (bulk_stiffness_ + std::max(0.0, value)));
    });
  }
}

void InterfaceCurvature::limit_negative_curvature(double share) {
  if (!(share >= 0.0)) // infinity is valid
    require_not_negative("share", share, "1");
  const double lowest = -share * bulk_stiffness_;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    blocks_[i] = taken_[i];
    if (axes_[i].values[0] < lowest)
      add(blocks_[i], axes_[i].of_values([&](double value) {
        return std::max(0.0, lowest - value);
      }));
  }
}

void InterfaceCurvature::add_product(const LayerView& step,
                                     const LayerForces& forces) const {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const Vector force = product(blocks_[i], step.x[i], step.y[i], step.z[i]);
    forces.x[i] += force.x;
    forces.y[i] += force.y;
    forces.z[i] += force.z;
  }
}

void InterfaceCurvature::scale(const LayerForces& planes) const {
  for (std::size_t i = 0; i < scales_.size(); ++i) {
    const Vector scaled =
        product(scales_[i], planes.x[i], planes.y[i], planes.z[i]);
    planes.x[i] = scaled.x;
    planes.y[i] = scaled.y;
    planes.z[i] = scaled.z;
  }
}

} // namespace asperity::md
