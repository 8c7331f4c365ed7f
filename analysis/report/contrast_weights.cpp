#include "analysis/report/contrast_weights.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace ocelli {
namespace {

using Weights = Estimable<std::vector<double>>;

/// 1 for the first level of a contrast, -1 for the second, 0 for others; the product over its factors.
struct Side {
  int sign = 1;
  std::vector<std::string> group{};  ///< the levels that it has of these factors
};

/// `levels`: what a condition, or a cell of the other factors, has.
Side sideOf(const std::vector<ContrastLevels>& compared, const FactorLevels& levels) {
  Side side;
  for (const ContrastLevels& each : compared) {
    const std::string& level = levels.at(each.factor);
    side.sign *= level == each.first ? 1 : level == each.second ? -1 : 0;
    side.group.push_back(level);
  }
  return side;
}

/// Of conditions: cells with the same levels of the factors that are not compared count alike in each group.
Weights ofConditions(const std::vector<ContrastLevels>& compared, const ViewConditions& conditions) {
  using Group = std::vector<std::string>;
  std::map<Group, std::map<Group, int>> cells;  // by group and levels of the other factors: how many conditions
  const auto otherLevels = [&](const ViewCondition& condition) {
    Group levels;
    for (const auto& [factor, level] : condition.levels) {
      if (std::none_of(compared.begin(), compared.end(), [&](const auto& each) { return each.factor == factor; })) {
        levels.push_back(level);
      }
    }
    return levels;
  };
  for (const ViewCondition& condition : conditions.list) {
    const Side side = sideOf(compared, condition.levels);
    if (side.sign != 0) {
      ++cells[side.group][otherLevels(condition)];
    }
  }
  if (cells.size() != size_t{1} << compared.size()) {
    return Weights::impossible("some of the levels that are compared have no condition");
  }
  const auto haveSameCells = [&](const auto& group) {
    const auto& first = cells.begin()->second;
    return std::equal(group.second.begin(), group.second.end(), first.begin(), first.end(),
                      [](const auto& a, const auto& b) { return a.first == b.first; });
  };
  if (!std::all_of(cells.begin(), cells.end(), haveSameCells)) {
    return Weights::impossible(
        "the factors are not crossed: the levels that are compared go with different levels of "
        "the other factors");
  }
  std::vector<double> weights;
  for (const ViewCondition& condition : conditions.list) {
    const Side side = sideOf(compared, condition.levels);
    const double alike =
        side.sign == 0 ? 1 : static_cast<double>(cells[side.group].size()) * cells[side.group][otherLevels(condition)];
    weights.push_back(side.sign / alike);
  }
  return weights;
}

/// Weights of conditions, and of their rows of the grid by what is compared of the other factors.
Weights overGrid(const std::vector<double>& ofConditions, const std::vector<ContrastLevels>& comparedElse,
                 const ConditionTerms& terms) {
  std::map<std::pair<size_t, std::vector<std::string>>, int> rows;
  for (const GridCell& cell : terms.grid()) {
    ++rows[{cell.condition, sideOf(comparedElse, cell.levels).group}];
  }
  std::vector<double> weights;
  for (const GridCell& cell : terms.grid()) {
    const Side side = sideOf(comparedElse, cell.levels);
    weights.push_back(ofConditions[cell.condition] * side.sign / rows[{cell.condition, side.group}]);
  }
  return weights;
}

std::string weightText(double weight) {
  return std::abs(weight) == 1 ? "" : fmt::format("{:g} ", std::abs(weight));
}

}  // namespace

Weights weightsOf(const PlannedContrast& contrast, const ConditionTerms& terms) {
  const ViewConditions& conditions = terms.conditions();
  std::vector<double> ofCondition(conditions.size(), 0.0);
  for (const auto& [name, weight] : contrast.weights) {
    const std::optional<TrialView> view = conditions.viewNamed(name);
    if (!view) {
      return Weights::impossible(fmt::format("the study has no condition \"{}\"", name));
    }
    ofCondition[indexOfCondition(*view)] = weight;
  }
  std::vector<ContrastLevels> ofConditionsCompared;
  std::vector<ContrastLevels> comparedElse;
  for (const ContrastLevels& each : contrast.levels) {
    const std::vector<std::string> levels = terms.levelsOf(each.factor);
    for (const std::string& level : {each.first, each.second}) {
      if (std::find(levels.begin(), levels.end(), level) == levels.end()) {
        return Weights::impossible(fmt::format("the study has no level \"{}\" of \"{}\"", level, each.factor));
      }
    }
    const StudyFactor* factor = terms.findFactor(each.factor);
    const bool isOfConditions = factor != nullptr && !factor->ofCases;
    if (!isOfConditions && !terms.grid().front().levels.contains(each.factor)) {
      return Weights::impossible(fmt::format("\"{}\" is no term of the model", each.factor));
    }
    for (const std::string& level : {each.first, each.second}) {
      const auto hasLevel = [&](const GridCell& cell) { return cell.levels.at(each.factor) == level; };
      if (!isOfConditions && std::none_of(terms.grid().begin(), terms.grid().end(), hasLevel)) {
        return Weights::impossible(fmt::format("no trial has the level \"{}\" of \"{}\"", level, each.factor));
      }
    }
    (isOfConditions ? ofConditionsCompared : comparedElse).push_back(each);
  }
  if (!ofConditionsCompared.empty()) {
    const Weights weights = ofConditions(ofConditionsCompared, conditions);
    if (!weights) {
      return weights;
    }
    ofCondition = *weights;
  } else if (contrast.weights.empty()) {
    std::fill(ofCondition.begin(), ofCondition.end(), 1 / static_cast<double>(conditions.size()));
  }
  return overGrid(ofCondition, comparedElse, terms);
}

std::vector<double> weightsOfCondition(size_t condition, const ConditionTerms& terms) {
  std::vector<double> ofCondition(terms.conditions().size(), 0.0);
  ofCondition[condition] = 1;
  return *overGrid(ofCondition, {}, terms);
}

std::vector<PlannedContrast> contrastsOf(const AnalysisPlan& plan, const PlannedModel& model,
                                         const ViewConditions& conditions) {
  std::vector<PlannedContrast> contrasts;
  std::copy_if(plan.contrasts.begin(), plan.contrasts.end(), std::back_inserter(contrasts),
               [&](const PlannedContrast& contrast) { return contrast.model == model.name; });
  if (!contrasts.empty()) {
    return contrasts;
  }
  const ViewCondition& first = conditions.list.front();
  for (size_t i = 1; i < conditions.size(); ++i) {
    const ViewCondition& other = conditions.list[i];
    PlannedContrast contrast;
    contrast.name = fmt::format("{}: {} / {}", model.name, other.name, first.name);
    contrast.statement = fmt::format("{} differs from {}", other.label, first.label);
    contrast.model = model.name;
    contrast.family = model.name;
    contrast.weights = {{other.name, 1}, {first.name, -1}};
    contrasts.push_back(std::move(contrast));
  }
  return contrasts;
}

std::string comparisonText(const PlannedContrast& contrast) {
  std::vector<std::string> parts;
  for (const ContrastLevels& each : contrast.levels) {
    parts.push_back(fmt::format("{} ({} / {})", each.factor, each.first, each.second));
  }
  if (!parts.empty()) {
    return fmt::format("{}", fmt::join(parts, " x "));
  }
  const auto& weights = contrast.weights;
  if (weights.size() == 2 && weights[0].second == 1 && weights[1].second == -1) {
    return fmt::format("{} / {}", weights[0].first, weights[1].first);
  }
  std::string text = "weights";
  for (const auto& [name, weight] : weights) {
    const bool isFirst = text == "weights";
    const char* sign = weight < 0 ? (isFirst ? " -" : " - ") : isFirst ? " " : " + ";
    text += fmt::format("{}{}{}", sign, weightText(weight), name);
  }
  return text;
}

}  // namespace ocelli
