// What every block of a protocol has, whatever its task.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "study/outline/protocol_reading.h"

namespace ocelli {

class JsonFields;

enum class ViewsOfCases : uint8_t {
  kAll,  ///< each case is seen in all conditions: "all", or "both", which is the older word
  kOne,  ///< each case is seen in one condition, counterbalanced over subjects where the order is balanced
};

struct PracticeOutline {
  int minCorrect = 1;  ///< in a row, to go on
  int maxTrials = 8;   ///< then the experimenter is called; not read by analyses
  /// One view after the other, each until the criterion is met in it: both numbers are of each view. Else the views
  /// take turns, and the criterion asks for no view in particular.
  bool eachView = false;
};

struct BlockOutline {
  std::string name;   ///< unique: "find stationary"
  std::string title;  ///< for the subject
  std::string task;   ///< whether there is such a task is for the caller to check
  ViewsOfCases views = ViewsOfCases::kAll;
  std::optional<PracticeOutline> practice{};
};

/// Reads "name", "title", "task", "views" and "practice". After the name has been read, messages call the object
/// "... (name)". An analysis takes a block without a title, which is then its name. Throws InputError naming the field.
BlockOutline readBlockOutline(JsonFields& fields, ProtocolReading reading);

/// A name of letters, digits, "-" and, where `spaces` says so, spaces.
std::string readIdentifier(JsonFields& fields, const std::string& name, bool spaces);

}  // namespace ocelli
