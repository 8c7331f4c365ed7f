#include "analysis/models/quadrature.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace ocelli {

HermiteRule hermiteRule(int count) {
  Eigen::VectorXd below(count - 1);
  for (Eigen::Index i = 0; i < below.size(); ++i) {
    below[i] = std::sqrt(static_cast<double>(i + 1) / 2);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
  eigen.computeFromTridiagonal(Eigen::VectorXd::Zero(count), below);
  return {eigen.eigenvalues(), std::sqrt(std::numbers::pi) * eigen.eigenvectors().row(0).array().square().transpose()};
}

}  // namespace ocelli
