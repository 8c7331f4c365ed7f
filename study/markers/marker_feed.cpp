#include "study/markers/marker_feed.h"

namespace ocelli {

MarkerFeed::MarkerFeed(SessionSink& inner, const Protocol& protocol, std::vector<std::unique_ptr<MarkerOutput>> outputs)
    : ForwardingSink(inner), protocol_(protocol), outputs_(std::move(outputs)) {
  add(kSessionStarts);
}

void MarkerFeed::add(const MarkerCode& code, int trial, const std::string& condition, const std::string& answer) {
  waiting_.push_back({sequence_++, 0, code, trial, condition, answer});
}

void MarkerFeed::frameShown(int64_t nanoseconds) {
  for (Marker& marker : waiting_) {
    marker.nanoseconds = nanoseconds;
    for (const std::unique_ptr<MarkerOutput>& output : outputs_) {
      output->send(marker);
    }
  }
  waiting_.clear();
}

void MarkerFeed::finish(int64_t nanoseconds) {
  frameShown(nanoseconds);
  for (const std::unique_ptr<MarkerOutput>& output : outputs_) {
    output->finish();
  }
}

std::vector<MarkerCounts> MarkerFeed::counts() const {
  std::vector<MarkerCounts> counts;
  for (const std::unique_ptr<MarkerOutput>& output : outputs_) {
    counts.push_back(output->counts());
  }
  return counts;
}

void MarkerFeed::trialBegins(int number, const TrialPlan& plan, int attempt) {
  ForwardingSink::trialBegins(number, plan, attempt);
  const bool isReference = plan.view == TrialView::kReference;
  add(plan.practice ? (isReference ? kPracticeInReference : kPracticeInOther)
                    : (isReference ? kTrialInReference : kTrialInOther),
      number, protocol_.nameOf(plan.view));
}

void MarkerFeed::trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) {
  ForwardingSink::trialEnds(number, record, std::move(acknowledged));
  const std::string& condition = protocol_.nameOf(record.plan.view);
  const TrialOutcome& outcome = record.outcome;
  const bool isCompleted = record.ending == TrialEnding::kCompleted;
  if (isCompleted) {
    add(outcome.correct    ? kAnsweredRight
        : outcome.censored ? kTimeOver
                           : kAnsweredWrong,
        number, condition, outcome.answer);
  }
  add(isCompleted ? kTrialEnds : kTrialBrokenOff, number, condition);
}

void MarkerFeed::sessionEnds(SessionEnding ending, const std::string& utc) {
  ForwardingSink::sessionEnds(ending, utc);
  add(kSessionEnds, -1, "", nameOf(ending));
}

}  // namespace ocelli
