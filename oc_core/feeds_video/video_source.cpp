#include "oc_core/feeds_video/video_source.h"

extern "C" {
#include <libavutil/error.h>
}

#include <algorithm>
#include <array>
#include <cerrno>

namespace ocelli {
namespace {

constexpr const char* kStartCamera = "start what sends it, and check the address, the port and the firewall";

constexpr std::array<VideoSourceKind, 11> kKinds{{
    {"v4l2:", "v4l2", true, true, true, true, "connect the camera; `ls /dev/video*` shows the devices that are there",
     "close other programs that use the camera, and join the group `video` (adduser USER video)"},
    {"rtsp://", nullptr, false, true, false, false, "check the path in the address: the server has no such feed",
     kStartCamera},
    {"http://", nullptr, false, true, false, false, "check the path in the address: the server has no such page",
     kStartCamera},
    {"https://", nullptr, false, true, false, false, "check the path in the address: the server has no such page",
     "start what sends it, and check the address, the port, the firewall and the certificate of the server"},
    {"rtmp://", nullptr, false, true, false, false, "check the path in the address: the server has no such feed",
     kStartCamera},
    {"rtmps://", nullptr, false, true, false, false, "check the path in the address: the server has no such feed",
     kStartCamera},
    {"srt://", nullptr, false, true, true, false, kStartCamera, kStartCamera},
    {"rtp://", nullptr, false, true, true, false, kStartCamera, kStartCamera},
    {"udp://", nullptr, false, true, true, false, kStartCamera, kStartCamera},
    {"tcp://", nullptr, false, true, true, false, kStartCamera, kStartCamera},
    {"", nullptr, false, false, false, false, "check the path: in a setup, paths begin in its folder",
     "check that this is a video or an image: `ffprobe` says what FFmpeg makes of it"},
}};

}  // namespace

const VideoSourceKind& videoSourceKind(const std::string& name) {
  return *std::ranges::find_if(kKinds, [&](const VideoSourceKind& kind) { return name.starts_with(kind.prefix); });
}

std::string ffmpegNameOf(const std::string& source) {
  const VideoSourceKind& kind = videoSourceKind(source);
  const std::string prefix = kind.prefix;
  if (kind.isPrefixOurs) {
    return source.substr(prefix.size());
  }
  return prefix.empty() && source.find("://") == std::string::npos ? "file:" + source : source;
}

std::string adviceOnSource(const VideoSource& source, int code) {
  const VideoSourceKind& kind = videoSourceKind(source.name);
  const bool isMissing =
      code == AVERROR(ENOENT) || code == AVERROR(ENODEV) || code == AVERROR(ENXIO) || code == AVERROR_HTTP_NOT_FOUND;
  if (code == AVERROR_DEMUXER_NOT_FOUND || code == AVERROR_PROTOCOL_NOT_FOUND) {
    return "this FFmpeg cannot read such sources: `ffmpeg -protocols` and `ffmpeg -devices` list what it can";
  }
  if (code == AVERROR(EINVAL) && kind.takesSize) {
    return "the camera has no such size, rate or option: `ffmpeg -f v4l2 -list_formats all -i DEVICE` lists what it "
           "has";
  }
  return isMissing ? kind.whenMissing : kind.whenRefused;
}

}  // namespace ocelli
