// A block whose cases are the levels of a stimulus: which of them a trial shows depends on the answers before, in a
// staircase of its own for each condition (staircase.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "study/outline/block_outline.h"
#include "study/protocol/staircase.h"
#include "study/task/task.h"

namespace ocelli {

class JsonFields;

struct BlockStaircase {
  std::string method;                     ///< its name in staircaseMethods()
  std::shared_ptr<const Staircase> rule;  ///< of `levels`
  int trials = 40;                        ///< in each condition; then it stops
  std::vector<double> levels;             ///< ascending
  std::vector<int> cases;                 ///< of the block, by level

  /// A case to stand for those that are not known yet: that of the level in the middle.
  int middleCase() const { return cases[cases.size() / 2]; }
  /// Index of the level of a case.
  size_t levelOf(int caseIndex) const;
  /// By case.
  std::vector<double> levelsByCase() const;
};

/// The field "staircase" of a block and the levels of its "cases"; null where it has none, and then no case has a
/// level. The practice and example cases of a block have none. Throws InputError naming the field.
std::shared_ptr<const BlockStaircase> readBlockStaircase(JsonFields& fields, const TaskBlock& task, ViewsOfCases views);

}  // namespace ocelli
