#include "display_driver/wire/streaming_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// After the second lost frame in a row; the first one goes again at once.
constexpr std::chrono::milliseconds kFirstRest(2);

}  // namespace

void StreamingDevice::connect() {
  auto link = port_->open();
  DisplayIdentity display = identify(*link);
  if (profile_ && *profile_ != display.profile) {
    throw wire::LinkError(wire::LinkStatus::kFailed, "another display, with the profile \"" + display.profile.name +
                                                         "\", has come in the place of the first");
  }
  if (!profile_) {
    profile_ = display.profile;
    info_ = {options_.kind, display.identity.name, link->description().serial, link->description().text};
  }
  capabilities_ = display.identity.capabilities;
  encoder_.emplace(*profile_, capabilities_);
  link_ = std::move(link);
  inbox_.clear();
  link_->start(inbox_.listener([this] {
    const std::lock_guard lock(mutex_);
    wakeWorker();
  }));
  startSession();
  updateTelemetry();
  const std::lock_guard lock(mutex_);
  telemetry_.connected = true;
}

void StreamingDevice::startSession() {
  session_ = newSession();
  arm(*link_, session_);
  writer_.emplace(session_);
  base_.reset();
  problem_.reset();
  lost_.reset();
  lastProgress_ = Clock::now();
}

void StreamingDevice::work() {
  while (true) {
    if (link_ == nullptr && !reconnect()) {
      return;
    }
    bool idle = false;
    if (!step(idle)) {
      return;
    }
    if (problem_) {
      recover(*problem_);
      continue;
    }
    std::unique_lock lock(mutex_);
    if (idle && !woken_) {
      changed_.wait_until(lock, Clock::now() < restUntil_ ? std::min(nextTelemetry_, restUntil_) : nextTelemetry_);
    }
    woken_ = false;
  }
}

/// One round of work; `idle` where there is nothing to do before something new comes. False: the device is being
/// closed.
bool StreamingDevice::step(bool& idle) {
  {
    const std::lock_guard lock(mutex_);
    if (closing_) {
      return false;
    }
  }
  readNews();
  if (problem_) {
    return true;
  }
  loseUnanswered();
  if (lost_) {
    beginAnew();
  }
  if (!problem_ && Clock::now() >= nextTelemetry_) {
    updateTelemetry();
  }
  if (!problem_ && isStuck()) {
    problem_ = wire::LinkStatus::kTimedOut;
  }
  if (!problem_) {
    idle = Clock::now() < restUntil_ || !sendSome();
  }
  return true;
}

/// Until there is a link again; false where the device is being closed.
bool StreamingDevice::reconnect() {
  while (true) {
    {
      const std::lock_guard lock(mutex_);
      if (closing_) {
        return false;
      }
    }
    try {
      connect();
      backOff_ = {};
      const std::lock_guard lock(mutex_);
      ++telemetry_.reconnections;
      return true;
    } catch (const wire::LinkError& error) {
      link_.reset();
      const std::lock_guard lock(mutex_);
      noteProblem(error.what());
    } catch (const Error& error) {
      link_.reset();
      const std::lock_guard lock(mutex_);
      noteProblem(error.what());
    }
    backOff_ = std::clamp(2 * backOff_, options_.firstBackOff, options_.lastBackOff);
    port_->waitForArrival(backOff_);
  }
}

void StreamingDevice::recover(wire::LinkStatus status) {
  const std::string problem = fmt::format("the link to the display broke: {}", wire::nameOf(status));
  link_->cancelAll();
  readNews();  // what was acknowledged before
  forgetTransfers();
  {
    const std::lock_guard lock(mutex_);
    loseAll(problem);
    if (waiting_ == nullptr && lastSent_ != nullptr) {
      // A display that comes back is dark: once more, for nobody waits for it.
      waiting_ = std::make_shared<OutgoingFrame>(lastSentNumber_);
      waiting_->volume = lastSent_;
      waiting_->presentation = Presentation{};
    }
    noteProblem(problem);
  }
  try {
    if (status == wire::LinkStatus::kGone) {
      throw wire::LinkError(status, problem);
    }
    link_->clearStall();
    startSession();
  } catch (const wire::LinkError& error) {
    if (error.status() != wire::LinkStatus::kGone && status == wire::LinkStatus::kTimedOut) {
      link_->resetDevice();
    }
    link_.reset();
    const std::lock_guard lock(mutex_);
    telemetry_.connected = false;
  }
}

bool StreamingDevice::isStuck() const {
  const Clock::time_point now = Clock::now();
  if (transfersDone_ == transfers_ || now - lastProgress_ <= options_.stuckAfter) {
    return false;
  }
  // A display whose buffers hold frames for later takes no bytes until then, but it answers.
  const std::lock_guard lock(mutex_);
  const bool holdsFrames = std::ranges::any_of(underWay_, [](const auto& entry) {
    return entry.second->state.stage == FrameStage::kArrived && entry.second->presentation;
  });
  return !holdsFrames || now - lastAnswer_ > options_.stuckAfter;
}

/// A frame is lost, and with it those that are made from it. In a new session nothing that is still on its way, in
/// either direction, can be mistaken for a part of what comes now.
void StreamingDevice::beginAnew() {
  const std::string problem = *std::exchange(lost_, std::nullopt);
  sending_.reset();
  if (staging_ != nullptr) {
    staging_->bytes.clear();
  }
  {
    const std::lock_guard lock(mutex_);
    loseAll(problem);
  }
  // A display that refuses every frame is not asked again and again at the speed of the link.
  rest_ = std::min(std::max(2 * rest_, kFirstRest), options_.lastBackOff);
  restUntil_ = Clock::now() + (rest_ > kFirstRest ? rest_ : std::chrono::milliseconds(0));
  try {
    startSession();
  } catch (const wire::LinkError& error) {
    problem_ = error.status();
  }
}

/// Nothing is on its way any more.
void StreamingDevice::forgetTransfers() {
  for (Buffer& buffer : buffers_) {
    buffer.bytes.clear();
    buffer.transfer = 0;
  }
  staging_ = nullptr;
  transfersDone_ = transfers_;
  sending_.reset();
  base_.reset();
}

}  // namespace ocelli
