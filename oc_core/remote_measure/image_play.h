// A path played with images that the client draws from (oc_core/remote/client): the general pinhole's, and its peers.
//
// The server takes the newest request that has come when the last image has left for the link; what waits longer is
// overtaken. Colour is sent before depth. The client decodes on a thread of its own, one message after the other: its
// colours, and once more all of an image when its depth has come. It takes in what is ready, and begins a picture, when
// the path has its next frame. Where drawing takes longer than a frame, the picture comes on the screen when it is
// ready, of the view and of the images that there were when it was begun, and the next one is begun.
#pragma once

#include <optional>
#include <span>

#include "oc_core/remote/client/remote_client.h"
#include "oc_core/remote/remote_scene.h"
#include "oc_core/remote/remote_settings.h"
#include "oc_core/remote_measure/playback.h"
#include "oc_core/remote_measure/virtual_link.h"

namespace ocelli {

/// One row of imageModes().
struct ImageMode {
  const char* name;
  const char* meaning;
  bool hasDepth;
  /// Its images for the settings of the general pinhole's; `equalSize` is the size that makes a plain image take as
  /// many bytes.
  RemoteSettings (*settings)(const RemoteSettings& ours, double equalSize);
};
std::span<const ImageMode> imageModes();
const ImageMode* findImageMode(std::string_view name);

/// The size (pixels by those of the screen) with which a plain pinhole's image of a view takes as many bytes as the
/// general pinhole's, within a percent or so.
double equalBytesSize(const RemoteScene& scene, const View& view, const glm::ivec2& screen, const RemoteSettings& ours);

struct ImagePlayOptions {
  glm::ivec2 screen{1280, 720};
  ClientRule rule;
  std::optional<double> serverSeconds;        ///< to draw and encode an image; nothing: as long as it takes
  std::optional<double> clientFrameSeconds;   ///< to draw a picture; nothing: the median of those drawn so far
  std::optional<double> clientDecodeSeconds;  ///< to decode a message; nothing: as long as it takes
  size_t every = 1;                           ///< one picture of so many frames is drawn, and handed to the sink
};

/// Bytes of a message over a WebSocket with so many bytes of an image: pieces of 32 KiB with 12 bytes in front of each
/// (docs/remote_protocol.md), and the frame of each.
size_t bytesOnTheWire(size_t imageBytes);

/// `sink` gets a picture of each frame that is judged, black ones before the first.
Playback playImages(const RemoteScene& scene, const RemotePath& path, const LinkSpeed& speed, const ImageMode& mode,
                    const RemoteSettings& settings, const ImagePlayOptions& options, const PictureSink& sink);

}  // namespace ocelli
