#include "oc_core/feeds_live/feed_stream.h"

#include <fmt/format.h>

#include <chrono>
#include <glm/common.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/steady_time.h"
#include "oc_core/feeds_live/feed_clock.h"

namespace ocelli {
namespace {

constexpr size_t kMaxQueued = 8;

constexpr double kFirstRetrySeconds = 0.1;
constexpr double kMaxRetrySeconds = 2;

constexpr size_t kSampleStep = 37;    ///< of the pixels that are compared
constexpr double kSameLevels = 0.35;  ///< mean difference, of 255: less than noise, more than a codec's own changes
/// A sample that moved, channels together, and how many have when something small does, in a feed without noise.
constexpr int kMovedLevels = 90;
constexpr int kMovedSamples = 3;

std::vector<Rgb8> samplesOf(const Image<Rgb8>& image) {
  std::vector<Rgb8> samples;
  samples.reserve(image.size() / kSampleStep + 1);
  for (size_t i = 0; i < image.size(); i += kSampleStep) {
    samples.push_back(image[i]);
  }
  return samples;
}

/// Neither noise all over it, nor anything in it that moves.
bool areSame(const std::vector<Rgb8>& a, const std::vector<Rgb8>& b) {
  if (a.size() != b.size()) {
    return false;
  }
  double sum = 0;
  int moved = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const glm::ivec3 difference = glm::abs(glm::ivec3(a[i]) - glm::ivec3(b[i]));
    sum += difference.x + difference.y + difference.z;
    moved += difference.x + difference.y + difference.z > kMovedLevels ? 1 : 0;
  }
  return sum <= 3 * kSameLevels * static_cast<double>(a.size()) && moved < kMovedSamples;
}

}  // namespace

FeedStream::FeedStream(const Feed& feed, const FeedStreamOptions& options)
    : feed_(feed), options_(options), thread_([this] { read(); }) {}

FeedStream::~FeedStream() {
  stop_ = true;
  changed_.notify_all();
  thread_.join();
}

void FeedStream::read() {
  const bool mayComeBack = videoSourceKind(feed_.source).mayBeLive;
  std::string message;
  double rest = kFirstRetrySeconds;
  while (readOnce(message) && mayComeBack && !stop_) {
    std::unique_lock lock(mutex_);
    rest = isBroken_ ? std::min(2 * rest, kMaxRetrySeconds) : kFirstRetrySeconds;
    isBroken_ = true;
    message_ = message;
    changed_.notify_all();
    changed_.wait_for(lock, std::chrono::duration<double>(rest), [&] { return stop_.load(); });
  }
  const std::lock_guard lock(mutex_);
  isOver_ = true;
  message_ = message;
  changed_.notify_all();
}

bool FeedStream::readOnce(std::string& message) {
  message.clear();
  try {
    VideoReader reader({feed_.source, feed_.width, feed_.height, feed_.framesPerSecond, feed_.ffmpegOptions},
                       options_.maxSilenceSeconds, stop_);
    if (reader.width() != feed_.width || reader.height() != feed_.height) {
      throw InputError(fmt::format("the feed \"{}\" has {}x{} pixels, the setup says {}x{}", feed_.name, reader.width(),
                                   reader.height(), feed_.width, feed_.height),
                       feed_.source, "set \"width\" and \"height\" to those of the video");
    }
    const bool isLive = reader.isLive();
    FeedClock clock(!options_.isLiveRun ? FeedClock::Kind::kRecorded
                    : isLive            ? FeedClock::Kind::kLive
                                        : FeedClock::Kind::kReplayed);
    if (const std::optional<double> end = reader.endSeconds(); end && !options_.isLiveRun) {
      const std::lock_guard lock(mutex_);
      end_ = *end - feed_.clockOffsetSeconds;
    }
    bool isAnyRead = false;
    for (VideoFrame frame; !stop_ && reader.next(frame); frame = {}) {
      isAnyRead = true;
      frame.seconds =
          clock.placeSeconds(frame.seconds, 1e-9 * static_cast<double>(steadyNanoseconds())) - feed_.clockOffsetSeconds;
      add(std::move(frame), isLive);
    }
    if (!isAnyRead && !stop_) {
      throw InputError("no frame of the feed can be read", feed_.source, "it is cut off or damaged: record it again");
    }
    if (const double missing = stop_ || isLive ? 0 : reader.missingSeconds(); missing > 0) {
      throw WorkError(fmt::format("the feed ends {:.1f} s before the time that it says", missing), feed_.source,
                      "it is cut off: record it again, or go on without the rest");
    }
    if (isLive) {
      throw WorkError("the feed has ended", feed_.source, "start its camera again");
    }
    return false;
  } catch (const Error& error) {
    message = error.what();
  }
  return true;
}

void FeedStream::add(VideoFrame frame, bool isLive) {
  std::unique_lock lock(mutex_);
  reconnections_ += isBroken_ && read_ > 0;
  isBroken_ = false;
  message_.clear();
  if (isLive && queue_.size() >= kMaxQueued) {
    queue_.pop_front();  // who sends it is not held up
    ++skipped_;
  }
  changed_.wait(lock, [&] { return stop_ || queue_.size() < kMaxQueued; });
  ++read_;
  queue_.push_back(std::move(frame));
  changed_.notify_all();
}

bool FeedStream::waitUntilLater(std::unique_lock<std::mutex>& lock, double seconds) {
  const auto isThere = [&] { return isOver_ || (!queue_.empty() && queue_.back().seconds > seconds); };
  // A full queue of frames before that time is taken from while it fills.
  const auto canGoOn = [&] { return isThere() || queue_.size() >= kMaxQueued; };
  if (!options_.isLiveRun && !isLate_ && !canGoOn()) {
    changed_.wait_for(lock, std::chrono::duration<double>(options_.maxWaitSeconds), canGoOn);
  }
  return isThere();
}

std::optional<double> FeedStream::firstSeconds() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(options_.maxWaitSeconds),
                    [&] { return isOver_ || isBroken_ || !queue_.empty(); });
  isLate_ = queue_.empty() && !isOver_;
  return queue_.empty() ? std::nullopt : std::optional(queue_.front().seconds);
}

std::optional<VideoFrame> FeedStream::take(double seconds) {
  std::optional<VideoFrame> taken;
  std::unique_lock lock(mutex_);
  for (bool isDone = false; !isDone;) {
    isDone = waitUntilLater(lock, seconds) || queue_.size() < kMaxQueued;
    bool isMoved = false;
    while (!queue_.empty() && queue_.front().seconds <= seconds) {
      skipped_ += taken.has_value();
      taken = std::move(queue_.front());
      queue_.pop_front();
      isMoved = true;
    }
    changed_.notify_all();
    isLate_ = !isOver_ && (isLate_ || isDone) && queue_.empty() && !taken &&
              (!options_.isLiveRun || read_ == 0 || seconds - lastTaken_ >= options_.frozenSeconds);
    isDone = isDone || !isMoved;
  }
  if (taken) {
    noteChange(*taken);
  }
  return taken;
}

void FeedStream::noteChange(const VideoFrame& frame) {
  std::vector<Rgb8> samples = samplesOf(frame.image);
  if (!sameSince_ || !areSame(samples, lastSamples_)) {
    sameSince_ = frame.seconds;
    lastSamples_ = std::move(samples);
  }
  lastTaken_ = frame.seconds;
}

bool FeedStream::isGoingOn() const {
  const std::lock_guard lock(mutex_);
  return !isOver_ || !queue_.empty();
}

std::optional<double> FeedStream::endSeconds() const {
  const std::lock_guard lock(mutex_);
  return end_;
}

std::optional<double> FeedStream::nextSeconds() const {
  const std::lock_guard lock(mutex_);
  return queue_.empty() ? std::nullopt : std::optional(queue_.front().seconds);
}

FeedState FeedStream::state() const {
  const std::lock_guard lock(mutex_);
  if ((isOver_ || isBroken_) && queue_.empty()) {
    return message_.empty() ? FeedState::kEnded : FeedState::kLost;
  }
  if (isLate_) {
    return FeedState::kLate;
  }
  return sameSince_ && lastTaken_ - *sameSince_ >= options_.frozenSeconds ? FeedState::kFrozen : FeedState::kLive;
}

std::string FeedStream::message() const {
  const std::lock_guard lock(mutex_);
  return message_;
}

size_t FeedStream::framesSkipped() const {
  const std::lock_guard lock(mutex_);
  return skipped_;
}

size_t FeedStream::reconnections() const {
  const std::lock_guard lock(mutex_);
  return reconnections_;
}

size_t FeedStream::framesRead() const {
  const std::lock_guard lock(mutex_);
  return read_;
}

}  // namespace ocelli
