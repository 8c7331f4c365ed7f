// The tasks of studies, a row each. Nothing outside of a task's own files knows its name: what depends on the task asks
// its row. tests/house/check_tasks.py finds who does otherwise.
//
// Recipe for a new task, two places and a line:
//   1. study/tasks/NAME_task.cpp: a TaskBlock and its reader, a TrialRun (study/task/task.h), a TaskPolicy
//      (study/agent/task_policy.h), and a function that makes the row of them.
//   2. study/tasks/task_registry.cpp: that function, at the end of the table.
//   3. The name of the file in the CMakeLists.txt beside it.
// Then its fields in protocols/protocol.schema.json, an example in tests/study_task/study_tasks.cpp, with which the
// tests of the contract run, and its section of docs/protocols.md. `nearer`, in study/tasks/nearer_task.cpp, is the
// example. Screens, databases, replays and exports take it as it is: what is its own goes into TrialOutcome::measures.
//
// A program outside of the tree registers a row of its own with registerTask(): examples/add_a_task/main.cpp.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/registry.h"
#include "study/agent/task_policy.h"
#include "study/task/instruction_image.h"
#include "study/task/task.h"
#include "study/tasks/generator_model.h"

namespace ocelli {

class JsonFields;

/// What a trial of a task tells. It all stands in the database, as `correct`, `censored` and the time.
enum class OutcomeKind : uint8_t {
  kTime,    ///< how long it takes: right once it is done, censored where time runs out before
  kAnswer,  ///< whether an answer is right
  /// A number, and how far it is from the truth: its measures tell it (study/trial/estimated_value.h). `correct` says
  /// whether it is as near as the block asks for; censored where no answer came.
  kEstimate,
};

struct TaskKind {
  std::string name;         ///< in protocols, databases and exports; it stays for ever
  std::string description;  ///< what the subject is to do, in a few words
  OutcomeKind outcome = OutcomeKind::kAnswer;
  /// Reads the fields of the task from those of a block; others are left for the caller to ask for, and to reject.
  /// `caseField` names the field that holds the cases: "cases", or "practice_cases". Throws InputError naming the field
  /// for what is wrong or cannot be: objects in walls, more cases than places, impossible durations.
  std::shared_ptr<const TaskBlock> (*read)(JsonFields& fields, const std::string& caseField,
                                           const TaskSetting& setting) = nullptr;
  /// What a simulated observer does in a trial.
  std::unique_ptr<TaskPolicy> (*policy)(const PolicySetting& setting) = nullptr;
  GeneratorModel generator;
  /// What pages of instructions may show of it.
  std::vector<InstructionImage> images{};
};

/// In the order in which the data-only subject draws its numbers: new rows come at the end, then those that were
/// registered. A row stays where it is until the program ends. Any thread may call it at any time.
Rows<TaskKind> taskKinds();

/// Adds a row: from then on protocols may name it. Any thread may call it at any time; it is best done before anything
/// else, and by every program that reads such a protocol, or a database of one. Throws InputError where the name is
/// taken, or is not all of small letters, as it stands in files' names, and where `read`, `policy`, or an effect that
/// generator_model.h asks for is missing.
void registerTask(TaskKind kind);

/// "find, count, path, ...".
std::string taskNames();

/// Throws InputError, saying `where`, for a name that no task has.
const TaskKind& taskKind(std::string_view name, const std::string& where);

/// The image of any task with this name; null for a name that none has.
const InstructionImage* instructionImage(std::string_view name);

}  // namespace ocelli
