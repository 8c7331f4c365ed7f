#include "study/protocol/block_staircase.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr const char* kLevelField = "level";
constexpr double kMinLevel = 1e-6;
constexpr double kMaxLevel = 1e6;
constexpr int kMaxStaircaseTrials = 500;

/// Calls `read` for each case; the task has checked their other fields.
void forEachCase(JsonFields& fields, const std::string& caseField, const std::function<void(JsonFields&)>& read) {
  const nlohmann::json& cases = fields.value(caseField);
  size_t index = 0;
  fields.forEach(caseField, 0, cases.size(), [&](JsonFields& each) {
    for (const auto& [name, value] : cases[index].items()) {
      each.has(name);
    }
    ++index;
    read(each);
  });
}

void refuseLevels(JsonFields& fields, const std::string& caseField, const std::string& why) {
  if (!fields.has(caseField)) {
    return;
  }
  forEachCase(fields, caseField, [&](JsonFields& each) {
    if (each.has(kLevelField)) {
      each.fail(kLevelField, why);
    }
  });
}

/// By case.
std::vector<double> readLevelsOfCases(JsonFields& fields) {
  std::vector<double> levels;
  forEachCase(fields, "cases", [&](JsonFields& each) {
    const double level = each.number(kLevelField, kMinLevel, kMaxLevel);
    if (std::find(levels.begin(), levels.end(), level) != levels.end()) {
      each.fail(kLevelField, fmt::format("is {:g}, which another case of the block has", level));
    }
    levels.push_back(level);
  });
  return levels;
}

double readGuessRate(JsonFields& fields, const TaskBlock& task) {
  if (fields.has("guess_rate")) {
    return fields.number("guess_rate", 0, 0.95);
  }
  if (task.choiceCount() < 1) {
    fields.fail("guess_rate", "is missing: this task does not say how likely it is to be right by guessing");
  }
  return 1.0 / task.choiceCount();
}

}  // namespace

size_t BlockStaircase::levelOf(int caseIndex) const {
  const auto found = std::find(cases.begin(), cases.end(), caseIndex);
  OC_CHECK(found != cases.end(), "each case has a level");
  return static_cast<size_t>(found - cases.begin());
}

std::vector<double> BlockStaircase::levelsByCase() const {
  std::vector<double> byCase(cases.size());
  for (size_t i = 0; i < cases.size(); ++i) {
    byCase[static_cast<size_t>(cases[i])] = levels[i];
  }
  return byCase;
}

std::shared_ptr<const BlockStaircase> readBlockStaircase(JsonFields& fields, const TaskBlock& task,
                                                         ViewsOfCases views) {
  for (const char* caseField : {"practice_cases", "example_cases"}) {
    refuseLevels(fields, caseField, "is for the field \"cases\": a staircase chooses among these alone");
  }
  if (!fields.has("staircase")) {
    refuseLevels(fields, "cases", "is of no use without the field \"staircase\" of the block");
    return nullptr;
  }
  JsonFields of = fields.inner("staircase");
  if (views == ViewsOfCases::kOne) {
    fields.fail("views", "is \"one\", but each condition has a staircase of its own, over all cases");
  }
  const std::vector<double> byCase = readLevelsOfCases(fields);
  if (byCase.size() < 2) {
    fields.fail("cases", "has a single level: a staircase needs two at least");
  }
  auto staircase = std::make_shared<BlockStaircase>();
  staircase->cases.resize(byCase.size());
  std::iota(staircase->cases.begin(), staircase->cases.end(), 0);
  std::sort(staircase->cases.begin(), staircase->cases.end(),
            [&](int a, int b) { return byCase[static_cast<size_t>(a)] < byCase[static_cast<size_t>(b)]; });
  for (const int each : staircase->cases) {
    staircase->levels.push_back(byCase[static_cast<size_t>(each)]);
  }
  std::vector<std::string> names;
  for (const StaircaseMethod& method : staircaseMethods()) {
    names.emplace_back(method.name);
  }
  staircase->method = of.choice("method", names);
  staircase->trials = of.integer("trials", 2, kMaxStaircaseTrials, staircase->trials);
  const auto method = std::find(names.begin(), names.end(), staircase->method);
  const StaircaseMethod& row = staircaseMethods()[static_cast<size_t>(method - names.begin())];
  staircase->rule = row.read(of, staircase->levels, readGuessRate(of, task));
  of.rejectUnknown();
  return staircase;
}

}  // namespace ocelli
