#include "oc_core/feeds_live/feed_stream.h"

#include <fmt/format.h>

#include <chrono>
#include <glm/common.hpp>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kMaxQueued = 8;

constexpr size_t kSampleStep = 37;    ///< of the pixels that are compared
constexpr double kSameLevels = 0.35;  ///< mean difference, of 255: less than noise, more than a codec's own changes

std::vector<Rgb8> samplesOf(const Image<Rgb8>& image) {
  std::vector<Rgb8> samples;
  samples.reserve(image.size() / kSampleStep + 1);
  for (size_t i = 0; i < image.size(); i += kSampleStep) {
    samples.push_back(image[i]);
  }
  return samples;
}

bool areSame(const std::vector<Rgb8>& a, const std::vector<Rgb8>& b) {
  if (a.size() != b.size()) {
    return false;
  }
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const glm::ivec3 difference = glm::abs(glm::ivec3(a[i]) - glm::ivec3(b[i]));
    sum += difference.x + difference.y + difference.z;
  }
  return sum <= 3 * kSameLevels * static_cast<double>(a.size());
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
  std::string message;
  try {
    VideoReader reader(feed_.source, options_.maxSilenceSeconds, stop_);
    if (reader.width() != feed_.width || reader.height() != feed_.height) {
      throw InputError(fmt::format("the feed \"{}\" has {}x{} pixels, the setup says {}x{}", feed_.name, reader.width(),
                                   reader.height(), feed_.width, feed_.height),
                       feed_.source, "set \"width\" and \"height\" to those of the video");
    }
    VideoFrame frame;
    while (!stop_ && reader.next(frame)) {
      frame.seconds -= feed_.clockOffsetSeconds;
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return stop_ || queue_.size() < kMaxQueued; });
      ++read_;
      queue_.push_back(std::move(frame));
      frame = {};
      changed_.notify_all();
    }
  } catch (const Error& error) {
    message = error.what();
  }
  const std::lock_guard lock(mutex_);
  isOver_ = true;
  message_ = message;
  changed_.notify_all();
}

bool FeedStream::waitUntilLater(std::unique_lock<std::mutex>& lock, double seconds) {
  const auto isThere = [&] { return isOver_ || (!queue_.empty() && queue_.back().seconds > seconds); };
  // A full queue of frames before that time is taken from while it fills.
  const auto canGoOn = [&] { return isThere() || queue_.size() >= kMaxQueued; };
  if (!isLate_ && !canGoOn()) {
    changed_.wait_for(lock, std::chrono::duration<double>(options_.maxWaitSeconds), canGoOn);
  }
  return isThere();
}

std::optional<double> FeedStream::firstSeconds() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(options_.maxWaitSeconds),
                    [&] { return isOver_ || !queue_.empty(); });
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
    isLate_ = !isOver_ && (isLate_ || isDone) && queue_.empty() && !taken;
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

FeedState FeedStream::state() const {
  const std::lock_guard lock(mutex_);
  if (isOver_ && queue_.empty()) {
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

size_t FeedStream::framesRead() const {
  const std::lock_guard lock(mutex_);
  return read_;
}

}  // namespace ocelli
