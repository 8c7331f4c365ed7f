#include "analysis/report/condition_terms.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/models/design.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

std::vector<std::string> partsOf(const std::string& term) {
  std::vector<std::string> parts;
  for (size_t at = 0; at <= term.size();) {
    const size_t end = std::min(term.find(':', at), term.size());
    parts.push_back(term.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// Of a trial that has the value.
double covariateOf(const Trial& trial, const std::string& factor) {
  return factor == "session"    ? trial.session
         : factor == "exposure" ? *trial.exposureSeconds
         : factor == "objects"  ? *trial.objects
                                : trial.planIndex;
}

}  // namespace

CaseFactors::CaseFactors(const Dataset& data) {
  for (size_t source = 0; source < data.sources.size(); ++source) {
    if (data.sources[source].protocolText.empty()) {
      continue;
    }
    for (const ProtocolBlockFacts& block :
         protocolFacts(data.sources[source].protocolText, data.sources[source].path).blocks) {
      for (size_t i = 0; i < block.cases.size(); ++i) {
        levels_[{static_cast<int>(source), block.name, static_cast<int>(i)}] = block.cases[i].levels;
      }
    }
  }
}

const FactorLevels& CaseFactors::of(const Trial& trial) const {
  const auto found = levels_.find({trial.source, trial.block, trial.caseIndex});
  return found == levels_.end() ? none_ : found->second;
}

ConditionTerms::ConditionTerms(const Dataset& data, const PlannedModel& model, const TrialList& trials)
    : data_(data), model_(model), cases_(data) {
  if (!problem().empty()) {
    return;
  }
  std::set<std::string> used;
  const auto add = [&](const std::string& term) {
    for (const std::string& part : partsOf(term)) {
      used.insert(part);
    }
  };
  std::for_each(model.terms.begin(), model.terms.end(), add);
  for (const RandomEffect& effect : model.randomEffects) {
    std::for_each(effect.slopes.begin(), effect.slopes.end(), add);
  }
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(trials_), [&](const Trial* trial) {
    return std::all_of(used.begin(), used.end(), [&](const std::string& factor) { return hasValue(*trial, factor); });
  });
  leaveOutTerms();
  makeGrid();
}

bool ConditionTerms::varies(const std::string& factor) const {
  if (!levelsOf(factor).empty()) {
    const std::vector<std::string> labels = labelsOf(factor);
    return std::adjacent_find(labels.begin(), labels.end(), std::not_equal_to<>()) != labels.end();
  }
  return std::any_of(trials_.begin(), trials_.end(), [&](const Trial* trial) {
    return covariateOf(*trial, factor) != covariateOf(*trials_.front(), factor);
  });
}

void ConditionTerms::leaveOutTerms() {
  for (const std::string& term : model_.terms) {
    const std::vector<std::string> parts = partsOf(term);
    const auto constant = std::find_if(parts.begin(), parts.end(), [&](const auto& part) { return !varies(part); });
    if (constant == parts.end() || trials_.empty()) {
      terms_.push_back(term);
    } else {
      leftOut_.push_back(fmt::format("the term {} is left out: {} is the same in all trials", term, *constant));
    }
  }
}

std::string ConditionTerms::problem() const {
  std::set<std::string> before;
  const auto isKnown = [&](const std::string& factor) {
    static const std::set<std::string> kNumbers{"session", "exposure", "objects", "trial"};
    return kNumbers.contains(factor) || !levelsOf(factor).empty();
  };
  std::vector<std::string> all = model_.terms;
  for (const RandomEffect& effect : model_.randomEffects) {
    all.insert(all.end(), effect.slopes.begin(), effect.slopes.end());
  }
  for (const std::string& term : all) {
    for (const std::string& part : partsOf(term)) {
      if (!isKnown(part)) {
        return fmt::format("the protocol has no factor \"{}\"", part);
      }
    }
  }
  for (const std::string& term : model_.terms) {
    const size_t colon = term.find(':');
    if (colon != std::string::npos &&
        (!before.contains(term.substr(0, colon)) || !before.contains(term.substr(colon + 1)))) {
      return fmt::format("the term {} needs {} and {} as terms before it", term, term.substr(0, colon),
                         term.substr(colon + 1));
    }
    before.insert(term);
  }
  return "";
}

const StudyFactor* ConditionTerms::findFactor(const std::string& name) const {
  const std::vector<StudyFactor>& factors = data_.conditions.factors;
  const auto found =
      std::find_if(factors.begin(), factors.end(), [&](const StudyFactor& each) { return each.name == name; });
  return found == factors.end() ? nullptr : &*found;
}

std::vector<std::string> ConditionTerms::levelsOf(const std::string& factor) const {
  if (factor == "view") {
    std::vector<std::string> names;
    for (const ViewCondition& condition : data_.conditions.list) {
      names.push_back(condition.name);
    }
    return names;
  }
  if (factor == "moving") {
    return {"stationary", "moving"};
  }
  if (factor == "duplicates") {
    return {"different", "shared"};
  }
  const StudyFactor* found = findFactor(factor);
  return found == nullptr ? std::vector<std::string>{} : found->levels;
}

bool ConditionTerms::isCategorical(const std::string& term) const {
  const std::vector<std::string> parts = partsOf(term);
  return std::all_of(parts.begin(), parts.end(), [&](const std::string& part) { return !levelsOf(part).empty(); });
}

bool ConditionTerms::hasValue(const Trial& trial, const std::string& factor) const {
  const StudyFactor* found = findFactor(factor);
  return (factor != "moving" || trial.moving) && (factor != "duplicates" || trial.duplicateColors) &&
         (factor != "exposure" || trial.exposureSeconds) && (factor != "objects" || trial.objects) &&
         (found == nullptr || !found->ofCases || cases_.of(trial).contains(factor));
}

std::string ConditionTerms::labelOf(const Trial& trial, const std::string& factor) const {
  if (factor == "moving") {
    return *trial.moving ? "moving" : "stationary";
  }
  if (factor == "duplicates") {
    return *trial.duplicateColors ? "shared" : "different";
  }
  return labelOf(GridCell{indexOfCondition(trial.view), cases_.of(trial)}, factor);
}

std::string ConditionTerms::labelOf(const GridCell& cell, const std::string& factor) const {
  const ViewCondition& condition = data_.conditions.list.at(cell.condition);
  if (factor == "view") {
    return condition.name;
  }
  const StudyFactor* found = findFactor(factor);
  return found != nullptr && !found->ofCases ? condition.levels.at(factor) : cell.levels.at(factor);
}

std::vector<std::string> ConditionTerms::labelsOf(const std::string& term) const {
  std::vector<std::string> labels;
  for (const Trial* trial : trials_) {
    std::string label;
    for (const std::string& part : partsOf(term)) {
      label += (label.empty() ? "" : "/") + labelOf(*trial, part);
    }
    labels.push_back(label);
  }
  return labels;
}

void ConditionTerms::makeGrid() {
  for (size_t i = 0; i < data_.conditions.size(); ++i) {
    grid_.push_back({i});
  }
  std::set<std::string> crossed;
  for (const std::string& term : terms_) {
    for (const std::string& part : partsOf(term)) {
      const StudyFactor* factor = findFactor(part);
      const bool isOfConditions = part == "view" || (factor != nullptr && !factor->ofCases);
      if (isOfConditions || levelsOf(part).empty() || !crossed.insert(part).second) {
        continue;
      }
      // Of a level without trials a model says nothing: means are those over the others.
      const std::vector<std::string> labels = labelsOf(part);
      const std::set<std::string> seen(labels.begin(), labels.end());
      std::vector<GridCell> finer;
      for (const GridCell& cell : grid_) {
        for (const std::string& level : levelsOf(part)) {
          if (seen.contains(level)) {
            finer.push_back(cell);
            finer.back().levels[part] = level;
          }
        }
      }
      grid_ = std::move(finer);
    }
  }
}

FixedEffects ConditionTerms::columns() const {
  FixedEffects fixed(static_cast<Eigen::Index>(trials_.size()));
  fixed.addIntercept();
  for (const std::string& term : terms_) {
    const size_t colon = term.find(':');
    if (colon != std::string::npos) {
      fixed.addInteraction(term.substr(0, colon), term.substr(colon + 1));
    } else if (isCategorical(term)) {
      fixed.addFactor(term, labelsOf(term), levelsOf(term), Coding::kCentered);
    } else {
      std::vector<double> numbers;
      double sum = 0;
      for (const Trial* trial : trials_) {
        numbers.push_back(covariateOf(*trial, term));
        sum += numbers.back();
      }
      for (double& number : numbers) {
        number -= sum / static_cast<double>(trials_.size());
      }
      fixed.addNumber(term, numbers);
    }
  }
  return fixed;
}

FixedEffects ConditionTerms::gridColumns() const {
  FixedEffects fixed(static_cast<Eigen::Index>(grid_.size()));
  fixed.addIntercept();
  for (const std::string& term : terms_) {
    const size_t colon = term.find(':');
    if (colon != std::string::npos) {
      fixed.addInteraction(term.substr(0, colon), term.substr(colon + 1));
    } else if (isCategorical(term)) {
      std::vector<std::string> labels;
      for (const GridCell& cell : grid_) {
        labels.push_back(labelOf(cell, term));
      }
      fixed.addFactor(term, labels, levelsOf(term), Coding::kCentered);
    } else {
      fixed.addNumber(term, std::vector<double>(grid_.size(), 0.0));
    }
  }
  return fixed;
}

}  // namespace ocelli
