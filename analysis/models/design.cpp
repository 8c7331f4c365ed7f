#include "analysis/models/design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr double kRankTolerance = 1e-7;

void checkLength(size_t length, Eigen::Index rows, const std::string& name) {
  if (static_cast<Eigen::Index>(length) != rows) {
    throw InputError(fmt::format("{} values for {} rows", length, rows), name, "one value a row");
  }
}

/// Appends the column to an orthonormal basis and its triangle unless the basis determines it.
bool extendBasis(const Eigen::VectorXd& column, Design& design) {
  // Scaled first, so that squares of large values stay finite.
  const double scale = column.size() > 0 ? column.lpNorm<Eigen::Infinity>() : 0;
  if (scale == 0) {
    return false;
  }
  Eigen::VectorXd rest = column / scale;
  const double length = rest.norm();
  const Eigen::Index size = design.basis.cols();
  Eigen::VectorXd coordinates = Eigen::VectorXd::Zero(size);
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::VectorXd more = design.basis.transpose() * rest;
    rest -= design.basis * more;
    coordinates += more;
  }
  const double left = rest.norm();
  if (left < kRankTolerance * length) {
    return false;
  }
  design.basis.conservativeResize(column.size(), size + 1);
  design.basis.col(size) = rest / left;
  design.triangle.conservativeResize(size + 1, size + 1);
  design.triangle.row(size).setZero();
  design.triangle.col(size).head(size) = coordinates * scale;
  design.triangle(size, size) = left * scale;
  return true;
}

void checkRandomTerm(const RandomTerm& term, Eigen::Index rows) {
  checkLength(term.levelOfRow.size(), rows, term.group);
  const auto levels = static_cast<int>(term.levels.size());
  const bool inside = std::all_of(term.levelOfRow.begin(), term.levelOfRow.end(),
                                  [&](int level) { return level >= 0 && level < levels; });
  if (!inside || term.columns.rows() != rows || term.columns.cols() != static_cast<Eigen::Index>(term.names.size()) ||
      term.names.empty()) {
    throw InputError("levels or columns of the random effects do not fit the rows", term.group,
                     "randomIntercepts() and addSlope()");
  }
  if (!term.columns.allFinite()) {
    throw InputError("a random slope has a value that is not finite", term.group, "rows without missing values");
  }
}

}  // namespace

FixedEffects::FixedEffects(Eigen::Index rows) : columns_(rows, 0) {}

FixedEffects::Term& FixedEffects::startTerm(const std::string& name) {
  if (std::any_of(terms_.begin(), terms_.end(), [&](const Term& term) { return term.name == name; })) {
    throw InputError("there is a term of this name", name, "another name");
  }
  return terms_.emplace_back(Term{name, {}});
}

void FixedEffects::addColumn(Term& term, const std::string& name, const Eigen::VectorXd& values) {
  const Eigen::Index index = columns_.cols();
  columns_.conservativeResize(Eigen::NoChange, index + 1);
  columns_.col(index) = values;
  names_.push_back(name);
  term.columns.push_back(index);
}

void FixedEffects::addIntercept() {
  addColumn(startTerm("(intercept)"), "(intercept)", Eigen::VectorXd::Ones(rows()));
}

void FixedEffects::addNumber(const std::string& name, const std::vector<double>& values) {
  checkLength(values.size(), rows(), name);
  for (size_t row = 0; row < values.size(); ++row) {
    if (!std::isfinite(values[row])) {
      throw InputError("the value is not a finite number", fmt::format("{}, row {}", name, row + 1),
                       "rows without missing values");
    }
  }
  addColumn(startTerm(name), name, Eigen::Map<const Eigen::VectorXd>(values.data(), rows()));
}

void FixedEffects::addFactor(const std::string& name, const std::vector<std::string>& labels,
                             const std::vector<std::string>& levels, Coding coding) {
  checkLength(labels.size(), rows(), name);
  Term& term = startTerm(name);
  Eigen::MatrixXd indicators = Eigen::MatrixXd::Zero(rows(), static_cast<Eigen::Index>(levels.size()));
  for (size_t row = 0; row < labels.size(); ++row) {
    const auto level = std::find(levels.begin(), levels.end(), labels[row]);
    if (level == levels.end()) {
      throw InputError(fmt::format("\"{}\" is not one of its levels", labels[row]),
                       fmt::format("{}, row {}", name, row + 1), "rows of these levels, or more levels");
    }
    indicators(static_cast<Eigen::Index>(row), level - levels.begin()) = 1;
  }
  const double center = coding == Coding::kCentered ? 1 / static_cast<double>(levels.size()) : 0;
  for (size_t level = 1; level < levels.size(); ++level) {
    addColumn(term, fmt::format("{}={}", name, levels[level]),
              indicators.col(static_cast<Eigen::Index>(level)).array() - center);
  }
}

void FixedEffects::addInteraction(const std::string& first, const std::string& second) {
  const std::vector<Eigen::Index> firstColumns = columnsOf(first);
  const std::vector<Eigen::Index> secondColumns = columnsOf(second);
  Term& term = startTerm(fmt::format("{}:{}", first, second));
  for (const Eigen::Index b : secondColumns) {
    for (const Eigen::Index a : firstColumns) {
      const std::string name = fmt::format("{}:{}", names_[static_cast<size_t>(a)], names_[static_cast<size_t>(b)]);
      addColumn(term, name, columns_.col(a).cwiseProduct(columns_.col(b)));
    }
  }
}

std::vector<Eigen::Index> FixedEffects::columnsOf(const std::string& term) const {
  const auto found = std::find_if(terms_.begin(), terms_.end(), [&](const Term& each) { return each.name == term; });
  if (found == terms_.end()) {
    throw InputError("there is no such term", term, "a term that was added before");
  }
  return found->columns;
}

RandomTerm randomIntercepts(const std::string& group, const std::vector<std::string>& levelOfRow) {
  RandomTerm term;
  term.group = group;
  term.levels = levelOfRow;
  std::sort(term.levels.begin(), term.levels.end());
  term.levels.erase(std::unique(term.levels.begin(), term.levels.end()), term.levels.end());
  for (const std::string& label : levelOfRow) {
    const auto level = std::lower_bound(term.levels.begin(), term.levels.end(), label);
    term.levelOfRow.push_back(static_cast<int>(level - term.levels.begin()));
  }
  term.names = {"(intercept)"};
  term.columns = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(levelOfRow.size()), 1);
  return term;
}

void addSlope(RandomTerm& term, const std::string& fixedTerm, const FixedEffects& fixed) {
  checkLength(term.levelOfRow.size(), fixed.rows(), term.group);
  for (const Eigen::Index column : fixed.columnsOf(fixedTerm)) {
    const Eigen::Index index = term.columns.cols();
    term.columns.conservativeResize(fixed.rows(), index + 1);
    term.columns.col(index) = fixed.columns().col(column);
    term.names.push_back(fixed.names()[static_cast<size_t>(column)]);
  }
}

std::vector<std::string> nestedLevels(const std::vector<std::string>& outer, const std::vector<std::string>& inner) {
  checkLength(inner.size(), static_cast<Eigen::Index>(outer.size()), "nested levels");
  std::vector<std::string> nested;
  for (size_t row = 0; row < outer.size(); ++row) {
    nested.push_back(fmt::format("{}/{}", outer[row], inner[row]));
  }
  return nested;
}

Eigen::MatrixXd Design::rowsLike(const FixedEffects& other) const {
  Eigen::MatrixXd rows(other.rows(), fixed.cols());
  for (size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] >= other.columns().cols() || other.names()[static_cast<size_t>(kept[i])] != fixedNames[i]) {
      throw InputError("the columns are not those of the model", fixedNames[i], "the same terms in the same order");
    }
    rows.col(static_cast<Eigen::Index>(i)) = other.columns().col(kept[i]);
  }
  return rows;
}

Design makeDesign(const FixedEffects& fixed, const std::vector<RandomTerm>& random) {
  Design design;
  design.basis.resize(fixed.rows(), 0);
  for (Eigen::Index column = 0; column < fixed.columns().cols(); ++column) {
    const std::string& name = fixed.names()[static_cast<size_t>(column)];
    if (extendBasis(fixed.columns().col(column), design)) {
      design.kept.push_back(column);
      design.fixedNames.push_back(name);
    } else {
      const bool zero = fixed.columns().col(column).isZero(0);
      design.dropped.push_back({name, zero ? "it is 0 in every row" : "the columns before it determine it"});
    }
  }
  design.fixed.resize(fixed.rows(), static_cast<Eigen::Index>(design.kept.size()));
  for (size_t i = 0; i < design.kept.size(); ++i) {
    design.fixed.col(static_cast<Eigen::Index>(i)) = fixed.columns().col(design.kept[i]);
  }
  for (const RandomTerm& term : random) {
    checkRandomTerm(term, fixed.rows());
  }
  design.random = random;
  return design;
}

std::optional<std::string> whyImpossible(const Design& design, bool needsReplicates) {
  if (design.rows() == 0) {
    return "there are no rows";
  }
  if (design.rows() <= design.fixed.cols()) {
    return fmt::format("{} rows are too few for {} fixed effects", design.rows(), design.fixed.cols());
  }
  if (design.random.empty()) {
    return "the model has no random effects";
  }
  for (const RandomTerm& term : design.random) {
    if (term.levels.size() < 2) {
      return fmt::format("there is only one {}, whose variance cannot be told", term.group);
    }
    const size_t effects = term.levels.size() * term.names.size();
    if (needsReplicates && static_cast<Eigen::Index>(effects) >= design.rows()) {
      return fmt::format("{} random effects of {} cannot be told from the residuals of {} rows", effects, term.group,
                         design.rows());
    }
    for (Eigen::Index effect = 0; effect < term.columns.cols(); ++effect) {
      if (term.columns.col(effect).isZero(0)) {
        return fmt::format("{} by {} is 0 in every row", term.names[static_cast<size_t>(effect)], term.group);
      }
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
