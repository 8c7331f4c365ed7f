#include "study/protocol/session_length.h"

#include <algorithm>

#include "study/outline/question_kinds.h"

namespace ocelli {
namespace {

// Reading at 150 to 230 words a minute, with a look at the page; a choice of a form; the pause between two trials.
constexpr double kTypicalPage = 3;
constexpr double kTypicalWord = 60.0 / 230;
constexpr double kLongestPage = 15;
constexpr double kLongestWord = 60.0 / 150;
constexpr Duration kField{6, 20};
constexpr Duration kBetweenTrials{1.5, 5};
constexpr double kLongestRest = 2;  ///< times the least length of a break

Duration readingTime(const ProtocolPage& page) {
  size_t words = 0;
  for (const std::string& paragraph : page.paragraphs) {
    words += 1 + static_cast<size_t>(std::count(paragraph.begin(), paragraph.end(), ' '));
  }
  const auto count = static_cast<double>(words);
  return {kTypicalPage + count * kTypicalWord, kLongestPage + count * kLongestWord};
}

Duration formTime(const ProtocolForm& form) {
  const auto count = static_cast<double>(itemsOf(form.fields).size());
  return {kTypicalPage + count * kField.typicalSeconds, kLongestPage + count * kField.longestSeconds};
}

Duration formsTime(const std::vector<ProtocolForm>& forms) {
  Duration time;
  for (const ProtocolForm& form : forms) {
    time += formTime(form);
  }
  return time;
}

/// Between two trials one is told of the next.
Duration trialTime(const TaskBlock& task, int caseIndex) {
  const CaseInfo info = task.caseInfo(caseIndex);
  return {info.typicalSeconds + kBetweenTrials.typicalSeconds, info.longestSeconds + kBetweenTrials.longestSeconds};
}

Duration practiceTime(const SessionSchedule& schedule, const Protocol& protocol, int block) {
  const ProtocolPractice& practice = *protocol.blocks[static_cast<size_t>(block)].practice;
  Duration time;
  for (const std::optional<TrialView> round : practiceRounds(schedule, protocol, block)) {
    for (int i = 0; i < practice.maxTrials; ++i) {
      const Duration trial = trialTime(*practice.task, practiceTrial(schedule, protocol, block, i, round).caseIndex);
      time.longestSeconds += trial.longestSeconds;
      time.typicalSeconds += i < practice.minCorrect ? trial.typicalSeconds : 0;
    }
  }
  return time;
}

Duration openingTime(const Protocol& protocol, const SessionSchedule& schedule) {
  Duration time;
  if (protocol.consent) {
    time += readingTime(*protocol.consent);
  }
  if (protocol.demographics && schedule.session == 1) {
    time += formTime(*protocol.demographics);
  }
  time += formsTime(protocol.before);
  for (const ProtocolPage& page : protocol.welcome) {
    time += readingTime(page);
  }
  return time;
}

}  // namespace

bool hasBreakAfter(const Protocol& protocol, const SessionSchedule& schedule, size_t trial) {
  if (trial + 1 >= schedule.trials.size()) {
    return false;
  }
  const int index = schedule.trials[trial].block;
  const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(index)];
  if (schedule.trials[trial + 1].block != index) {
    return block.breakAfter;
  }
  const auto isOfBlock = [&](const TrialPlan& plan) { return plan.block == index; };
  const auto end = schedule.trials.begin() + static_cast<std::ptrdiff_t>(trial) + 1;
  return block.breakEveryTrials > 0 &&
         std::count_if(schedule.trials.begin(), end, isOfBlock) % block.breakEveryTrials == 0;
}

std::vector<PartLength> partsOf(const Protocol& protocol, const SessionSchedule& schedule) {
  std::vector<PartLength> parts{{"consent, forms, welcome", 0, openingTime(protocol, schedule)}};
  for (const int index : schedule.blockOrder) {
    const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(index)];
    PartLength part{block.name, 0, {}};
    for (const ProtocolPage& page : block.instructions) {
      part.duration += readingTime(page);
    }
    if (block.practice) {
      part.duration += practiceTime(schedule, protocol, index);
    }
    for (const TrialPlan& trial : schedule.trials) {
      if (trial.block == index) {
        ++part.trials;
        part.duration += trialTime(*block.task, trial.caseIndex);
      }
    }
    part.duration += formsTime(block.after);
    parts.push_back(part);
  }
  PartLength breaks{"breaks", 0, {}};
  const double rest = protocol.breakSeconds;
  for (size_t i = 0; i < schedule.trials.size(); ++i) {
    if (hasBreakAfter(protocol, schedule, i)) {
      breaks.duration += {rest, kLongestRest * rest};
    }
  }
  parts.push_back(breaks);
  if (!protocol.after.empty()) {
    parts.push_back({"forms after", 0, formsTime(protocol.after)});
  }
  if (protocol.survey && (schedule.session == protocol.sessions || !protocol.surveyAfterLastSessionOnly)) {
    parts.push_back({"survey", 0, formTime(*protocol.survey)});
  }
  return parts;
}

Duration durationOf(const std::vector<PartLength>& parts) {
  Duration sum;
  for (const PartLength& part : parts) {
    sum += part.duration;
  }
  return sum;
}

}  // namespace ocelli
