#include "study/protocol/condition_order.h"

#include <algorithm>
#include <numeric>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

int modulo(int value, int by) {
  return ((value % by) + by) % by;
}

/// The row that begins with `first`: first + 0, + 1, - 1, + 2, ..., or backwards first - 0, - 1, + 1, ...
std::vector<int> rowFrom(int first, bool backward, int conditions) {
  std::vector<int> row;
  for (int i = 0; i < conditions; ++i) {
    const int step = i % 2 == 1 ? (i + 1) / 2 : -(i / 2);
    row.push_back(modulo(first + (backward ? -step : step), conditions));
  }
  return row;
}

/// 0 to `count` - 1 in an order whose differences from 0, 1, 2, ... are all different too, or of an even count all but
/// one: so that orders of blocks go neither with first conditions nor with assignments.
int spread(int index, int count) {
  return (2 * index) % count + (count % 2 == 0 && index >= count / 2 ? 1 : 0);
}

/// The cases of one pass that are still to come, by condition.
class Pass {
 public:
  Pass(int cases, int conditions, int shift, Random& random) : left_(static_cast<size_t>(conditions)), random_(random) {
    for (int i = 0; i < cases; ++i) {
      left_[static_cast<size_t>(modulo(i + shift, conditions))].push_back(i);
    }
    for (std::vector<int>& list : left_) {
      random_.shuffle(list);
    }
  }

  bool isEmpty() const {
    return std::all_of(left_.begin(), left_.end(), [](const auto& list) { return list.empty(); });
  }
  /// The row without the conditions that no case is left of.
  std::vector<int> runOf(std::vector<int> row) const {
    std::erase_if(row, [&](int condition) { return left_[static_cast<size_t>(condition)].empty(); });
    return row;
  }
  /// The next case of the condition: another than `last` where there is one.
  int take(int condition, int last) {
    std::vector<int>& list = left_[static_cast<size_t>(condition)];
    if (list.back() == last && list.size() > 1) {
      std::swap(list.back(), list[random_.below(list.size() - 1)]);
    }
    const int taken = list.back();
    list.pop_back();
    return taken;
  }

 private:
  std::vector<std::vector<int>> left_;
  Random& random_;
};

}  // namespace

std::vector<std::vector<int>> williamsRows(int conditions) {
  std::vector<std::vector<int>> rows;
  for (const bool backward : {false, true}) {
    for (int first = 0; first < conditions && (!backward || conditions % 2 == 1); ++first) {
      rows.push_back(rowFrom(first, backward, conditions));
    }
  }
  return rows;
}

ConditionLevels conditionLevelsOf(int slot, int sessionsBefore, int conditions, int orders) {
  OC_CHECK(slot >= 0 && sessionsBefore >= 0, "slots count from 0");
  OC_CHECK(conditions >= 1 && orders >= 1, "there are conditions and orders of blocks");
  const int run = slot / conditions;
  ConditionLevels levels;
  levels.first = modulo(slot + sessionsBefore, conditions);
  levels.backward = conditions % 2 == 1 && run % 2 == 1;
  levels.assignment = modulo(slot + run + sessionsBefore, conditions);
  // In so many slots all orders come equally often, but each with one of `shared` first conditions only.
  const int shared = std::gcd(conditions, orders);
  const int round = slot / std::lcm(conditions, orders);
  levels.order = modulo(slot + spread(round % shared, shared) + round / shared, orders);
  return levels;
}

std::vector<CaseInCondition> trialsInRuns(int cases, int conditions, bool all, const ConditionLevels& levels,
                                          Random& random) {
  std::vector<CaseInCondition> trials;
  int step = 0;  // of d, from run to run
  const auto nextRun = [&](const Pass& pass) {
    if (trials.empty()) {
      return pass.runOf(rowFrom(levels.first, levels.backward, conditions));
    }
    const auto last = static_cast<int>(indexOfCondition(trials.back().view));
    std::vector<int> run;
    // Once round at most, where one condition alone is left.
    for (int tries = 0; tries < std::max(1, conditions - 1); ++tries) {
      const int d = conditions == 1 ? 0 : 1 + step++ % (conditions - 1);
      run = pass.runOf(rowFrom(modulo(last + (levels.backward ? -d : d), conditions), levels.backward, conditions));
      if (run.front() != last) {
        break;
      }
    }
    return run;
  };
  for (int number = 0; number < (all ? conditions : 1); ++number) {
    Pass pass(cases, conditions, levels.assignment + number, random);
    while (!pass.isEmpty()) {
      for (const int condition : nextRun(pass)) {
        const int last = trials.empty() ? -1 : trials.back().caseIndex;
        trials.push_back({pass.take(condition, last), conditionAt(static_cast<size_t>(condition))});
      }
    }
  }
  return trials;
}

std::vector<CaseInCondition> trialsInTurn(int cases, int conditions, bool all) {
  std::vector<CaseInCondition> trials;
  for (int pass = 0; pass < (all ? conditions : 1); ++pass) {
    for (int i = 0; i < cases; ++i) {
      trials.push_back({i, conditionAt(static_cast<size_t>((i + pass) % conditions))});
    }
  }
  return trials;
}

}  // namespace ocelli
