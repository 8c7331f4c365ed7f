// A path played frame by frame: the server draws each picture, compresses it by itself, and the client shows the newest
// that has come (section 5.3.1.3).
#pragma once

#include <map>
#include <span>
#include <string_view>

#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/remote_measure/path_film.h"
#include "oc_core/remote_measure/playback.h"
#include "oc_core/remote_measure/virtual_link.h"

namespace ocelli {

/// When the server sends the next frame.
struct FramePacing {
  const char* name;
  const char* meaning;
  /// Whether the server sends on as soon as the link is free, always the newest view it knows. Otherwise the client
  /// asks for the next frame when the last one has come, and its view is another frame's.
  bool sendsOn;
};
std::span<const FramePacing> framePacings();

/// Compressed frames of a film, each made when it is first wanted.
class FrameBytes {
 public:
  FrameBytes(const PathFilm& film, const ColorCodec& codec, double quality)
      : film_(film), codec_(codec), quality_(quality) {}
  const std::vector<std::byte>& of(size_t frame);
  Image<Rgb8> picture(size_t frame);

 private:
  const PathFilm& film_;
  const ColorCodec& codec_;
  double quality_;
  std::map<size_t, std::vector<std::byte>> frames_;
};

/// `serverSeconds` is what drawing and compressing a frame takes.
Playback playFrames(const RemotePath& path, const LinkSpeed& speed, const FramePacing& pacing, FrameBytes& frames,
                    double serverSeconds);

}  // namespace ocelli
