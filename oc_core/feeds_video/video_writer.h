// Writes a video frame by frame, each with its own timestamp, through FFmpeg's libraries.
#pragma once

#include <filesystem>
#include <memory>

#include "oc_core/image/png_file.h"

namespace ocelli {

struct VideoWriterOptions {
  double framesPerSecond = 30;  ///< what players are told; timestamps may differ
  double rateFactor = 20;       ///< of x264: 0 to 51, less is better
  bool isLossless = false;      ///< FFV1, in Matroska only
};

class VideoWriter {
 public:
  /// The ending of `path` says the container: .mkv, .mp4. Width and height are even, unless it is lossless. A file at
  /// `path` stays as it was until finish(): until then `path`.partial is written (unfinished_output.h). Throws
  /// InputError where there is no such container or the size is odd, and WorkError where the file cannot be written or
  /// an encoder is missing.
  VideoWriter(const std::filesystem::path& path, int width, int height, const VideoWriterOptions& options);
  /// Without finish() what was written is removed.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// `seconds` is 0 or more and grows from frame to frame.
  void add(const Image<Rgb8>& image, double seconds);
  /// Throws WorkError where what is left cannot be written.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
