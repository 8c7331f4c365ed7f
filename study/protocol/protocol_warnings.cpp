#include "study/protocol/protocol_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "study/outline/study_factors.h"
#include "study/protocol/session_length.h"

namespace ocelli {
namespace {

constexpr double kLongSession = 60 * 60;
constexpr const char* kPlaceholder = "[fill in:";

/// What a case is apart from its label, by factor.
std::vector<std::string> conditionsOf(const CaseInfo& info) {
  std::vector<std::string> conditions;
  if (info.exposureSeconds) {
    conditions.push_back(fmt::format("exposure of {:g} s", *info.exposureSeconds));
  }
  if (info.objects) {
    conditions.push_back(fmt::format("{} objects", *info.objects));
  }
  if (info.duplicateColors) {
    conditions.emplace_back(*info.duplicateColors ? "duplicate colours" : "unique colours");
  }
  return conditions;
}

/// Of blocks whose cases are seen in one view each: whether that view goes with a condition.
void addConfounded(const Protocol& protocol, const SessionSchedule& schedule, std::vector<std::string>& warnings) {
  for (const int index : schedule.blockOrder) {
    const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(index)];
    const ViewConditions& views = protocol.conditions.names;
    std::map<std::string, std::vector<int>> counts;
    for (const TrialPlan& trial : schedule.trials) {
      if (trial.block == index) {
        for (const std::string& condition : conditionsOf(block.task->caseInfo(trial.caseIndex))) {
          std::vector<int>& byView = counts.try_emplace(condition, views.size()).first->second;
          ++byView[indexOfCondition(trial.view)];
        }
      }
    }
    for (const auto& [condition, byView] : counts) {
      const auto [least, most] = std::minmax_element(byView.begin(), byView.end());
      if (*most - *least <= 1) {
        continue;
      }
      std::string times;
      for (size_t i = 0; i < byView.size(); ++i) {
        const char* before = i == 0 ? "" : i + 1 == byView.size() ? " and " : ", ";
        times += fmt::format("{}{} times with {}", before, byView[i], views.list[i].name);
      }
      warnings.push_back(fmt::format(
          "block \"{}\": a subject sees {} {}. Give the cases at {} the same conditions", block.name, condition, times,
          views.isPair() ? std::string("even places of the list and those at odd ones")
                         : fmt::format("places 1, {0} + 1, 2 x {0} + 1, ... of the list, those "
                                       "at places 2, {0} + 2, ... and so on",
                                       views.size())));
    }
  }
}

/// Of a consent that is still the sample: what is to be filled in.
void addPlaceholders(const ProtocolPage& consent, std::vector<std::string>& warnings) {
  std::vector<std::string> texts = consent.paragraphs;
  texts.insert(texts.begin(), consent.title);
  for (const std::string& text : texts) {
    for (size_t at = text.find(kPlaceholder); at != std::string::npos; at = text.find(kPlaceholder, at + 1)) {
      const size_t end = text.find(']', at);
      warnings.push_back(
          fmt::format("the consent still says \"{}\": put your own words there, as your review board "
                      "approved them",
                      text.substr(at, end == std::string::npos ? end : end + 1 - at)));
    }
  }
}

void addOfStaircase(const ProtocolBlock& block, std::vector<std::string>& warnings) {
  constexpr int kFewTrials = 20;
  constexpr size_t kFewLevels = 5;
  if (block.staircase->trials < kFewTrials) {
    warnings.push_back(
        fmt::format("block \"{}\": its staircases stop after {} trials each: thresholds of fewer than {} "
                    "are rough",
                    block.name, block.staircase->trials, kFewTrials));
  }
  if (block.staircase->levels.size() < kFewLevels) {
    warnings.push_back(fmt::format("block \"{}\": its staircases have {} levels to choose from: give {} or more",
                                   block.name, block.staircase->levels.size(), kFewLevels));
  }
}

void addOfBlock(const Protocol& protocol, const ProtocolBlock& block, std::vector<std::string>& warnings) {
  if (!block.practice) {
    warnings.push_back(fmt::format("block \"{}\": there is no practice, so its first trials are it", block.name));
  }
  if (block.instructions.empty()) {
    warnings.push_back(fmt::format("block \"{}\": there are no instructions", block.name));
  }
  if (block.order == TrialOrder::kAlternating) {
    warnings.push_back(
        fmt::format("block \"{}\": all subjects see the same cases in the same views at the same "
                    "places, so differences between views include those of learning",
                    block.name));
  } else if (block.staircase) {
    addOfStaircase(block, warnings);
  } else if (const auto conditions = static_cast<int>(protocol.conditions.names.size());
             conditions > 2 && block.task->caseCount() % conditions != 0) {
    warnings.push_back(fmt::format(
        "block \"{}\": {} cases are no multiple of the {} conditions, so the last run of each pass does not "
        "hold all conditions, and neighbours are balanced only nearly",
        block.name, block.task->caseCount(), conditions));
  } else if (conditions == 2 && block.views == ViewsOfCases::kAll && block.task->caseCount() < 3) {
    warnings.push_back(
        fmt::format("block \"{}\": with fewer than 3 cases one comes twice in a row, in both views", block.name));
  }
  if (block.feedback) {
    warnings.push_back(fmt::format("block \"{}\": feedback after each trial trains subjects on", block.name));
  }
  if (block.breakEveryTrials == 0 && protocol.breakSeconds == 0 && block.breakAfter) {
    warnings.push_back(fmt::format("block \"{}\": the break after it is of 0 seconds", block.name));
  }
}

}  // namespace

std::vector<std::string> warningsOf(const Protocol& protocol, uint64_t seed) {
  std::vector<std::string> warnings;
  if (const SubjectCatalogue& catalogue = protocol.texts.catalogue(); catalogue.isDraft) {
    warnings.push_back(fmt::format(
        "the fixed texts in {} ({}) are a draft: nobody whose first language it is has read them yet. Have them read, "
        "protocols/languages/{}.json",
        catalogue.name, catalogue.language, catalogue.language));
  }
  if (protocol.gaze && !protocol.consent) {
    warnings.push_back("where subjects look may be recorded, and no consent tells them so");
  }
  const FactorCrossing crossing = crossingOf(protocol.conditions.names);
  if (!crossing.missing.empty()) {
    warnings.push_back(
        fmt::format("no condition has the levels {}: contrasts of factors that need these cells cannot be "
                    "estimated",
                    fmt::join(crossing.missing, "; ")));
  }
  if (!crossing.doubled.empty()) {
    warnings.push_back(fmt::format("several conditions have the levels {}: contrasts of factors take their mean",
                                   fmt::join(crossing.doubled, "; ")));
  }
  if (!protocol.consent) {
    warnings.emplace_back("there is no consent: nobody is asked whether they want to take part");
  } else {
    addPlaceholders(*protocol.consent, warnings);
  }
  if (!protocol.demographics) {
    warnings.emplace_back("there are no demographics: results cannot be told by age, experience or vision");
  }
  if (protocol.sessions > 1 && protocol.minutesBetweenSessions == 0) {
    warnings.emplace_back("sessions may follow one another at once, as \"minutes_between_sessions\" is 0");
  }
  for (const ProtocolBlock& block : protocol.blocks) {
    addOfBlock(protocol, block, warnings);
  }
  for (int session = 1; session <= protocol.sessions; ++session) {
    const SessionSchedule schedule = scheduleOf(protocol, 0, session, seed);
    if (session == 1) {
      addConfounded(protocol, schedule, warnings);
    }
    const double seconds = durationOf(partsOf(protocol, schedule)).typicalSeconds;
    if (seconds > kLongSession) {
      warnings.push_back(fmt::format("session {} takes about {:.0f} minutes: people tire after {:.0f}", session,
                                     seconds / 60, kLongSession / 60));
    }
    if (protocol.conditions.names.isPair() && protocol.shuffleBlocks && blockOrdersOf(protocol, session).size() == 2) {
      warnings.push_back(
          fmt::format("session {}: with two orders of blocks, first view and the view of a case come "
                      "together evenly after each 8 subjects only",
                      session));
    }
  }
  return warnings;
}

}  // namespace ocelli
