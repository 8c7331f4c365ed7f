#include "study/outline/study_factors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr size_t kMaxFactors = 6;
constexpr size_t kMaxLevels = 16;
constexpr size_t kMaxFactorCharacters = 60;

/// Factors name terms of analyses, which ":" joins, and columns of tables.
void checkFactorName(const JsonFields& fields, const std::string& name) {
  static const std::set<std::string> kTaken{"view",       "condition", "session", "moving", "exposure",
                                            "duplicates", "objects",   "trial",   "label",  "subject"};
  const auto isAllowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (!std::all_of(name.begin(), name.end(), isAllowed) || !(name.front() >= 'a' && name.front() <= 'z')) {
    fields.fail("name", "must be of small letters, digits and _, and begin with a letter");
  }
  if (kTaken.contains(name)) {
    fields.fail("name", fmt::format("is \"{}\", which analyses use for something else", name));
  }
}

bool isOf(const StudyFactor& factor, FactorsOf of) {
  return factor.ofCases == (of == FactorsOf::kCases);
}

}  // namespace

std::vector<StudyFactor> readFactors(JsonFields& protocol) {
  std::vector<StudyFactor> factors;
  std::set<std::string> names;
  protocol.forEach("factors", 0, kMaxFactors, [&](JsonFields& each) {
    StudyFactor factor;
    factor.name = each.shortText("name", kMaxFactorCharacters);
    checkFactorName(each, factor.name);
    if (!names.insert(factor.name).second) {
      each.fail("name", fmt::format("is \"{}\", as that of an earlier factor", factor.name));
    }
    factor.levels = each.texts("levels", 2, kMaxLevels, kMaxFactorCharacters);
    if (std::set<std::string>(factor.levels.begin(), factor.levels.end()).size() != factor.levels.size()) {
      each.fail("levels", "must be different from each other");
    }
    factor.ofCases = each.choice("of", {"conditions", "cases"}, "conditions") == "cases";
    factors.push_back(std::move(factor));
  });
  return factors;
}

FactorLevels readLevels(JsonFields& owner, const std::vector<StudyFactor>& factors, FactorsOf of) {
  FactorLevels levels;
  const bool isAsked = std::any_of(factors.begin(), factors.end(), [&](const auto& each) { return isOf(each, of); });
  if (!owner.has("factors") && !isAsked) {
    return levels;
  }
  if (!owner.has("factors")) {
    owner.fail("factors", "is missing, but the protocol declares factors that need a level here");
  }
  JsonFields fields = owner.inner("factors");
  for (const StudyFactor& factor : factors) {
    if (isOf(factor, of)) {
      levels[factor.name] = fields.choice(factor.name, factor.levels);
    }
  }
  fields.rejectUnknown();
  return levels;
}

std::vector<StudyFactor> factorsOf(const ViewConditions& conditions, FactorsOf of) {
  std::vector<StudyFactor> factors;
  std::copy_if(conditions.factors.begin(), conditions.factors.end(), std::back_inserter(factors),
               [&](const StudyFactor& factor) { return isOf(factor, of); });
  return factors;
}

std::vector<std::vector<std::string>> cellsOf(const std::vector<StudyFactor>& factors) {
  std::vector<std::vector<std::string>> cells{{}};
  for (const StudyFactor& factor : factors) {
    std::vector<std::vector<std::string>> finer;
    for (const std::vector<std::string>& cell : cells) {
      for (const std::string& level : factor.levels) {
        finer.push_back(cell);
        finer.back().push_back(level);
      }
    }
    cells = std::move(finer);
  }
  return cells;
}

FactorCrossing crossingOf(const ViewConditions& conditions) {
  FactorCrossing crossing;
  const std::vector<StudyFactor> factors = factorsOf(conditions, FactorsOf::kConditions);
  if (factors.empty()) {
    return crossing;
  }
  for (const std::vector<std::string>& cell : cellsOf(factors)) {
    std::vector<std::string> names;
    for (const ViewCondition& condition : conditions.list) {
      bool isInCell = true;
      for (size_t i = 0; i < factors.size(); ++i) {
        isInCell = isInCell && condition.levels.at(factors[i].name) == cell[i];
      }
      if (isInCell) {
        names.push_back(condition.name);
      }
    }
    if (names.empty()) {
      crossing.missing.push_back(fmt::format("{}", fmt::join(cell, ", ")));
    } else if (names.size() > 1) {
      crossing.doubled.push_back(fmt::format("{} ({})", fmt::join(cell, ", "), fmt::join(names, ", ")));
    }
  }
  return crossing;
}

}  // namespace ocelli
