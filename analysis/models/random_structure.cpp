#include "analysis/models/random_structure.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Effects beside the first term's up to which whole matrices are faster than sparse ones.
constexpr Index kLargestDense = 300;

/// out += weight * first second', column by column.
void addOuter(double weight, const double* first, int rows, const double* second, int columns, double* out) {
  for (int column = 0; column < columns; ++column) {
    const double factor = weight * second[column];
    for (int row = 0; row < rows; ++row) {
      out[column * rows + row] += factor * first[row];
    }
  }
}

}  // namespace

RandomStructure::RandomStructure(const std::vector<RandomTerm>& terms, Index rows) : rows_(rows) {
  for (const RandomTerm& each : terms) {
    Term term;
    term.offset = size_;
    term.thetaOffset = thetaSize_;
    term.width = static_cast<int>(each.columns.cols());
    term.levels = static_cast<int>(each.levels.size());
    term.correlated = each.correlated;
    term.levelOfRow = each.levelOfRow;
    term.scales = VectorXd::Ones(term.width);
    for (Index effect = 0; effect < term.width && rows > 0; ++effect) {
      const double largest = each.columns.col(effect).lpNorm<Eigen::Infinity>();
      if (largest > 0) {
        term.scales[effect] = largest * (each.columns.col(effect) / largest).norm() / std::sqrt(rows);
      }
    }
    term.rows = (each.columns * term.scales.cwiseInverse().asDiagonal()).transpose();
    size_ += static_cast<Index>(term.levels) * term.width;
    thetaSize_ += term.correlated ? term.width * (term.width + 1) / 2 : term.width;
    terms_.push_back(std::move(term));
  }
  for (size_t first = 0; first < terms_.size(); ++first) {
    for (size_t second = 0; second <= first; ++second) {
      pairs_.push_back(makePair(first, second));
      Pair& pair = pairs_.back();
      pair.valueOffset = valueCount_;
      valueCount_ += static_cast<Index>(pair.levels.size()) * terms_[first].width * terms_[second].width;
    }
  }
}

RandomStructure::Pair RandomStructure::makePair(size_t first, size_t second) const {
  Pair pair;
  pair.first = first;
  pair.second = second;
  if (first == second) {
    pair.blockOfRow = terms_[first].levelOfRow;
    for (int level = 0; level < terms_[first].levels; ++level) {
      pair.levels.emplace_back(level, level);
    }
    return pair;
  }
  std::unordered_map<int64_t, int> blocks;
  for (Index row = 0; row < rows_; ++row) {
    const int a = terms_[first].levelOfRow[static_cast<size_t>(row)];
    const int b = terms_[second].levelOfRow[static_cast<size_t>(row)];
    const int64_t key = static_cast<int64_t>(a) * terms_[second].levels + b;
    const auto [block, isNew] = blocks.emplace(key, static_cast<int>(pair.levels.size()));
    if (isNew) {
      pair.levels.emplace_back(a, b);
    }
    pair.blockOfRow.push_back(block->second);
  }
  return pair;
}

VectorXd RandomStructure::startTheta() const {
  VectorXd theta = VectorXd::Zero(thetaSize_);
  for (const Index diagonal : diagonals()) {
    theta[diagonal] = 1;
  }
  return theta;
}

std::vector<Index> RandomStructure::diagonals() const {
  std::vector<Index> found;
  for (const Term& term : terms_) {
    Index next = term.thetaOffset;
    for (int column = 0; column < term.width; ++column) {
      found.push_back(next);
      next += term.correlated ? term.width - column : 1;
    }
  }
  return found;
}

MatrixXd RandomStructure::templateOf(size_t index, const VectorXd& theta) const {
  const Term& term = terms_[index];
  MatrixXd lower = MatrixXd::Zero(term.width, term.width);
  Index next = term.thetaOffset;
  for (int column = 0; column < term.width; ++column) {
    const int end = term.correlated ? term.width : column + 1;
    for (int row = column; row < end; ++row) {
      lower(row, column) = theta[next++];
    }
  }
  return lower;
}

VectorXd RandomStructure::signsOf(const VectorXd& theta) const {
  VectorXd signs = VectorXd::Ones(thetaSize_);
  for (const Term& term : terms_) {
    Index next = term.thetaOffset;
    for (int column = 0; column < term.width; ++column) {
      const Index count = term.correlated ? term.width - column : 1;
      if (theta[next] < 0) {
        signs.segment(next, count) *= -1;
      }
      next += count;
    }
  }
  return signs;
}

VectorXd RandomStructure::crossProduct(const VectorXd& weights) const {
  VectorXd values = VectorXd::Zero(valueCount_);
  for (const Pair& pair : pairs_) {
    const Term& a = terms_[pair.first];
    const Term& b = terms_[pair.second];
    const int size = a.width * b.width;
    double* blocks = values.data() + pair.valueOffset;
    for (Index row = 0; row < rows_; ++row) {
      addOuter(weights[row], a.rows.data() + row * a.width, a.width, b.rows.data() + row * b.width, b.width,
               blocks + static_cast<Index>(pair.blockOfRow[static_cast<size_t>(row)]) * size);
    }
  }
  return values;
}

MatrixXd RandomStructure::transposedTimes(const MatrixXd& matrix) const {
  MatrixXd result = MatrixXd::Zero(size_, matrix.cols());
  for (Index column = 0; column < matrix.cols(); ++column) {
    const double* source = matrix.data() + column * rows_;
    double* target = result.data() + column * size_;
    for (const Term& term : terms_) {
      const double* z = term.rows.data();
      for (Index row = 0; row < rows_; ++row) {
        double* effects =
            target + term.offset + static_cast<Index>(term.levelOfRow[static_cast<size_t>(row)]) * term.width;
        for (int effect = 0; effect < term.width; ++effect) {
          effects[effect] += source[row] * *z++;
        }
      }
    }
  }
  return result;
}

VectorXd RandomStructure::times(const VectorXd& b) const {
  VectorXd result = VectorXd::Zero(rows_);
  for (const Term& term : terms_) {
    const double* z = term.rows.data();
    for (Index row = 0; row < rows_; ++row) {
      const double* effects =
          b.data() + term.offset + static_cast<Index>(term.levelOfRow[static_cast<size_t>(row)]) * term.width;
      double sum = 0;
      for (int effect = 0; effect < term.width; ++effect) {
        sum += effects[effect] * *z++;
      }
      result[row] += sum;
    }
  }
  return result;
}

VectorXd RandomStructure::lambdaTimes(const VectorXd& theta, const VectorXd& u) const {
  VectorXd b(size_);
  for (size_t i = 0; i < terms_.size(); ++i) {
    const Term& term = terms_[i];
    const Eigen::Map<const MatrixXd> spherical(u.data() + term.offset, term.width, term.levels);
    Eigen::Map<MatrixXd>(b.data() + term.offset, term.width, term.levels) = templateOf(i, theta) * spherical;
  }
  return b;
}

void RandomStructure::multiplyByLambdaTransposed(const VectorXd& theta, MatrixXd& matrix) const {
  for (size_t i = 0; i < terms_.size(); ++i) {
    const Term& term = terms_[i];
    const MatrixXd transposed = templateOf(i, theta).transpose();
    for (Index column = 0; column < matrix.cols(); ++column) {
      Eigen::Map<MatrixXd> effects(matrix.data() + column * size_ + term.offset, term.width, term.levels);
      effects = transposed * effects;
    }
  }
}

VectorXd RandomStructure::thetaOf(const VectorXd& scaled) const {
  VectorXd theta = scaled;
  for (const Term& term : terms_) {
    Index next = term.thetaOffset;
    for (int column = 0; column < term.width; ++column) {
      const int end = term.correlated ? term.width : column + 1;
      for (int row = column; row < end; ++row) {
        theta[next++] /= term.scales[row];
      }
    }
  }
  return theta;
}

VectorXd RandomStructure::scaledThetaOf(const VectorXd& theta) const {
  const VectorXd ones = VectorXd::Ones(thetaSize_);
  return theta.cwiseQuotient(thetaOf(ones));
}

MatrixXd RandomStructure::covarianceOf(size_t index, const VectorXd& scaledTheta) const {
  const MatrixXd lower = templateOf(index, thetaOf(scaledTheta));
  return lower * lower.transpose();
}

MatrixXd RandomStructure::effectsOf(size_t index, const VectorXd& b) const {
  const Term& term = terms_[index];
  const Eigen::Map<const MatrixXd> effects(b.data() + term.offset, term.width, term.levels);
  return (term.scales.cwiseInverse().asDiagonal() * effects).transpose();
}

VectorXd RandomStructure::rowVariances(const VectorXd& scaledTheta) const {
  VectorXd variances = VectorXd::Zero(rows_);
  for (size_t i = 0; i < terms_.size(); ++i) {
    variances += (templateOf(i, scaledTheta).transpose() * terms_[i].rows).colwise().squaredNorm().transpose();
  }
  return variances;
}

PenalizedCholesky::PenalizedCholesky(const RandomStructure& structure) : structure_(structure) {
  const auto sizeOf = [](const Term& term) { return term.levels * term.width; };
  const std::vector<Term>& terms = structure.terms_;
  for (size_t term = 1; term < terms.size(); ++term) {
    first_ = sizeOf(terms[term]) > sizeOf(terms[first_]) ? term : first_;
  }
  const Index firstSize = sizeOf(terms[first_]);
  const Index restSize = structure.size() - firstSize;
  sparse_ = restSize > kLargestDense;
  if (sparse_) {
    prepareSparse();
    return;
  }
  levelFactors_.resize(terms[first_].width, firstSize);
  below_.resize(restSize, firstSize);
  rest_.resize(restSize, restSize);
}

void PenalizedCholesky::prepareSparse() {
  const auto forEachColumn = [&](const auto& call) {
    for (const RandomStructure::Pair& pair : structure_.pairs_) {
      const Term& a = structure_.terms_[pair.first];
      const Term& b = structure_.terms_[pair.second];
      for (const auto& [first, second] : pair.levels) {
        for (int column = 0; column < b.width; ++column) {
          const int skipped = pair.first == pair.second ? column : 0;
          call(a.offset + static_cast<Index>(first) * a.width + skipped, a.width - skipped,
               b.offset + static_cast<Index>(second) * b.width + column);
        }
      }
    }
  };
  std::vector<Eigen::Triplet<double>> triplets;
  forEachColumn([&](Index row, int count, Index column) {
    for (int i = 0; i < count; ++i) {
      triplets.emplace_back(static_cast<int>(row) + i, static_cast<int>(column), 1.0);
    }
  });
  matrix_.resize(structure_.size(), structure_.size());
  matrix_.setFromTriplets(triplets.begin(), triplets.end());
  matrix_.makeCompressed();
  forEachColumn([&](Index row, int, Index column) {
    const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    const int* found = std::lower_bound(begin, end, static_cast<int>(row));
    positions_.push_back(static_cast<int>(found - matrix_.innerIndexPtr()));
  });
  solver_.analyzePattern(matrix_);
}

Index PenalizedCholesky::placeOf(size_t term) const {
  const Term& first = structure_.terms_[first_];
  const Index offset = structure_.terms_[term].offset;
  return offset < first.offset ? offset : offset - static_cast<Index>(first.levels) * first.width;
}

void PenalizedCholesky::factorize(const VectorXd& theta, const VectorXd& crossProduct) {
  below_.setZero();
  rest_.setZero();
  const int* position = positions_.data();
  for (const RandomStructure::Pair& pair : structure_.pairs_) {
    const MatrixXd left = structure_.templateOf(pair.first, theta).transpose();
    const MatrixXd right = structure_.templateOf(pair.second, theta);
    const Index rows = left.rows();
    const Index columns = right.rows();
    const bool diagonal = pair.first == pair.second;
    const double* block = crossProduct.data() + pair.valueOffset;
    MatrixXd product(rows, columns);
    for (size_t i = 0; i < pair.levels.size(); ++i, block += rows * columns) {
      // Both templates are triangles: what lies above their diagonals is left out. Of a diagonal block, the lower
      // triangle.
      for (Index column = 0; column < columns; ++column) {
        for (Index row = diagonal ? column : 0; row < rows; ++row) {
          double sum = diagonal && row == column ? 1 : 0;
          for (Index c = column; c < columns; ++c) {
            double inner = 0;
            for (Index r = row; r < rows; ++r) {
              inner += left(row, r) * block[c * rows + r];
            }
            sum += inner * right(c, column);
          }
          product(row, column) = sum;
        }
      }
      const auto [a, b] = pair.levels[i];
      if (sparse_) {
        for (Index column = 0; column < columns; ++column) {
          const Index skipped = diagonal ? column : 0;
          double* out = matrix_.valuePtr() + *position++;
          std::copy(&product(skipped, column), &product(0, column) + rows, out);
        }
      } else if (diagonal && pair.first == first_) {
        levelFactors_.middleCols(a * rows, rows) = product;
      } else if (pair.second == first_) {
        below_.block(placeOf(pair.first) + a * rows, b * columns, rows, columns) = product;
      } else if (pair.first == first_) {
        below_.block(placeOf(pair.second) + b * columns, a * rows, columns, rows) = product.transpose();
      } else {
        rest_.block(placeOf(pair.first) + a * rows, placeOf(pair.second) + b * columns, rows, columns) = product;
      }
    }
  }
  if (sparse_) {
    solver_.factorize(matrix_);
  } else {
    factorizeBlocks();
  }
}

void PenalizedCholesky::factorizeBlocks() {
  const Index width = levelFactors_.rows();
  if (structure_.terms_.size() == 1 && width == 1) {
    scalarDiagonal_ = levelFactors_.row(0).transpose();
  }
  for (Index column = 0; column < levelFactors_.cols(); column += width) {
    auto factor = levelFactors_.middleCols(column, width);
    for (Index j = 0; j < width; ++j) {
      factor(j, j) = std::sqrt(factor(j, j) - factor.row(j).head(j).squaredNorm());
      for (Index i = j + 1; i < width; ++i) {
        factor(i, j) = (factor(i, j) - factor.row(i).head(j).dot(factor.row(j).head(j))) / factor(j, j);
      }
      for (Index before = 0; before < j; ++before) {
        below_.col(column + j) -= factor(j, before) * below_.col(column + before);
      }
      below_.col(column + j) /= factor(j, j);
    }
  }
  if (rest_.size() > 0) {
    rest_.selfadjointView<Eigen::Lower>().rankUpdate(below_, -1);
    Eigen::LLT<Eigen::Ref<MatrixXd>> inPlace(rest_);
  }
}

double PenalizedCholesky::logDeterminant() const {
  if (!sparse_) {
    const Index width = levelFactors_.rows();
    double sum = rest_.diagonal().array().log().sum();
    for (Index column = 0; column < levelFactors_.cols(); ++column) {
      sum += std::log(levelFactors_(column % width, column));
    }
    return 2 * sum;
  }
  const Eigen::SparseMatrix<double>& lower = solver_.matrixL().nestedExpression();
  double sum = 0;
  for (Index column = 0; column < lower.cols(); ++column) {
    sum += std::log(lower.valuePtr()[lower.outerIndexPtr()[column]]);
  }
  return 2 * sum;
}

MatrixXd PenalizedCholesky::permuted(const MatrixXd& right) const {
  const Term& first = structure_.terms_[first_];
  const Index size = levelFactors_.cols();
  MatrixXd result(right.rows(), right.cols());
  result.topRows(size) = right.middleRows(first.offset, size);
  result.middleRows(size, first.offset) = right.topRows(first.offset);
  result.bottomRows(right.rows() - first.offset - size) = right.bottomRows(right.rows() - first.offset - size);
  return result;
}

MatrixXd PenalizedCholesky::forward(const MatrixXd& right) const {
  if (sparse_) {
    MatrixXd result = solver_.permutationP() * right;
    solver_.matrixL().solveInPlace(result);
    return result;
  }
  MatrixXd result = permuted(right);
  const Index width = levelFactors_.rows();
  const Index size = levelFactors_.cols();
  for (Index i = 0; i < result.cols(); ++i) {
    for (Index level = 0; level < size; level += width) {
      double* values = &result(level, i);
      for (Index row = 0; row < width; ++row) {
        for (Index before = 0; before < row; ++before) {
          values[row] -= levelFactors_(row, level + before) * values[before];
        }
        values[row] /= levelFactors_(row, level + row);
      }
    }
  }
  if (rest_.size() > 0) {
    auto bottom = result.bottomRows(rest_.rows());
    bottom.noalias() -= below_ * result.topRows(size);
    rest_.triangularView<Eigen::Lower>().solveInPlace(bottom);
  }
  return result;
}

VectorXd PenalizedCholesky::backward(const VectorXd& right) const {
  if (sparse_) {
    VectorXd result = right;
    solver_.matrixU().solveInPlace(result);
    return solver_.permutationPinv() * result;
  }
  const Term& first = structure_.terms_[first_];
  const Index width = levelFactors_.rows();
  const Index size = levelFactors_.cols();
  VectorXd bottom = right.tail(rest_.rows());
  VectorXd top = right.head(size);
  if (rest_.size() > 0) {
    rest_.triangularView<Eigen::Lower>().transpose().solveInPlace(bottom);
    top.noalias() -= below_.transpose() * bottom;
  }
  for (Index level = 0; level < size; level += width) {
    for (Index row = width - 1; row >= 0; --row) {
      for (Index after = row + 1; after < width; ++after) {
        top[level + row] -= levelFactors_(after, level + row) * top[level + after];
      }
      top[level + row] /= levelFactors_(row, level + row);
    }
  }
  VectorXd result(right.size());
  result << bottom.head(first.offset), top, bottom.tail(bottom.size() - first.offset);
  return result;
}

}  // namespace ocelli
