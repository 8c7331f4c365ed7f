// A video of the window: frames at the video's own rate, whatever the rate at which the window draws.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "oc_core/explore/explore_offscreen.h"

namespace ocelli {

/// Opens a video of `width` by `height` pixels, at kExploreFramesPerSecond. Throws WorkError and InputError.
using OpenExploreVideo = std::function<ExploreRecording(const std::filesystem::path& path, int width, int height)>;

class ExploreRecorder {
 public:
  explicit ExploreRecorder(OpenExploreVideo open) : open_(std::move(open)) {}

  bool isOn() const { return recording_.has_value(); }
  const std::filesystem::path& path() const { return path_; }
  /// Throws as the video does, and InputError where there are no videos here or one is being recorded.
  void start(const std::filesystem::path& path, int width, int height);
  /// What the window shows after `seconds` more: the frames that are due; images of another size than at the
  /// start are cut, or stand on black.
  void add(const Image<Rgb8>& frame, double seconds);
  /// Whether a frame is due after `seconds` more.
  bool isDue(double seconds) const;
  /// The file is whole then. Throws WorkError, and InputError where nothing is being recorded.
  void stop();

 private:
  OpenExploreVideo open_;
  std::optional<ExploreRecording> recording_;
  std::filesystem::path path_;
  int width_ = 0;
  int height_ = 0;
  double seconds_ = 0;
  int64_t frames_ = 0;
};

}  // namespace ocelli
