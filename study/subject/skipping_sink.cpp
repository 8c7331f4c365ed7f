#include "study/subject/skipping_sink.h"

#include <algorithm>
#include <utility>

namespace ocelli {

SkippingSink::SkippingSink(SessionSink& sink, SessionDone done) : sink_(sink), done_(std::move(done)) {}

bool SkippingSink::isStored(const TrialPlan& plan) const {
  const std::vector<int>& list = plan.practice ? done_.blocksPracticed : done_.completedTrials;
  return std::find(list.begin(), list.end(), plan.practice ? plan.block : plan.index) != list.end();
}

void SkippingSink::consent(const ConsentRecord& record) {
  if (!done_.consented) {
    sink_.consent(record);
  }
}

void SkippingSink::answer(const AnswerRecord& record) {
  if (std::find(done_.forms.begin(), done_.forms.end(), record.form) == done_.forms.end()) {
    caughtUp_ = true;
    sink_.answer(record);
  }
}

void SkippingSink::trialBegins(int number, const TrialPlan& plan, int attempt) {
  if (isStored(plan)) {
    return;
  }
  caughtUp_ = true;
  const int ours = static_cast<int>(numbers_.size());
  const auto before = static_cast<size_t>(std::max(plan.index, 0));
  attemptsOf_[ours] = attempt + (plan.practice || before >= done_.attempts.size() ? 0 : done_.attempts[before]);
  numbers_[number] = ours;
  sink_.trialBegins(ours, plan, attemptsOf_[ours]);
}

void SkippingSink::frames(int number, std::span<const FrameRecord> records) {
  if (const auto found = numbers_.find(number); found != numbers_.end()) {
    sink_.frames(found->second, records);
  }
}

void SkippingSink::inputs(int number, std::span<const InputRecord> records) {
  if (const auto found = numbers_.find(number); found != numbers_.end()) {
    sink_.inputs(found->second, records);
  }
}

void SkippingSink::gaze(int number, std::span<const GazeRecord> records) {
  if (const auto found = numbers_.find(number); found != numbers_.end()) {
    sink_.gaze(found->second, records);
  }
}

void SkippingSink::trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) {
  if (const auto found = numbers_.find(number); found != numbers_.end()) {
    TrialRecord passed = record;
    passed.attempt = attemptsOf_[found->second];
    sink_.trialEnds(found->second, passed, std::move(acknowledged));
  }
}

void SkippingSink::event(const EventRecord& record) {
  if (caughtUp_) {
    sink_.event(record);
  }
}

void SkippingSink::sessionEnds(SessionEnding ending, const std::string& utc) {
  sink_.sessionEnds(ending, utc);
}

}  // namespace ocelli
