#include "display_driver/pacing/pacer.h"

#include <algorithm>
#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;
using Duration = std::chrono::nanoseconds;

/// How often the device is asked how it is while nothing else is to be done.
constexpr Duration kLookInterval = 5ms;
/// And how often while a volume is being made beside the pacer.
constexpr Duration kBriefLookInterval = 500us;
/// What clocks and threads may be late by.
constexpr Duration kGuard = 1ms;
/// Of a device that tells its rotation, from when it is there.
constexpr Duration kMaxWaitForRotation = 300ms;
/// After its refresh began; then it is told as missed.
constexpr Duration kMaxWaitForEnd = 1s;
/// Frames that have not arrived.
constexpr size_t kMaxUnderWay = 2;
/// A stage that takes this much longer than a refresh still keeps up: medians wobble.
constexpr double kKeepsUp = 1.05;
/// With a standard deviation above this share of a refresh the clock does not say which refresh it is.
constexpr double kMaxUncertain = 0.15;

Duration fromSeconds(double seconds) {
  return Duration(static_cast<int64_t>(seconds * 1e9));
}

bool known(HostTime time) {
  return time != HostTime{};
}

}  // namespace

Pacer::Pacer(Device& device, VolumeSource& source, PaceClock& clock, const PacerOptions& options)
    : device_(device),
      source_(source),
      line_(source.line()),
      clock_(clock),
      options_(options),
      ideal_(1 / device.profile().refreshHertz()),
      rotation_(1 / device.profile().refreshHertz()) {}

HostTime Pacer::beginOf(uint64_t refresh) const {
  return locked_ ? rotation_.beginOf(refresh) : ideal_.beginOf(refresh);
}

uint64_t Pacer::refreshAfter(HostTime time) const {
  return locked_ ? rotation_.refreshAfter(time) : ideal_.refreshAfter(time);
}

double Pacer::refreshSeconds() const {
  return locked_ ? rotation_.refreshSeconds() : ideal_.refreshSeconds();
}

void Pacer::observe() {
  const Telemetry telemetry = device_.telemetry();
  connected_ = telemetry.connected;
  if (telemetry.rotation) {
    rotation_.add(*telemetry.rotation);
  }
  const bool locked =
      rotation_.running() && rotation_.uncertaintySeconds(clock_.now()) < kMaxUncertain * rotation_.refreshSeconds();
  if (locked != locked_ || rotation_.restarts() != restarts_) {
    // Refreshes are counted anew.
    locked_ = locked;
    restarts_ = rotation_.restarts();
    ++counting_;
    keepSkipped(skipped_, false);
    last_.reset();
    lastFrameDue_.reset();
    target_.reset();
  }
  for (Pending& pending : pending_) {
    if (pending.fence != nullptr) {
      const FrameState state = pending.fence->state();
      if (hasEnded(state.stage)) {
        settle(pending, state);
      } else if (clock_.now() - std::max(pending.record.due, pending.record.submitted) >= kMaxWaitForEnd) {
        giveUp(pending, state);
      }
    }
  }
  std::erase_if(givenUp_, [this](Pending& pending) {
    const FrameState state = pending.fence->state();
    if (state.stage < FrameStage::kArrived) {
      return false;
    }
    pending.record.sent = state.sent;
    pending.record.arrived = state.arrived;
    learn(pending.record);
    return true;
  });
}

/// What becomes of it later is no longer told, only learned from.
void Pacer::giveUp(Pending& pending, const FrameState& state) {
  RefreshRecord& record = pending.record;
  record.sent = state.sent;
  record.arrived = state.arrived;
  record.problem = state.problem;
  if (!connected_) {
    record.outcome = RefreshOutcome::kNotConnected;
  } else {
    const bool arrivedInTime = known(state.arrived) && state.arrived <= record.due;
    record.outcome = arrivedInTime ? RefreshOutcome::kRefused : RefreshOutcome::kLinkLate;
  }
  if (state.stage < FrameStage::kArrived) {
    givenUp_.push_back(pending);
  }
  pending.fence = nullptr;
}

void Pacer::settle(Pending& pending, const FrameState& state) {
  RefreshRecord& record = pending.record;
  record.sent = state.sent;
  record.arrived = state.arrived;
  record.problem = state.problem;
  const bool arrivedInTime = known(state.arrived) && state.arrived <= record.due;
  const RefreshOutcome late = pending.sourceLate ? RefreshOutcome::kSourceLate
                              : arrivedInTime    ? RefreshOutcome::kRefused
                                                 : RefreshOutcome::kLinkLate;
  switch (state.stage) {
    case FrameStage::kShown: {
      record.shown = state.shown;
      record.shownRefresh = state.shownRefresh;
      // Without a rotation a frame is due some time in its refresh, and shown with the next one.
      record.late = pending.locked ? state.late || state.shownRefresh > record.refresh
                                   : state.shown > record.due + fromSeconds(1.5 * refreshSeconds());
      record.late = record.late || pending.sourceLate;
      record.outcome = record.late || state.coarse ? late : RefreshOutcome::kShown;
      if (state.coarse) {
        record.problem = "shown in part";
      }
      break;
    }
    case FrameStage::kLost:
      record.outcome = connected_ ? RefreshOutcome::kRefused : RefreshOutcome::kNotConnected;
      break;
    case FrameStage::kWaiting:
    case FrameStage::kSending:
    case FrameStage::kArrived:
    case FrameStage::kDropped:
      record.outcome = late;
      break;
  }
  pending.fence = nullptr;
  learn(record);
}

void Pacer::learn(const RefreshRecord& record) {
  if (record.outcome == RefreshOutcome::kNotConnected) {
    return;
  }
  const HostTime sent = known(record.sent) ? record.sent : record.arrived;
  if (known(sent)) {
    sending_.add(sent - std::max(record.makingEnded, lastSent_));
    lastSent_ = std::max(lastSent_, sent);
  }
  const HostTime there = known(record.arrived) ? record.arrived : sent;
  transit_.add((known(there) ? there : clock_.now()) - record.makingEnded);
}

void Pacer::flush(const OnRecord& onRecord) {
  while (!pending_.empty() && pending_.front().fence == nullptr) {
    const RefreshRecord record = std::move(pending_.front().record);
    pending_.pop_front();
    timeLine_.add(record);
    if (onRecord) {
      onRecord(record);
    }
  }
}

size_t Pacer::underWay() const {
  const auto pending = std::ranges::count_if(pending_, [](const Pending& frame) {
    return frame.fence != nullptr && frame.fence->state().stage < FrameStage::kArrived;
  });
  return static_cast<size_t>(pending) + givenUp_.size();
}

Duration Pacer::usualLead() const {
  const Duration guess = fromSeconds(refreshSeconds() / 2);
  return (making_.empty() ? guess : making_.median()) + (transit_.empty() ? guess : transit_.median());
}

Duration Pacer::safeLead() const {
  Duration guard = kGuard;
  if (locked_) {
    guard += fromSeconds(3 * rotation_.uncertaintySeconds(clock_.now()));
  }
  Duration lead = std::max(usualLead(), making_.high() + transit_.high());
  if (line_ != nullptr) {
    // What holds up one of a line holds up the next one, too, which then is no exception. Devices keep one frame that
    // waits for its refresh: more than one refresh too early is no use.
    lead = std::min(lead, usualLead() + fromSeconds(refreshSeconds()));
  }
  return lead + guard;
}

void Pacer::chooseTarget(HostTime now) {
  uint64_t refresh = refreshAfter(now + usualLead());
  RefreshOutcome why = RefreshOutcome::kSourceLate;
  if (last_) {
    refresh = std::max(refresh, *last_ + 1);
  }
  if (lastFrameDue_ && !sending_.empty()) {
    const Duration spacing = sending_.median() - fromSeconds((kKeepsUp - 1) * refreshSeconds());
    const uint64_t linkAllows = refreshAfter(*lastFrameDue_ + spacing - kGuard);
    if (linkAllows > refresh) {
      refresh = linkAllows;
      why = RefreshOutcome::kLinkLate;
    }
  }
  if (last_) {
    skipUpTo(refresh, why);
  }
  target_ = refresh;
}

void Pacer::skipUpTo(uint64_t refresh, RefreshOutcome why) {
  if (!last_) {
    last_ = refresh == 0 ? 0 : refresh - 1;
    return;
  }
  while (*last_ + 1 < refresh) {
    ++*last_;
    skipped_.push_back({.refresh = *last_, .due = beginOf(*last_), .outcome = why});
  }
}

void Pacer::keepSkipped(std::vector<RefreshRecord>& skipped, bool nothingNew) {
  for (RefreshRecord& record : std::exchange(skipped, {})) {
    if (nothingNew) {
      record.outcome = RefreshOutcome::kUnchanged;
    }
    pending_.push_back({.record = std::move(record)});
  }
}

void Pacer::beginMaking(uint64_t refresh) {
  const HostTime due = beginOf(refresh);
  makings_.push_back({.record = {.refresh = refresh, .due = due, .makingBegan = clock_.now()},
                      .skipped = std::exchange(skipped_, {}),
                      .counting = counting_});
  last_ = refresh;
  if (line_ != nullptr) {
    line_->begin(due);
    return;
  }
  const SourcedVolume sourced = source_.volumeFor(due);
  Making making = std::move(makings_.front());
  makings_.pop_front();
  submit(std::move(making), sourced);
}

void Pacer::takeMade() {
  while (!makings_.empty()) {
    const std::optional<SourcedVolume> sourced = line_->finished();
    if (!sourced) {
      return;
    }
    Making making = std::move(makings_.front());
    makings_.pop_front();
    submit(std::move(making), *sourced);
  }
}

void Pacer::submit(Making making, const SourcedVolume& sourced) {
  RefreshRecord record = std::move(making.record);
  record.makingEnded = clock_.now();
  record.imageScale = sourced.imageScale;
  keepSkipped(making.skipped, sourced.kind == SourcedVolume::Kind::kSame);
  switch (sourced.kind) {
    case SourcedVolume::Kind::kEnd:
      ended_ = true;
      return;
    case SourcedVolume::Kind::kSame:
      pending_.push_back({.record = record});
      return;
    case SourcedVolume::Kind::kNew:
      break;
  }
  OC_CHECK(sourced.volume != nullptr, "a source gave no volume");
  making_.add(record.makingEnded - record.makingBegan);
  if (making.counting != counting_) {
    // The refresh that it was made for has no number any more.
    record.outcome = RefreshOutcome::kSourceLate;
    pending_.push_back({.record = record});
    return;
  }
  const HostTime there = record.makingEnded + (transit_.empty() ? Duration(0) : transit_.median());
  bool late = false;
  if (there > record.due) {
    // It is late for this refresh, but not for one after it.
    const uint64_t reached = refreshAfter(there);
    record.outcome = RefreshOutcome::kSourceLate;
    if (last_ && *last_ > record.refresh) {
      // Those after it are being made, or are given up already.
      late = true;
    } else if (reached > record.refresh) {
      pending_.push_back({.record = record});
      skipUpTo(reached, RefreshOutcome::kSourceLate);
      keepSkipped(skipped_, false);
      record.refresh = reached;
      record.due = beginOf(reached);
      target_.reset();
    }
  }
  const auto fence =
      sourced.changed ? device_.submit(sourced.volume, *sourced.changed) : device_.submit(sourced.volume);
  Presentation presentation{.tearWhenLate = options_.tearWhenLate, .coarseWhenLate = options_.coarseWhenLate};
  if (locked_) {
    presentation.at = RotationPhase{record.refresh, 0};
  }
  device_.present(fence->number(), presentation);
  record.frame = fence->number();
  record.submitted = clock_.now();
  last_ = std::max(last_.value_or(0), record.refresh);
  lastFrameDue_ = record.due;
  pending_.push_back({.record = record, .fence = fence, .locked = locked_, .sourceLate = late});
}

void Pacer::waitForRotation() {
  const HostTime begin = clock_.now();
  ideal_.add({.time = begin, .refresh = 0, .share = 0, .refreshSeconds = 0});
  observe();
  while (!locked_ && connected_ && clock_.now() - begin < kMaxWaitForRotation) {
    clock_.waitUntil(clock_.now() + kLookInterval);
    observe();
  }
}

TimeLineSummary Pacer::run(const Stop& stop, const OnRecord& onRecord) {
  waitForRotation();
  const HostTime begin = clock_.now();
  const auto goesOn = [&](HostTime now) {
    return !ended_ && !(stop && stop()) && !(options_.seconds && now - begin >= fromSeconds(*options_.seconds));
  };
  for (HostTime now = begin; goesOn(now); now = clock_.now()) {
    observe();
    takeMade();
    flush(onRecord);
    const Duration look = makings_.empty() ? kLookInterval : kBriefLookInterval;
    if (!connected_ || underWay() >= kMaxUnderWay) {
      target_.reset();
      skipUpTo(refreshAfter(now), connected_ ? RefreshOutcome::kLinkLate : RefreshOutcome::kNotConnected);
      if (makings_.empty()) {
        keepSkipped(skipped_, false);
      }
      clock_.waitUntil(now + look);
      continue;
    }
    if (line_ != nullptr && !line_->ready()) {
      clock_.waitUntil(now + look);
      continue;
    }
    if (!target_) {
      chooseTarget(now);
    }
    const HostTime start = beginOf(*target_) - safeLead();
    if (now < start) {
      clock_.waitUntil(std::min(start, now + look));
      continue;
    }
    beginMaking(*std::exchange(target_, std::nullopt));
  }
  finish(onRecord);
  return timeLine_.summary();
}

void Pacer::finish(const OnRecord& onRecord) {
  while (!makings_.empty()) {
    takeMade();
    observe();
    clock_.waitUntil(clock_.now() + kBriefLookInterval);
  }
  const HostTime begin = clock_.now();
  keepSkipped(skipped_, false);
  observe();
  flush(onRecord);
  while (!pending_.empty() && clock_.now() - begin < kMaxWaitForEnd) {
    clock_.waitUntil(clock_.now() + kLookInterval);
    observe();
    flush(onRecord);
  }
  for (Pending& pending : pending_) {
    if (pending.fence != nullptr) {
      settle(pending, pending.fence->state());
    }
  }
  flush(onRecord);
}

}  // namespace ocelli
