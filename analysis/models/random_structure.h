// The sparse algebra of random effects, for any number of crossed or nested terms (Bates, Maechler, Bolker, Walker
// 2015, Fitting linear mixed-effects models using lme4, J. Stat. Softw. 67(1), sections 2.2, 3.2).
//
// Random effects are b = Lambda(theta) u with u of variance I, times the residual variance where there is one. Z,
// Lambda and Z'WZ are kept in blocks: a term of k effects has a k x k template of Lambda and k columns of Z for each
// level. theta holds the templates' lower triangles column by column, or their diagonals where effects are not
// correlated.
//
// Inside, columns of Z have a root mean square of 1, so that theta is of order 1 whatever the units; thetaOf() and
// effectsOf() give the caller's units back.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "analysis/models/design.h"

namespace ocelli {

class RandomStructure {
 public:
  struct Term {
    Eigen::Index offset = 0;       ///< of its first effect in u
    Eigen::Index thetaOffset = 0;  ///< of its first value in theta
    int width = 1;                 ///< k, effects a level
    int levels = 0;
    bool correlated = true;
    std::vector<int> levelOfRow{};
    Eigen::MatrixXd rows{};    ///< k x rows, scaled
    Eigen::VectorXd scales{};  ///< of the k columns
  };

  RandomStructure(const std::vector<RandomTerm>& terms, Eigen::Index rows);

  Eigen::Index rows() const { return rows_; }
  Eigen::Index size() const { return size_; }            ///< of u and b
  Eigen::Index thetaSize() const { return thetaSize_; }  ///< of theta
  const std::vector<Term>& terms() const { return terms_; }
  Eigen::VectorXd startTheta() const;  ///< templates of 1

  /// k x k, lower triangle.
  Eigen::MatrixXd templateOf(size_t term, const Eigen::VectorXd& theta) const;
  /// The sign of a template's column is free: -1 for all theta of a column whose diagonal is negative, otherwise 1.
  Eigen::VectorXd signsOf(const Eigen::VectorXd& theta) const;
  /// Where the diagonals are in theta.
  std::vector<Eigen::Index> diagonals() const;

  /// The blocks of Z'WZ; `weights` of the rows.
  Eigen::VectorXd crossProduct(const Eigen::VectorXd& weights) const;
  Eigen::MatrixXd transposedTimes(const Eigen::MatrixXd& matrix) const;  ///< Z' matrix
  Eigen::VectorXd times(const Eigen::VectorXd& b) const;                 ///< Z b
  /// Lambda u, and Lambda' matrix in place.
  Eigen::VectorXd lambdaTimes(const Eigen::VectorXd& theta, const Eigen::VectorXd& u) const;
  void multiplyByLambdaTransposed(const Eigen::VectorXd& theta, Eigen::MatrixXd& matrix) const;

  // In the caller's units.
  Eigen::VectorXd thetaOf(const Eigen::VectorXd& scaled) const;
  Eigen::VectorXd scaledThetaOf(const Eigen::VectorXd& theta) const;
  Eigen::MatrixXd covarianceOf(size_t term, const Eigen::VectorXd& scaledTheta) const;  ///< k x k, relative
  Eigen::MatrixXd effectsOf(size_t term, const Eigen::VectorXd& b) const;               ///< levels x k
  /// Variance of Z b in each row, relative: what the random effects add to it.
  Eigen::VectorXd rowVariances(const Eigen::VectorXd& scaledTheta) const;

 private:
  friend class PenalizedCholesky;

  /// Levels of two terms that meet in some row.
  struct Pair {
    size_t first = 0;  ///< rows of the lower triangle: first >= second
    size_t second = 0;
    Eigen::Index valueOffset = 0;
    std::vector<int> blockOfRow{};
    std::vector<std::pair<int, int>> levels{};  ///< of each block
  };
  Pair makePair(size_t first, size_t second) const;

  Eigen::Index rows_;
  Eigen::Index size_ = 0;
  Eigen::Index thetaSize_ = 0;
  std::vector<Term> terms_{};
  std::vector<Pair> pairs_{};
  Eigen::Index valueCount_ = 0;
};

/// L with L L' = P (Lambda' Z'WZ Lambda + I) P'. The term of the most effects comes first, level by level: its part of
/// the matrix has no blocks but those of its levels. Where the other terms are few effects, their remaining part is
/// factored as a whole matrix; otherwise all of it as a sparse one, whose order of elimination and places of values are
/// found once.
class PenalizedCholesky {
 public:
  explicit PenalizedCholesky(const RandomStructure& structure);

  void factorize(const Eigen::VectorXd& theta, const Eigen::VectorXd& crossProduct);
  double logDeterminant() const;                                 ///< log |L L'|
  Eigen::MatrixXd forward(const Eigen::MatrixXd& right) const;   ///< L^-1 P right
  Eigen::VectorXd backward(const Eigen::VectorXd& right) const;  ///< P' L^-T right
  /// Of Lambda' Z'WZ Lambda + I, where there is one term of one effect a level.
  const Eigen::VectorXd& scalarDiagonal() const { return scalarDiagonal_; }

 private:
  using Term = RandomStructure::Term;
  void prepareSparse();
  void factorizeBlocks();
  /// Where a term's effects are once the first term's are.
  Eigen::Index placeOf(size_t term) const;
  Eigen::MatrixXd permuted(const Eigen::MatrixXd& right) const;

  const RandomStructure& structure_;
  size_t first_ = 0;  ///< the term that comes first
  bool sparse_ = false;
  Eigen::VectorXd scalarDiagonal_{};

  // Blocks: the factors of the first term's levels side by side, k x k each; the rest by the first; the rest.
  Eigen::MatrixXd levelFactors_{};
  Eigen::MatrixXd below_{};
  Eigen::MatrixXd rest_{};

  // Sparse.
  Eigen::SparseMatrix<double> matrix_{};  ///< lower triangle
  std::vector<int> positions_{};          ///< in its values, of the first value of each column of each block
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver_{};
};

}  // namespace ocelli
