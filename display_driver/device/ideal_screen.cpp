#include "display_driver/device/ideal_screen.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace ocelli {
namespace {

// Clocks count nanoseconds in 63 bits; beyond half of that nothing is ever shown.
constexpr double kFarNanoseconds = 4e18;

}  // namespace

IdealRotation::IdealRotation(const DisplayProfile& profile, HostTime start)
    : start_(start), slices_(profile.storedSlices()), refreshNanoseconds_(1e9 / profile.refreshHertz()) {}

HostTime IdealRotation::timeOf(const RotationPhase& phase) const {
  const double nanoseconds =
      (static_cast<double>(phase.refresh) + static_cast<double>(phase.slice) / slices_) * refreshNanoseconds_;
  if (!(nanoseconds < kFarNanoseconds)) {
    return HostTime::max();
  }
  return start_ + std::chrono::nanoseconds(std::llround(nanoseconds));
}

double IdealRotation::slicesSince(HostTime time) const {
  return static_cast<double>(std::chrono::nanoseconds(time - start_).count()) / refreshNanoseconds_ * slices_;
}

RotationPhase IdealRotation::next(HostTime time) const {
  auto slice = static_cast<uint64_t>(std::max(0.0, std::floor(slicesSince(time))));
  const auto phase = [&] {
    return RotationPhase{slice / static_cast<uint64_t>(slices_), static_cast<int>(slice % slices_)};
  };
  while (timeOf(phase()) < time) {
    ++slice;
  }
  return phase();
}

RotationPhase IdealRotation::next(HostTime time, int slice) const {
  const double refreshes = std::floor(slicesSince(time) / slices_);
  RotationPhase phase{static_cast<uint64_t>(std::max(0.0, refreshes)), slice};
  while (timeOf(phase) < time) {
    ++phase.refresh;
  }
  return phase;
}

RotationReading IdealRotation::reading(HostTime time) const {
  const double refreshes = std::max(0.0, slicesSince(time) / slices_);
  const double whole = std::floor(refreshes);
  return {.time = time,
          .refresh = static_cast<uint64_t>(whole),
          .share = refreshes - whole,
          .refreshSeconds = refreshNanoseconds_ * 1e-9};
}

void IdealScreen::add(Frame frame, HostTime now) {
  frame.state.stage = FrameStage::kArrived;
  frame.state.sent = now;
  frame.state.arrived = now;
  frame.fence->moveTo(frame.state);
  if (waiting_.size() == kMaxWaiting) {
    const auto giving = std::ranges::find_if(waiting_, [](const Frame& each) { return !each.presentation; });
    drop(static_cast<size_t>((giving == waiting_.end() ? std::prev(giving) : giving) - waiting_.begin()));
  }
  waiting_.push_back(std::move(frame));
}

void IdealScreen::present(FrameNumber number, const Presentation& presentation, HostTime now) {
  const auto frame = std::ranges::find_if(waiting_, [&](const Frame& each) { return each.fence->number() == number; });
  if (frame == waiting_.end()) {
    return;
  }
  frame->presentation = presentation;
  RotationPhase phase = rotation_.next(now, 0);
  frame->state.late = false;
  if (presentation.at) {
    phase = *presentation.at;
    frame->state.late = rotation_.timeOf(phase) < now;
    if (frame->state.late) {
      phase = presentation.tearWhenLate ? rotation_.next(now) : rotation_.next(now, phase.slice);
    }
  }
  frame->due = rotation_.timeOf(phase);
  frame->state.shown = frame->due;
  frame->state.shownRefresh = phase.refresh;
  frame->state.shownSlice = phase.slice;
}

std::vector<IdealScreen::Frame> IdealScreen::advance(HostTime now) {
  std::vector<Frame> shown;
  while (nextChange() <= now) {
    // Of those that are due at the same time the newest.
    size_t next = 0;
    for (size_t i = 1; i < waiting_.size(); ++i) {
      if (waiting_[i].due <= waiting_[next].due) {
        next = i;
      }
    }
    Frame frame = std::move(waiting_[next]);
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(next));
    for (; next > 0; --next) {
      drop(0);
    }
    frame.state.stage = FrameStage::kShown;
    if (frame.state.late) {
      underruns_ += std::max<uint64_t>(1, frame.state.shownRefresh - frame.presentation->at->refresh);
    }
    shown.push_back(std::move(frame));
  }
  return shown;
}

void IdealScreen::drop(size_t waiting) {
  const auto at = waiting_.begin() + static_cast<std::ptrdiff_t>(waiting);
  Frame frame = std::move(*at);
  waiting_.erase(at);
  frame.state.stage = FrameStage::kDropped;
  frame.state.problem = "a newer frame took its place";
  frame.fence->moveTo(frame.state);
  ++dropped_;
}

HostTime IdealScreen::nextChange() const {
  HostTime next = HostTime::max();
  for (const Frame& frame : waiting_) {
    next = std::min(next, frame.due);
  }
  return next;
}

std::vector<IdealScreen::Frame> IdealScreen::takeWaiting() {
  return std::exchange(waiting_, {});
}

}  // namespace ocelli
