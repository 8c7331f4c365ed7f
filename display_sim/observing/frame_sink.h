// Where the frames of a series of images go: a folder of PNG files, or a video that ffmpeg makes.
#pragma once

#include <filesystem>
#include <memory>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// What is written appears under its name with finish(); without it nothing is left. Throws WorkError.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void add(const Image<Rgb8>& frame) = 0;
  virtual void finish() = 0;
};

/// `frame_0000.png` and so on, in `FOLDER.partial` until finish(). Frames of an earlier run are replaced, other files
/// stay. Throws InputError where the folder is a file.
std::unique_ptr<FrameSink> frameFolder(const std::filesystem::path& folder);

struct VideoFormat {
  int width = 0;
  int height = 0;
  double framesPerSecond = 24;
};

/// An .mp4 (H.264) or .webm (VP9) file, encoded by ffmpeg as frames come. Throws WorkError where that is not installed
/// or fails, with what it says, and InputError for other endings.
std::unique_ptr<FrameSink> videoFile(const std::filesystem::path& path, const VideoFormat& format);

/// Which of both the name of an output stands for.
bool isVideo(const std::filesystem::path& path);

}  // namespace ocelli
