#include "display_driver/devices/multivox_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "display_driver/devices/multivox_memory.h"
#include "display_driver/devices/multivox_network.h"
#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// How often the thread looks whether the memory is still there, and what it tells.
constexpr std::chrono::milliseconds kLookEvery{100};
/// What drivers and simulators show when they start: a moment after the memory was made it may not be there yet.
constexpr int kBitsAtStart = 2;
constexpr size_t kLongestName = 200;  // bytes; systems allow 255 for the whole name

}  // namespace

MultivoxDevice::MultivoxDevice(std::unique_ptr<MultivoxTarget> target, const DisplayProfile& profile,
                               const VoxelGrid& grid)
    : info_{.kind = "multivox", .name = target->name(), .serial = {}, .link = target->link()},
      profile_(profile),
      newestDiff_(static_cast<size_t>(profile.storedSlices()), 0),
      target_(std::move(target)),
      resampler_(profile, grid),
      thread_([this] { run(); }) {}

MultivoxDevice::~MultivoxDevice() {
  close();
}

void MultivoxDevice::close() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    wake_.notify_all();
  }
  target_->stop();
  if (thread_.joinable()) {
    thread_.join();
  }
  for (std::optional<Frame>* frame : {&staged_, &pending_}) {
    if (*frame) {
      ++telemetry_.framesLost;
      end(**frame, FrameStage::kLost, "the device was closed before it was shown");
      frame->reset();
    }
  }
  telemetry_.connected = false;
}

std::shared_ptr<const FrameFence> MultivoxDevice::submitFrame(std::shared_ptr<const Volume> volume,
                                                              std::optional<std::span<const int>> changedSlices) {
  OC_CHECK(volume->profile() == profile_, "a volume of another profile");
  const std::lock_guard lock(mutex_);
  OC_CHECK(!stop_, "the device is closed");
  if (changedSlices) {
    for (const int slice : *changedSlices) {
      newestDiff_.at(static_cast<size_t>(slice)) = 1;
    }
  } else {
    std::ranges::fill(newestDiff_, uint8_t{1});
  }
  ++telemetry_.framesSubmitted;
  if (pending_) {
    ++telemetry_.framesDropped;
    end(*pending_, FrameStage::kDropped, "a newer frame took its place before it was written");
  }
  pending_ = Frame{.fence = std::make_shared<FrameFence>(++lastNumber_), .volume = std::move(volume), .state = {}};
  wake_.notify_all();
  return pending_->fence;
}

void MultivoxDevice::present(FrameNumber frame, const Presentation&) {
  const std::lock_guard lock(mutex_);
  for (std::optional<Frame>* known : {&staged_, &pending_}) {
    if (*known && (*known)->fence->number() == frame) {
      (*known)->asked = true;
      wake_.notify_all();
    }
  }
}

Telemetry MultivoxDevice::telemetry() {
  const std::lock_guard lock(mutex_);
  return telemetry_;
}

void MultivoxDevice::end(Frame& frame, FrameStage stage, const std::string& problem) {
  frame.state.stage = stage;
  frame.state.problem = problem;
  frame.fence->moveTo(frame.state);
}

void MultivoxDevice::noteTarget() {
  telemetry_.bytesSent = target_->bytesSent();
  if (!target_->problem().empty()) {
    telemetry_.lastProblem = target_->problem();
  }
}

void MultivoxDevice::run() {
  std::unique_lock lock(mutex_);
  while (!stop_) {
    if (!lookAtTarget(lock)) {
      wake_.wait_for(lock, kLookEvery, [this] { return stop_; });
      continue;
    }
    if (mustShow()) {
      showStaged(lock);
      continue;
    }
    if (pending_) {
      takeNewest(lock);  // while the page rests, so that the time is not lost; a newer one may still take its place
    }
    const bool write = shownMissing_ || (staged_ && !stagedWritten_);
    if (!write) {
      wake_.wait_for(lock, kLookEvery, [this] { return stop_ || pending_ || mustShow(); });
    } else if (MultivoxTarget::Clock::now() < target_->rested()) {
      wake_.wait_until(lock, target_->rested(), [this] { return stop_ || pending_; });
    } else if (shownMissing_) {
      showAgain(lock);
    } else {
      writeStaged(lock);
    }
  }
}

/// Whether there is a display to write to.
bool MultivoxDevice::lookAtTarget(std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  const MultivoxTarget::Found found = target_->look();
  const std::optional<MultivoxStatus> status = target_->status();
  lock.lock();
  noteTarget();
  telemetry_.connected = status.has_value();
  telemetry_.rotationsPerMinute = status ? status->revolutionsPerMinute : 0;
  if (!status) {
    stagedWritten_ = false;
    return false;
  }
  shownBits_ = status->bitsPerChannel == 0 ? kBitsAtStart : std::min(status->bitsPerChannel, kMaxShownBits);
  if (found == MultivoxTarget::Found::kNew) {
    shownMissing_ = !shownCells_.empty();
    stagedWritten_ = false;
    telemetry_.reconnections += std::exchange(everConnected_, true) ? 1 : 0;
  }
  return true;
}

void MultivoxDevice::takeNewest(std::unique_lock<std::mutex>& lock) {
  if (staged_) {
    ++telemetry_.framesDropped;
    end(*staged_, FrameStage::kDropped, "a newer frame took its place before it was shown");
  }
  staged_ = std::exchange(pending_, std::nullopt);
  stagedWritten_ = false;
  staged_->state.stage = FrameStage::kSending;
  staged_->fence->moveTo(staged_->state);
  std::vector<int> changed;
  for (size_t slice = 0; slice < newestDiff_.size(); ++slice) {
    if (std::exchange(newestDiff_[slice], uint8_t{0}) != 0) {
      changed.push_back(static_cast<int>(slice));
    }
  }
  const std::shared_ptr<const Volume> volume = std::move(staged_->volume);
  lock.unlock();
  resampler_.update(*volume, changed, shownBits_);
  lock.lock();
}

void MultivoxDevice::writeStaged(std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  stagedWritten_ = target_->write(resampler_.cells());
  const auto now = MultivoxTarget::Clock::now();
  lock.lock();
  noteTarget();
  if (!stagedWritten_) {
    return;
  }
  FrameState& state = staged_->state;
  state.bytes = target_->frameBytes();
  if (state.stage != FrameStage::kArrived) {  // it has where the display was lost since
    ++telemetry_.framesArrived;
    state.stage = FrameStage::kArrived;
    state.sent = state.arrived = now;
    staged_->fence->moveTo(state);
  }
}

void MultivoxDevice::showStaged(std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  const bool shown = target_->show();
  lock.lock();
  noteTarget();
  if (!shown) {
    stagedWritten_ = false;
    return;
  }
  shownCells_.assign(resampler_.cells().begin(), resampler_.cells().end());
  ++telemetry_.framesShown;
  FrameState& state = staged_->state;
  state.shown = MultivoxTarget::Clock::now();
  if (target_->sendsWhenShown()) {
    state.sent = state.arrived = state.shown;
  }
  end(*staged_, FrameStage::kShown, {});
  staged_.reset();
}

void MultivoxDevice::showAgain(std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  stagedWritten_ = false;  // what the target had made ready gives way
  const bool shown = target_->write(shownCells_) && target_->show();
  lock.lock();
  noteTarget();
  shownMissing_ = !shown;
}

std::string multivoxObject(const std::string& name) {
  std::string object = name.starts_with('/') ? name : fmt::format("/{}_double_buffer", name.empty() ? "vortex" : name);
  if (object.size() < 2 || object.size() > kLongestName || object.find('/', 1) != std::string::npos ||
      object.find('\0') != std::string::npos) {
    throw InputError(
        "no shared memory can have this name", fmt::format("multivox:{}", name),
        "give a display's name (multivox:vortex), that of its shared memory with one slash at its front, or a host "
        "(multivox:vortex.local)");
  }
  return object;
}

std::unique_ptr<Device> openMultivox(const std::string& name, const DisplayProfile& profile) {
  const VoxelGrid grid;
  if (const std::optional<MultivoxPlace> place = multivoxPlace(name)) {
    return std::make_unique<MultivoxDevice>(std::make_unique<MultivoxNetwork>(*place, grid), profile, grid);
  }
  return std::make_unique<MultivoxDevice>(std::make_unique<MultivoxMemory>(multivoxObject(name), grid), profile, grid);
}

}  // namespace ocelli
