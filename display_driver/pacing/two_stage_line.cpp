#include "display_driver/pacing/two_stage_line.h"

#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// One in each stage.
constexpr size_t kStages = 2;

}  // namespace

TwoStageLine::TwoStageLine(FirstStage first)
    : first_(std::move(first)), firstThread_([this] { runFirst(); }), secondThread_([this] { runSecond(); }) {}

TwoStageLine::~TwoStageLine() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  firstThread_.join();
  secondThread_.join();
}

bool TwoStageLine::ready() const {
  const std::lock_guard lock(mutex_);
  return !asked_ && underWay_ < kStages;
}

void TwoStageLine::begin(HostTime seen) {
  {
    const std::lock_guard lock(mutex_);
    OC_CHECK(!asked_, "one is in its first stage");
    asked_ = seen;
    ++underWay_;
  }
  changed_.notify_all();
}

std::optional<SourcedVolume> TwoStageLine::finished() {
  const std::lock_guard lock(mutex_);
  if (made_.empty()) {
    return std::nullopt;
  }
  Made made = std::move(made_.front());
  made_.pop_front();
  --underWay_;
  if (made.failure) {
    std::rethrow_exception(made.failure);
  }
  return std::move(made.volume);
}

void TwoStageLine::runFirst() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || asked_.has_value(); });
    if (stopping_) {
      return;
    }
    const HostTime seen = *asked_;
    lock.unlock();
    SecondStage second;
    try {
      second = first_(seen);
    } catch (...) {
      second = [failure = std::current_exception()]() -> SourcedVolume { std::rethrow_exception(failure); };
    }
    lock.lock();
    asked_.reset();
    between_.push_back(std::move(second));
    changed_.notify_all();
  }
}

void TwoStageLine::runSecond() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !between_.empty(); });
    if (stopping_) {
      return;
    }
    const SecondStage second = std::move(between_.front());
    between_.pop_front();
    lock.unlock();
    Made made;
    try {
      made.volume = second();
    } catch (...) {
      made.failure = std::current_exception();
    }
    lock.lock();
    made_.push_back(std::move(made));
  }
}

}  // namespace ocelli
