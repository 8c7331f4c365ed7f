// What a mixed model is made of: a matrix of fixed effects with named columns, and random effects of grouping factors.
//
//   FixedEffects fixed(rows);
//   fixed.addIntercept();
//   fixed.addFactor("view", views, {"flat", "bent"}, Coding::kCentered);
//   fixed.addNumber("session", sessions);
//   fixed.addInteraction("view", "session");
//   RandomTerm subjects = randomIntercepts("subject", subjectOfRow);
//   addSlope(subjects, "view", fixed);
//   const Design design = makeDesign(fixed, {subjects, randomIntercepts("item", itemOfRow)});
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace ocelli {

/// How the columns of a factor stand for its levels. Either way a coefficient is the difference from the first level.
enum class Coding {
  kTreatment,  ///< 0 or 1: other effects are those at the first level
  kCentered,   ///< less 1 / levels, so that two levels are -0.5 and 0.5: other effects are means over the levels
};

/// Columns of fixed effects as they are asked for: they may depend on each other. Throws InputError for values that
/// are not finite, lengths that differ, labels that are no level, and names that are taken or not there.
class FixedEffects {
 public:
  explicit FixedEffects(Eigen::Index rows);

  void addIntercept();  ///< "(intercept)"
  void addNumber(const std::string& name, const std::vector<double>& values);
  /// A column for each level but the first, "view=bent". `labels`: one a row, each of them one of `levels`.
  void addFactor(const std::string& name, const std::vector<std::string>& labels,
                 const std::vector<std::string>& levels, Coding coding);
  /// The products of the columns of two terms that were added, "view=bent:session". Is a term itself: "view:session".
  void addInteraction(const std::string& first, const std::string& second);

  Eigen::Index rows() const { return columns_.rows(); }
  const Eigen::MatrixXd& columns() const { return columns_; }  ///< rows x columns
  const std::vector<std::string>& names() const { return names_; }
  /// Where the columns of a term are.
  std::vector<Eigen::Index> columnsOf(const std::string& term) const;

 private:
  struct Term {
    std::string name;
    std::vector<Eigen::Index> columns;
  };
  Term& startTerm(const std::string& name);
  void addColumn(Term& term, const std::string& name, const Eigen::VectorXd& values);

  Eigen::MatrixXd columns_;
  std::vector<std::string> names_{};
  std::vector<Term> terms_{};
};

/// Effects that each level of a grouping factor draws: an intercept, slopes, or both.
struct RandomTerm {
  std::string group;                ///< "subject"
  std::vector<std::string> levels;  ///< sorted
  std::vector<int> levelOfRow;
  std::vector<std::string> names;  ///< of the effects: "(intercept)", "view=bent"
  Eigen::MatrixXd columns;         ///< rows x effects: what they are multiplied with
  bool correlated = true;          ///< or each with a variance only
};

RandomTerm randomIntercepts(const std::string& group, const std::vector<std::string>& levelOfRow);

/// Adds the columns of a fixed term as slopes.
void addSlope(RandomTerm& term, const std::string& fixedTerm, const FixedEffects& fixed);

/// Levels within levels: "s01/2" is the second session of subject s01.
std::vector<std::string> nestedLevels(const std::vector<std::string>& outer, const std::vector<std::string>& inner);

struct DroppedColumn {
  std::string name;
  std::string reason;  ///< a whole clause
};

struct Design {
  Eigen::MatrixXd fixed;                ///< rows x columns, of full column rank
  std::vector<std::string> fixedNames;  ///< of its columns
  std::vector<Eigen::Index> kept;       ///< where these columns were among those that were asked for
  std::vector<DroppedColumn> dropped;
  std::vector<RandomTerm> random;

  /// fixed = basis * triangle, with orthonormal columns and an upper triangle.
  Eigen::MatrixXd basis;
  Eigen::MatrixXd triangle;

  Eigen::Index rows() const { return fixed.rows(); }
  /// Rows with other values of the same columns, such as "all of them in the second view", for predictions.
  Eigen::MatrixXd rowsLike(const FixedEffects& other) const;
};

/// Drops the columns that those before them determine, as R does: what a column adds is less than 1e-7 of its length.
/// Throws InputError where the random terms do not fit the rows.
Design makeDesign(const FixedEffects& fixed, const std::vector<RandomTerm>& random);

/// Why no model can be estimated from rows such as these; none where one may. `needsReplicates`: the model has a
/// residual variance or a response of 0 or 1 a row, and so there must be fewer random effects than rows.
std::optional<std::string> whyImpossible(const Design& design, bool needsReplicates);

}  // namespace ocelli
