#include "study/session/trial_rows.h"

#include <cmath>

namespace ocelli {

TrialRow rowOf(const RunRecord& run, int number, const TrialPlan& plan, int attempt, const std::string& block) {
  TrialRow row;
  row.subject = run.subject;
  row.subjectKind = run.kind;
  row.simulated = isSimulated(run.kind);
  row.session = run.session;
  row.trialNumber = number;
  row.practice = plan.practice;
  row.planIndex = plan.practice ? kNoPlan : plan.index;
  row.attempt = attempt;
  row.blockIndex = plan.block;
  row.block = block;
  row.task = plan.task;
  row.caseIndex = plan.caseIndex;
  row.view = plan.view;
  row.trialSeed = plan.seed;
  return row;
}

void addEnd(TrialRow& row, const TrialRecord& record) {
  row.ending = record.ending;
  row.startedNs = record.startedNanoseconds;
  row.endedNs = record.endedNanoseconds;
  row.startedUtc = record.startedUtc;
  row.endedUtc = record.endedUtc;
  row.caseLabel = record.info.label;
  row.moving = record.info.moving;
  row.exposureSeconds = record.info.exposureSeconds;
  if (record.info.exposureSeconds) {
    row.exposureRule = record.plan.exposure;
  }
  row.objects = record.info.objects;
  row.duplicateColors = record.info.duplicateColors;
  row.longestSeconds = record.info.longestSeconds;
  row.typicalSeconds = record.info.typicalSeconds;
  if (record.ending == TrialEnding::kCompleted) {
    const TrialOutcome& outcome = record.outcome;
    row.answer = outcome.answer;
    row.expected = outcome.expected;
    row.correct = outcome.correct;
    row.censored = outcome.censored;
    row.responseSeconds = static_cast<double>(outcome.responseTicks) / static_cast<double>(kTicksPerSecond);
    row.responseTicks = outcome.responseTicks;
    row.exposureFrames = outcome.exposureFrames;
    if (outcome.exposureTicks) {
      row.exposureShownSeconds = static_cast<double>(*outcome.exposureTicks) / static_cast<double>(kTicksPerSecond);
    }
    row.measures = outcome.measures;
  }
  row.frames = record.timing.frames;
  row.droppedFrames = record.timing.dropped;
  row.medianIntervalNs = record.timing.medianNanoseconds;
  row.longestIntervalNs = record.timing.longestNanoseconds;
  row.timingVerdict = record.timing.verdict;
  row.screenWidth = record.screen.width;
  row.screenHeight = record.screen.height;
  row.refreshHertz = record.screen.refreshHertz;
}

TrialRecord recordOf(const TrialRow& row) {
  TrialRecord record;
  record.plan = {row.planIndex, row.blockIndex, row.task, row.caseIndex, row.view, row.trialSeed.value_or(0),
                 row.practice};
  if (row.exposureSeconds) {
    record.plan.exposure = row.exposureRule.value_or(ExposureRule::kFrames);
  }
  record.attempt = row.attempt;
  if (!row.ending) {
    return record;
  }
  record.ending = *row.ending;
  record.startedNanoseconds = row.startedNs.value_or(0);
  record.endedNanoseconds = row.endedNs.value_or(0);
  record.startedUtc = row.startedUtc;
  record.endedUtc = row.endedUtc;
  record.info = {row.caseLabel,       row.moving.value_or(false),     row.exposureSeconds,           row.objects,
                 row.duplicateColors, row.longestSeconds.value_or(0), row.typicalSeconds.value_or(0)};
  if (record.ending == TrialEnding::kCompleted) {
    record.outcome = {
        row.answer,
        row.expected,
        row.correct.value_or(false),
        row.censored.value_or(false),
        row.responseTicks.value_or(0),
        row.exposureFrames.value_or(0),
        row.exposureShownSeconds
            ? std::optional(std::llround(*row.exposureShownSeconds * static_cast<double>(kTicksPerSecond)))
            : std::nullopt,
        row.measures};
  }
  record.timing = {row.frames, row.droppedFrames, row.medianIntervalNs.value_or(0), row.longestIntervalNs.value_or(0),
                   row.timingVerdict.value_or(TimingVerdict::kGood)};
  record.screen = {static_cast<int>(row.screenWidth.value_or(0)), static_cast<int>(row.screenHeight.value_or(0)),
                   row.refreshHertz.value_or(0)};
  return record;
}

}  // namespace ocelli
