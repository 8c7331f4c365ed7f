#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "display_driver/wire/streaming_device.h"

namespace ocelli {
namespace {

/// Once a frame is coded, the rest of it may take this long to send, on any link.
constexpr std::chrono::milliseconds kShortBacklog(5);

/// Something was wrong with a message, not with the display.
bool isOfMessage(wire::ErrorCode code) {
  return code == wire::ErrorCode::kChecksum || code == wire::ErrorCode::kSequence || code == wire::ErrorCode::kLength ||
         code == wire::ErrorCode::kUnknownType;
}

}  // namespace

void StreamingDevice::readNews() {
  const LinkInbox::News news = inbox_.take();
  for (const LinkInbox::Sent& sent : news.sent) {
    Buffer& buffer = buffers_[sent.tag];
    const uint64_t transfer = std::exchange(buffer.transfer, 0);
    buffer.bytes.clear();
    transfersDone_ = std::max(transfersDone_, transfer);
    lastProgress_ = Clock::now();
    const std::lock_guard lock(mutex_);
    telemetry_.bytesSent += sent.bytes;
    if (sent.status != wire::LinkStatus::kDone) {
      problem_ = problem_.value_or(sent.status);
      continue;
    }
    for (const auto& [number, frame] : underWay_) {
      if (frame->lastTransfer != 0 && frame->lastTransfer <= transfer && frame->state.sent == Clock::time_point{}) {
        frame->state.sent = Clock::now();
        frame->fence->moveTo(frame->state);
        const Clock::duration coding = frame->coded - frame->begun;
        const Clock::duration backlog = frame->state.sent - frame->coded;
        effort_.frameSent(frame->waited || backlog > std::max<Clock::duration>(coding, kShortBacklog));
      }
    }
  }
  for (const wire::Event& event : news.events) {
    if (event.session == session_) {
      handle(event);
    }
  }
  if (news.lost) {
    problem_ = *news.lost;
  }
}

void StreamingDevice::handle(const wire::Event& event) {
  const std::lock_guard lock(mutex_);
  const auto found = underWay_.find(event.frame);
  const std::shared_ptr<OutgoingFrame> frame = found == underWay_.end() ? nullptr : found->second;
  const Clock::time_point time =
      deviceStart_ ? *deviceStart_ + std::chrono::microseconds(event.timeMicroseconds) : Clock::now();
  if (event.type == wire::EventType::kError) {
    const std::string problem = wire::nameOf(static_cast<wire::ErrorCode>(event.code));
    noteProblem(problem);
    // A stray part of a frame that is there whole does not harm it.
    const bool stray = static_cast<wire::ErrorCode>(event.code) == wire::ErrorCode::kOutOfPlace && frame != nullptr &&
                       frame->state.stage == FrameStage::kArrived;
    if (frame != nullptr && !stray) {
      lost_ = problem;
    } else if (event.frame == 0 && isOfMessage(static_cast<wire::ErrorCode>(event.code))) {
      // Nobody knows which message it was. A frame would be reported once more, by its number; a presentation not.
      for (const auto& [number, other] : underWay_) {
        other->presentationSent = false;
      }
    }
    return;
  }
  if (frame == nullptr) {
    return;
  }
  FrameState& state = frame->state;
  if (event.type == wire::EventType::kArrived) {
    ++telemetry_.framesArrived;
    rest_ = {};
    state.arrived = time;
    frame->moveTo(FrameStage::kArrived);
  } else if (event.type == wire::EventType::kDropped) {
    ++telemetry_.framesDropped;
    frame->end(FrameStage::kDropped, "a newer frame took its place in the display");
    underWay_.erase(found);
  } else if (event.type == wire::EventType::kShown) {
    state.shown = time;
    // The event has the low bits of the count.
    const uint64_t near = telemetry_.rotation ? telemetry_.rotation->refresh : event.refresh;
    state.shownRefresh =
        near +
        static_cast<uint64_t>(static_cast<int64_t>(static_cast<int32_t>(event.refresh - static_cast<uint32_t>(near))));
    state.shownSlice = event.code;
    state.late = (event.flags & wire::kEventLate) != 0;
    if ((event.flags & wire::kEventCoarse) != 0) {
      ++telemetry_.framesShownCoarse;
      state.coarse = true;
      frame->fence->moveTo(state);
    } else {
      ++telemetry_.framesShown;
      frame->moveTo(FrameStage::kShown);
      underWay_.erase(found);
    }
  }
}

/// With the mutex. A newer frame comes anyway, or this one is sent again as soon as possible.
void StreamingDevice::lose(std::shared_ptr<OutgoingFrame> frame, const std::string& problem) {
  ++telemetry_.framesLost;
  noteProblem(problem);
  underWay_.erase(frame->number());
  const bool newest = waiting_ == nullptr && (underWay_.empty() || underWay_.rbegin()->first < frame->number());
  if (closing_ || !newest) {
    frame->end(FrameStage::kLost, problem);
    return;
  }
  frame->presentationSent = false;
  frame->wholeSent = false;
  frame->lastTransfer = 0;
  frame->changed.reset();
  frame->state = {.coarse = frame->state.coarse, .problem = problem};
  frame->moveTo(FrameStage::kWaiting);
  waiting_ = frame;
}

/// With the mutex.
void StreamingDevice::loseAll(const std::string& problem) {
  // The newest first: it is the one that may go again.
  while (!underWay_.empty()) {
    lose(underWay_.rbegin()->second, problem);
  }
}

/// Frames that went out whole and of which the display says nothing: its answer was lost.
void StreamingDevice::loseUnanswered() {
  const std::lock_guard lock(mutex_);
  const auto unanswered = std::ranges::find_if(underWay_, [&](const auto& entry) {
    const FrameState& state = entry.second->state;
    return state.sent != Clock::time_point{} && state.arrived == Clock::time_point{} &&
           Clock::now() - state.sent > options_.stuckAfter;
  });
  if (unanswered != underWay_.end()) {
    lost_ = "the display did not acknowledge a frame";
  }
}

void StreamingDevice::updateTelemetry() {
  const Clock::time_point before = Clock::now();
  nextTelemetry_ = before + options_.telemetryInterval;
  const TelemetryAnswer answer = askTelemetry(*link_);
  if (!answer.telemetry) {
    if (answer.gone) {
      problem_ = wire::LinkStatus::kGone;
    }
    const std::lock_guard lock(mutex_);
    noteProblem(answer.problem);
    return;
  }
  const wire::DeviceTelemetry& told = *answer.telemetry;
  const Clock::time_point after = Clock::now();
  lastAnswer_ = after;
  const Clock::time_point middle = before + (after - before) / 2;
  deviceStart_ = middle - std::chrono::microseconds(told.timeMicroseconds);
  const std::lock_guard lock(mutex_);
  telemetry_.rotation = RotationReading{.time = middle,
                                        .refresh = told.refresh,
                                        .share = told.refreshShare * 0x1p-32,
                                        .refreshSeconds = told.refreshNanoseconds * 1e-9};
  const double turnsPerRefresh = profile_->secondHalfTurn == SecondHalfTurn::kOwn ? 1 : 0.5;
  telemetry_.rotationsPerMinute = told.refreshNanoseconds == 0 ? 0 : 60e9 * turnsPerRefresh / told.refreshNanoseconds;
  telemetry_.phaseErrorDegrees = told.phaseErrorMicrodegrees * 1e-6;
  telemetry_.temperatureCelsius.reset();
  if (told.temperatureMillicelsius) {
    telemetry_.temperatureCelsius = *told.temperatureMillicelsius * 1e-3;
  }
  // It counts from 0 after it was reset; what it had counted when it was opened is not ours.
  const uint32_t counted = deviceUnderruns_.value_or(told.underruns);
  telemetry_.underruns += told.underruns - (told.underruns >= counted ? counted : 0);
  deviceUnderruns_ = told.underruns;
  telemetry_.fault = told.state == wire::DeviceState::kFault ? wire::nameOf(told.lastError) : "";
}

}  // namespace ocelli
