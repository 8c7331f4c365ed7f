// Frames of a video with their timestamps: a file, a camera or a URL, as FFmpeg's libraries read it.
//
// Nothing here waits longer than it is told: a source that stops to answer is an error after so many seconds, and
// stop() ends a wait from another thread.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "oc_core/feeds_video/video_source.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct VideoFrame {
  double seconds = 0;  ///< its timestamp in the clock of the source
  Image<Rgb8> image;
};

class VideoReader {
 public:
  /// Opens a source. Throws InputError where it does not exist, holds no video, has a codec that is missing, or an
  /// option is unknown, and WorkError where it does not answer within `maxWaitSeconds`, or `stop` is set.
  VideoReader(const VideoSource& source, double maxWaitSeconds, const std::atomic<bool>& stop);
  ~VideoReader();
  VideoReader(const VideoReader&) = delete;
  VideoReader& operator=(const VideoReader&) = delete;

  int width() const;
  int height() const;
  /// The next frame, in the order of timestamps; nothing at the end. Frames that cannot be decoded are left out and
  /// counted. Where there are no timestamps, as in streams of H.264 without a container, frames follow one another at
  /// the rate of the video. Throws WorkError where the source does not answer in time, breaks off, changes its size, or
  /// `stop` is set.
  bool next(VideoFrame& frame);
  size_t damagedFrames() const;
  /// The timestamp of its end, where the source says it.
  std::optional<double> endSeconds() const;
  /// After the last frame: how much longer the file says that it would be, where it is cut off; 0 where it is not.
  /// Files with sound are not told, as that may be the longer part.
  double missingSeconds() const;
  /// Whether frames come when they are taken, rather than as fast as they are read.
  bool isLive() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
