#include "analysis/models/separation.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kTolerance = 1e-9;
constexpr int kMaxProjections = 20000;

struct Pattern {
  double successes = 0;
  double trials = 0;
};

/// Rows that are alike count as one.
std::vector<std::pair<VectorXd, Pattern>> patternsOf(const MatrixXd& rows, const VectorXd& successes,
                                                     const VectorXd& trials) {
  std::vector<Index> order(static_cast<size_t>(rows.rows()));
  std::iota(order.begin(), order.end(), Index{0});
  const auto before = [&](Index a, Index b) {
    for (Index column = 0; column < rows.cols(); ++column) {
      if (rows(a, column) != rows(b, column)) {
        return rows(a, column) < rows(b, column);
      }
    }
    return false;
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::pair<VectorXd, Pattern>> patterns;
  for (size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || before(order[i - 1], order[i])) {
      patterns.emplace_back(rows.row(order[i]).transpose(), Pattern{});
    }
    patterns.back().second.successes += successes[order[i]];
    patterns.back().second.trials += trials[order[i]];
  }
  return patterns;
}

/// Columns that span what is orthogonal to all rows of `matrix`.
MatrixXd nullSpaceOf(const MatrixXd& matrix) {
  if (matrix.rows() == 0) {
    return MatrixXd::Identity(matrix.cols(), matrix.cols());
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(matrix.transpose());
  qr.setThreshold(kTolerance);
  const MatrixXd basis = qr.householderQ();
  return basis.rightCols(matrix.cols() - qr.rank());
}

MatrixXd stack(const std::vector<VectorXd>& rows, Index columns) {
  MatrixXd matrix(static_cast<Index>(rows.size()), columns);
  for (size_t i = 0; i < rows.size(); ++i) {
    matrix.row(static_cast<Index>(i)) = rows[i].transpose();
  }
  return matrix;
}

}  // namespace

std::vector<Index> separatedColumns(const MatrixXd& rows, const VectorXd& successes, const VectorXd& trials) {
  std::vector<VectorXd> mixed;
  std::vector<VectorXd> pure;  // with the sign that they must have
  for (const auto& [row, pattern] : patternsOf(rows, successes, trials)) {
    if (pattern.successes > 0 && pattern.successes < pattern.trials) {
      mixed.push_back(row);
    } else {
      pure.push_back(pattern.successes > 0 ? row : VectorXd(-row));
    }
  }
  const MatrixXd free = nullSpaceOf(stack(mixed, rows.cols()));
  if (free.cols() == 0 || pure.empty()) {
    return {};
  }
  const MatrixXd span = stack(pure, rows.cols()) * free;
  Eigen::ColPivHouseholderQR<MatrixXd> qr(span);
  qr.setThreshold(kTolerance);
  if (qr.rank() == 0) {
    return {};
  }
  const MatrixXd basis = MatrixXd(qr.householderQ()).leftCols(qr.rank());
  VectorXd point = VectorXd::Ones(span.rows());
  for (int count = 0; count < kMaxProjections; ++count) {
    const VectorXd projected = basis * (basis.transpose() * point);
    const double largest = projected.lpNorm<Eigen::Infinity>();
    if (largest < kTolerance) {
      return {};
    }
    if (projected.minCoeff() > -1e-6 * largest) {
      const VectorXd direction = free * qr.solve(projected);
      std::vector<Index> columns;
      for (Index column = 0; column < direction.size(); ++column) {
        if (std::abs(direction[column]) > 1e-4 * direction.lpNorm<Eigen::Infinity>()) {
          columns.push_back(column);
        }
      }
      return columns;
    }
    point = projected.cwiseMax(0);
  }
  return {};
}

std::vector<std::string> separatedCoefficients(const Design& design, const Eigen::VectorXd& successes,
                                               const Eigen::VectorXd& trials) {
  const Eigen::VectorXd lengths = design.fixed.colwise().lpNorm<Eigen::Infinity>();
  const Eigen::MatrixXd columns = design.fixed * lengths.cwiseInverse().asDiagonal();
  std::vector<std::string> names;
  for (const Eigen::Index column : separatedColumns(columns, successes, trials)) {
    names.push_back(design.fixedNames[static_cast<size_t>(column)]);
  }
  return names;
}

}  // namespace ocelli
