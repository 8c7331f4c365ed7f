// What a source of video is: a file, a camera, or an address on the network. A kind is a row of a table in
// video_source.cpp: what FFmpeg is told to open it, and what to do where it cannot be.
#pragma once

#include <string>
#include <vector>

namespace ocelli {

struct VideoSource {
  /// A path, "v4l2:/dev/video0", or a URL: rtsp://, http://, https://, udp://, tcp://, and what else FFmpeg knows.
  std::string name;
  /// What a camera is asked for; 0 leaves it to the camera.
  int width = 0;
  int height = 0;
  double framesPerSecond = 0;
  /// "name=value", as `ffmpeg -h demuxer=rtsp` lists them: "rtsp_flags=listen".
  std::vector<std::string> options = {};
};

struct VideoSourceKind {
  const char* prefix;       ///< what sources of this kind begin with; the last row has none, and is for files
  const char* format;       ///< FFmpeg's name of the input; null where it finds out itself
  bool isPrefixOurs;        ///< FFmpeg gets the rest alone
  bool mayBeLive;           ///< frames come when they are taken; live where it has no known length,
  bool isAlwaysLive;        ///< or whatever length its sender says
  bool takesSize;           ///< the size and the rate are asked for
  const char* whenMissing;  ///< what to do where there is no such thing
  const char* whenRefused;  ///< where it does not answer, or may not be used
};

const VideoSourceKind& videoSourceKind(const std::string& name);

/// What FFmpeg opens: files may have names as "left: 1.mkv", which it would take for an address.
std::string ffmpegNameOf(const std::string& source);

/// What is to be done where it cannot be opened. `code` is an error of FFmpeg.
std::string adviceOnSource(const VideoSource& source, int code);

}  // namespace ocelli
