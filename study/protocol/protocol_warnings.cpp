#include "study/protocol/protocol_warnings.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <map>

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
    std::map<std::string, std::array<int, kViews.size()>> counts;
    for (const TrialPlan& trial : schedule.trials) {
      if (trial.block == index) {
        for (const std::string& condition : conditionsOf(block.task->caseInfo(trial.caseIndex))) {
          ++counts[condition][static_cast<size_t>(trial.view)];
        }
      }
    }
    for (const auto& [condition, byView] : counts) {
      if (std::abs(byView[0] - byView[1]) > 1) {
        warnings.push_back(fmt::format(
            "block \"{}\": a subject sees {} {} times with {} and {} times with {}. Give the cases at even "
            "places of the list and those at odd ones the same conditions",
            block.name, condition, byView[0], protocol.nameOf(kViews[0]), byView[1], protocol.nameOf(kViews[1])));
      }
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
  } else if (block.views == ViewsOfCases::kBoth && block.task->caseCount() < 3) {
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
    if (protocol.shuffleBlocks && blockOrdersOf(protocol, session).size() == 2) {
      warnings.push_back(
          fmt::format("session {}: with two orders of blocks, first view and the view of a case come "
                      "together evenly after each 8 subjects only",
                      session));
    }
  }
  return warnings;
}

}  // namespace ocelli
