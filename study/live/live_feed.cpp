#include "study/live/live_feed.h"

#include <algorithm>

#include "study/live/live_warnings.h"
#include "study/protocol/session_length.h"

namespace ocelli {
namespace {

constexpr int64_t kPostEvery = 250'000'000;  // nanoseconds

double typicalSecondsOf(const Protocol& protocol, const SessionSchedule& schedule) {
  const double all = durationOf(partsOf(protocol, schedule)).typicalSeconds;
  return all / static_cast<double>(std::max<size_t>(schedule.trials.size(), 1));
}

std::string outcomeOf(const TrialRecord& record) {
  if (record.ending != TrialEnding::kCompleted) {
    return "broken off";
  }
  return record.outcome.correct ? "right" : record.outcome.censored ? "time over" : "wrong";
}

std::string stateOf(const SessionStatus& status) {
  return status.ended ? "ended" : status.wantsExperimenter ? "calls you" : status.paused ? "paused" : "running";
}

template <class Item>
void addFirst(std::vector<Item>& list, Item item, size_t most) {
  list.insert(list.begin(), std::move(item));
  list.resize(std::min(list.size(), most));
}

}  // namespace

LiveFeed::LiveFeed(SessionSink& inner, const Protocol& protocol, const SessionSchedule& schedule,
                   std::shared_ptr<LiveBoard> board, LiveOptions options)
    : ForwardingSink(inner),
      protocol_(protocol),
      board_(std::move(board)),
      options_(std::move(options)),
      timeLeft_(typicalSecondsOf(protocol, schedule)) {
  status_.hidesCondition = !options_.showsConditions;
}

void LiveFeed::trialBegins(int number, const TrialPlan& plan, int attempt) {
  ForwardingSink::trialBegins(number, plan, attempt);
  condition_ = protocol_.nameOf(plan.view);
}

void LiveFeed::trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) {
  ForwardingSink::trialEnds(number, record, std::move(acknowledged));
  LiveTrial trial;
  trial.number = record.plan.practice ? 0 : record.plan.index + 1;
  trial.outcome = outcomeOf(record);
  if (record.ending == TrialEnding::kCompleted) {
    trial.responseSeconds = static_cast<double>(record.outcome.responseTicks) / static_cast<double>(kTicksPerSecond);
  }
  trial.condition = options_.showsConditions ? condition_ : "";
  addFirst(status_.lastTrials, std::move(trial), kMaxTrials);
  condition_.clear();

  const TrialTiming& timing = record.timing;
  status_.frames += timing.frames;
  status_.dropped += timing.dropped;
  status_.lastDropped = timing.dropped;
  status_.lastMedianMilliseconds = static_cast<double>(timing.medianNanoseconds) * 1e-6;
  status_.lastLongestMilliseconds = static_cast<double>(timing.longestNanoseconds) * 1e-6;
  ++status_.verdicts[nameOf(timing.verdict)];
  if (record.plan.practice || record.ending != TrialEnding::kCompleted) {
    timeLeft_.interrupted();
  } else {
    timeLeft_.trialCompleted(record.endedNanoseconds);
  }
}

void LiveFeed::event(const EventRecord& record) {
  ForwardingSink::event(record);
  if (record.what == "pause") {
    timeLeft_.interrupted();
  }
  if (const std::string_view text = warningOf(record.what); !text.empty()) {
    ++status_.warningCount;
    addFirst(status_.warnings, {static_cast<double>(record.nanoseconds) * 1e-9, std::string(text)}, kMaxWarnings);
  }
}

void LiveFeed::frameShown(int64_t nanoseconds, const SessionFlow& flow) {
  now_ = nanoseconds;
  if (board_ != nullptr && (!posted_ || nanoseconds - *posted_ >= kPostEvery)) {
    posted_ = nanoseconds;
    post(flow);
  }
}

void LiveFeed::finish(const SessionFlow& flow) {
  if (board_ != nullptr) {
    post(flow);
  }
}

void LiveFeed::post(const SessionFlow& flow) {
  const SessionStatus session = flow.status();
  LiveStatus status = status_;
  status.step = session.blindStep;
  status.state = stateOf(session);
  status.condition = options_.showsConditions ? condition_ : "";
  status.trialsDone = session.progress.trialsDone;
  status.trials = session.progress.trials;
  status.block = session.progress.block + 1;
  status.blocks = session.progress.blocks;
  status.elapsedSeconds = static_cast<double>(now_) * 1e-9;
  status.secondsLeft = timeLeft_.seconds(status.trials - status.trialsDone);
  status.leftByPace = timeLeft_.knowsPace();
  if (options_.devices) {
    status.devices = options_.devices();
  }
  board_->post(std::move(status));
}

}  // namespace ocelli
