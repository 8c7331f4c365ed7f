// A study as its protocol file describes it (protocols/protocol.schema.json, docs/protocols.md).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/outline/block_outline.h"
#include "study/outline/exclusion_rule.h"
#include "study/outline/form_outline.h"
#include "study/outline/screen_fields.h"
#include "study/outline/subject_texts.h"
#include "study/protocol/block_staircase.h"
#include "study/task/task.h"

namespace ocelli {

/// The keys and what they do.
inline constexpr const char* kControlsImage = "controls";

/// A trial whose first moment a page shows, as the trial itself would: with the block's own cameras and options.
struct PageExample {
  std::shared_ptr<const TaskBlock> task;  ///< of the block's example cases
  TrialPlan plan;
};

/// A page of text that is shown until a key is pressed.
struct ProtocolPage {
  std::string title;
  std::vector<std::string> paragraphs;
  /// An image that the program draws: one of a task's row (study/tasks/task_registry.h), or kControlsImage; empty for
  /// none.
  std::string image{};
  std::shared_ptr<const PageExample> example{};  ///< shown in place of an image; null for none
};

enum class TrialOrder {
  kAlternating,  ///< cases in the order of the file, views in turn: the order of the original study
  kBalanced,     ///< shuffled anew for each subject; no case twice in a row; views in turn, counterbalanced
};
inline constexpr std::array kTrialOrders = {TrialOrder::kAlternating, TrialOrder::kBalanced};
struct ProtocolPractice {
  std::shared_ptr<const TaskBlock> task;
  int minCorrect = PracticeOutline().minCorrect;
  int maxTrials = PracticeOutline().maxTrials;
  bool eachView = PracticeOutline().eachView;
};

struct ProtocolBlock {
  std::string name;   ///< unique: "find stationary"
  std::string title;  ///< for the subject
  std::string taskName;
  std::shared_ptr<const TaskBlock> task;
  std::shared_ptr<const TaskBlock> examples{};  ///< of the example cases, for pages; null where there are none
  std::vector<ProtocolPage> instructions;
  std::optional<ProtocolPractice> practice{};
  TrialOrder order = TrialOrder::kBalanced;
  ViewsOfCases views = ViewsOfCases::kAll;
  std::shared_ptr<const BlockStaircase> staircase{};  ///< chooses the cases; null where the schedule does
  bool feedback = false;                              ///< after each trial; practice always has it
  int breakEveryTrials = 0;                           ///< a break after so many trials; 0 for none within the block
  bool breakAfter = true;
  std::vector<int> sessions{};             ///< that have this block, from 1; empty for all
  std::vector<FactorLevels> caseLevels{};  ///< of each case; empty where the block has no factors of cases
  std::vector<ProtocolForm> after{};       ///< asked once its trials are done
};

struct ScreenGeometry {
  double widthMillimeters = 518;  ///< of what is lit
  double heightMillimeters = 324;
  double distanceMillimeters = 600;  ///< from the eye
  int minWidth = 1024;               ///< pixels
  int minHeight = 640;
  std::optional<double> refreshHertz{};  ///< that the monitor must have
  std::optional<double> gamma{};         ///< as the monitor is set; stated, not measured
  std::optional<CalibrationWishes> calibration{};
  bool photodiodePatch = false;  ///< a square in the lower left corner, white in every other frame of a trial
};

enum class ResumePolicy { kNextTrial, kRestartBlock, kStop };
inline constexpr std::array kResumePolicies = {ResumePolicy::kNextTrial, ResumePolicy::kRestartBlock,
                                               ResumePolicy::kStop};

struct Protocol {
  std::string name;  ///< letters, digits and -
  std::string title;
  std::string description{};
  std::filesystem::path file{};
  std::string text;    ///< of the file, byte by byte; included mazes stand in it, and tables of cases
  std::string sha256;  ///< of `text`, hexadecimal
  uint64_t seed = 1;   ///< of schedules and trials
  int sessions = 1;
  int minutesBetweenSessions = 0;
  SubjectTexts texts{};  ///< of the language that subjects read, the field "language"
  std::optional<ProtocolPage> consent{};
  std::optional<ProtocolForm> demographics{};
  std::vector<ProtocolForm> before{};  ///< asked in every session before the welcome
  std::vector<ProtocolPage> welcome{};
  std::vector<ProtocolBlock> blocks;
  bool shuffleBlocks = false;         ///< their order is counterbalanced over subjects
  bool gaze = false;                  ///< sessions may record where subjects look, and the consent says so
  int breakSeconds = 60;              ///< the least length of a break
  std::vector<ProtocolForm> after{};  ///< asked at the end of every session, before the survey
  std::optional<ProtocolForm> survey{};
  bool surveyAfterLastSessionOnly = true;
  Controls controls{};
  ScreenGeometry screen{};
  TimingLimits timing{};
  ResumePolicy resume = ResumePolicy::kNextTrial;
  std::vector<ExclusionRule> exclusions{};
  StudyConditions conditions{};

  /// Of a condition, as databases and exports write it.
  const std::string& nameOf(TrialView view) const { return conditions.names.nameOf(view); }
};

/// All of its forms: demographics, those before, those after each block, those after, survey.
std::vector<const ProtocolForm*> formsOf(const Protocol& protocol);

/// A protocol that can be run. Throws InputError that says the file, the field and what to do.
Protocol readProtocol(const std::filesystem::path& path);
/// The same from text that a database holds.
Protocol protocolFromJsonText(const std::string& text, const std::string& where);

const char* nameOf(TrialOrder order);
const char* nameOf(ResumePolicy policy);

}  // namespace ocelli
