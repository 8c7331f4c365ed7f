#include "analysis/report/planned_design.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ocelli {
namespace {

/// Of a group, so that a variance of their slopes is more than a difference of two.
constexpr int kMinSlopeLevels = 3;
constexpr int kMinTrialsOfValue = 2;
constexpr double kClearErrors = 4;

double numberOf(const Trial& trial, const std::string& term) {
  if (term == "session") {
    return trial.session;
  }
  if (term == "exposure") {
    return *trial.exposureSeconds;
  }
  return term == "objects" ? *trial.objects : trial.planIndex;
}

void addTerm(FixedEffects& fixed, const std::string& term, const TrialList& trials) {
  std::vector<std::string> labels;
  std::vector<double> numbers;
  double sum = 0;
  for (const Trial* trial : trials) {
    if (term == "view") {
      labels.push_back(markOf(trial->view));
    } else if (term == "moving") {
      labels.push_back(*trial->moving ? "moving" : "stationary");
    } else if (term == "duplicates") {
      labels.push_back(*trial->duplicateColors ? "shared" : "different");
    } else {
      numbers.push_back(numberOf(*trial, term));
      sum += numbers.back();
    }
  }
  if (term == "view") {
    fixed.addFactor(term, labels, {kReferenceMark, kOtherMark}, Coding::kCentered);
  } else if (term == "moving") {
    fixed.addFactor(term, labels, {"stationary", "moving"}, Coding::kCentered);
  } else if (term == "duplicates") {
    fixed.addFactor(term, labels, {"different", "shared"}, Coding::kCentered);
  } else {
    for (double& number : numbers) {
      number -= sum / static_cast<double>(trials.size());
    }
    fixed.addNumber(term, numbers);
  }
}

std::vector<std::string> levelsOf(const TrialList& trials, const std::string& group) {
  if (group == "subject") {
    return subjectsOf(trials);
  }
  std::vector<std::string> items;
  items.reserve(trials.size());
  for (const Trial* trial : trials) {
    items.push_back(trial->item());
  }
  return items;
}

/// How many levels show how the term acts in them.
int levelsThatShow(const RandomTerm& term, const Eigen::VectorXd& column) {
  std::vector<std::map<double, int>> trialsOfValue(term.levels.size());
  for (Eigen::Index row = 0; row < column.size(); ++row) {
    ++trialsOfValue[static_cast<size_t>(term.levelOfRow[static_cast<size_t>(row)])][column[row]];
  }
  return static_cast<int>(std::count_if(trialsOfValue.begin(), trialsOfValue.end(), [](const auto& values) {
    return std::count_if(values.begin(), values.end(),
                         [](const auto& value) { return value.second >= kMinTrialsOfValue; }) >= 2;
  }));
}

}  // namespace

FixedEffects plannedColumns(const PlannedModel& model, const TrialList& trials, bool intercept) {
  FixedEffects fixed(static_cast<Eigen::Index>(trials.size()));
  if (intercept) {
    fixed.addIntercept();
  }
  for (const std::string& term : model.terms) {
    const size_t colon = term.find(':');
    if (colon == std::string::npos) {
      addTerm(fixed, term, trials);
    } else {
      fixed.addInteraction(term.substr(0, colon), term.substr(colon + 1));
    }
  }
  return fixed;
}

std::string columnOf(const FixedEffects& fixed, const std::string& term) {
  const std::vector<Eigen::Index> columns = fixed.columnsOf(term);
  return columns.empty() ? "" : fixed.names()[static_cast<size_t>(columns.front())];
}

FittedStructure structureByDesign(const PlannedModel& model, const TrialList& trials) {
  const FixedEffects fixed = plannedColumns(model, trials, false);
  FittedStructure structure{model.randomEffects};
  for (const SlopePlace& place : slopesOf(structure)) {
    const RandomEffect& effect = structure.effects[place.effect];
    const RandomTerm term = randomIntercepts(effect.group, levelsOf(trials, effect.group));
    const std::string& slope = effect.slopes[place.slope];
    const int levels = levelsThatShow(term, fixed.columns().col(fixed.columnsOf(slope).front()));
    const size_t effects = term.levels.size() * (1 + effect.slopes.size());
    if (levels < kMinSlopeLevels) {
      structure = withoutSlope(
          structure, place,
          fmt::format(
              "{} of {} have {} or more trials at each of two of its values, and {} are needed to tell how they "
              "differ in it",
              levels, term.levels.size(), kMinTrialsOfValue, kMinSlopeLevels));
    } else if (effects >= trials.size()) {
      structure = withoutSlope(structure, place,
                               fmt::format("{} trials are too few for {} random effects", trials.size(), effects));
    }
  }
  return structure;
}

std::vector<SlopePlace> slopesOf(const FittedStructure& structure) {
  std::vector<SlopePlace> places;
  for (const bool cases : {true, false}) {
    for (size_t effect = 0; effect < structure.effects.size(); ++effect) {
      if ((structure.effects[effect].group == "case") == cases) {
        // From the last one on, so that those before keep their places.
        for (size_t slope = structure.effects[effect].slopes.size(); slope-- > 0;) {
          places.push_back({effect, slope});
        }
      }
    }
  }
  return places;
}

FittedStructure withoutSlope(const FittedStructure& structure, const SlopePlace& place, const std::string& why) {
  FittedStructure simpler = structure;
  RandomEffect& effect = simpler.effects[place.effect];
  simpler.reasons.push_back(
      fmt::format("the slope of {} by {} is left out: {}", effect.slopes[place.slope], effect.group, why));
  effect.slopes.erase(effect.slopes.begin() + static_cast<std::ptrdiff_t>(place.slope));
  return simpler;
}

double relativeDeviation(const MixedModelFit& fit, const SlopePlace& place) {
  // Behind the intercept.
  return fit.random[place.effect].relativeDeviations[static_cast<Eigen::Index>(place.slope) + 1];
}

bool isClear(const MixedModelFit& fit, const SlopePlace& place) {
  // Without correlations theta has a value for each effect, term by term.
  Eigen::Index index = static_cast<Eigen::Index>(place.slope) + 1;
  for (size_t i = 0; i < place.effect; ++i) {
    index += static_cast<Eigen::Index>(fit.random[i].names.size());
  }
  const double variance = fit.varianceParameterCovariance(index, index);
  return variance > 0 && relativeDeviation(fit, place) > kClearErrors * std::sqrt(variance);
}

std::string structureText(const std::vector<RandomEffect>& effects) {
  std::vector<std::string> all;
  for (const RandomEffect& effect : effects) {
    std::vector<std::string> columns{"1"};
    columns.insert(columns.end(), effect.slopes.begin(), effect.slopes.end());
    all.push_back(
        fmt::format("({} {} {})", fmt::join(columns, " + "), effect.slopes.empty() ? "|" : "||", effect.group));
  }
  return fmt::format("{}", fmt::join(all, " + "));
}

Design plannedDesign(const PlannedModel& model, const TrialList& trials, const FittedStructure& structure) {
  const FixedEffects fixed = plannedColumns(model, trials, true);
  std::vector<RandomTerm> random;
  for (const RandomEffect& effect : structure.effects) {
    RandomTerm term = randomIntercepts(effect.group, levelsOf(trials, effect.group));
    for (const std::string& slope : effect.slopes) {
      addSlope(term, slope, fixed);
    }
    term.correlated = false;
    random.push_back(std::move(term));
  }
  return makeDesign(fixed, random);
}

}  // namespace ocelli
