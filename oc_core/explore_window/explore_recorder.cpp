#include "oc_core/explore_window/explore_recorder.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// Videos have sides that are even.
int evenSide(int side) {
  return std::max(side / 2 * 2, 2);
}

int64_t framesUntil(double seconds) {
  return static_cast<int64_t>(std::floor(seconds * kExploreFramesPerSecond + 1e-6));
}

}  // namespace

void ExploreRecorder::start(const std::filesystem::path& path, int width, int height) {
  if (!open_) {
    throw InputError("videos are not recorded here", path.string(), "leave the recording out");
  }
  if (recording_) {
    throw InputError("a video is being recorded already", path.string(), "end that one before");
  }
  recording_ = open_(path, evenSide(width), evenSide(height));
  path_ = path;
  width_ = evenSide(width);
  height_ = evenSide(height);
  seconds_ = 0;
  frames_ = 0;
}

bool ExploreRecorder::isDue(double seconds) const {
  return recording_ && framesUntil(seconds_ + seconds) > frames_;
}

void ExploreRecorder::add(const Image<Rgb8>& frame, double seconds) {
  if (!recording_) {
    return;
  }
  seconds_ += seconds;
  const int64_t due = framesUntil(seconds_);
  if (due <= frames_) {
    return;
  }
  Image<Rgb8> cut;
  const bool fits = frame.width() == width_ && frame.height() == height_;
  if (!fits) {
    cut = Image<Rgb8>(width_, height_);
    for (int y = 0; y < std::min(height_, frame.height()); ++y) {
      for (int x = 0; x < std::min(width_, frame.width()); ++x) {
        cut(x, y) = frame(x, y);
      }
    }
  }
  try {
    for (; frames_ < due; ++frames_) {
      recording_->add(fits ? frame : cut);
    }
  } catch (...) {
    recording_.reset();
    throw;
  }
}

void ExploreRecorder::stop() {
  if (!recording_) {
    throw InputError("no video is being recorded", "", "begin one before");
  }
  const auto finish = recording_->finish;
  recording_.reset();
  finish();
}

}  // namespace ocelli
