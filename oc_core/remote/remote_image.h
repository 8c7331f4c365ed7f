// An image of a general pinhole as it goes over a link: a header in JSON, colours and depths in the formats that it
// names (oc_core/image_codecs), as docs/remote_protocol.md says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "oc_core/ocri/reference_image.h"
#include "oc_core/remote/remote_settings.h"

namespace ocelli {

struct RemoteImageHeader {
  /// What a client has to be ready for.
  static constexpr size_t kMaxPlaneBytes = size_t{1} << 26;
  static constexpr size_t kMaxTextBytes = size_t{64} << 10;

  uint32_t id = 0;        ///< of the image among those of a connection
  uint32_t sequence = 0;  ///< of the request that it answers
  View view;              ///< of the reference pinhole
  glm::ivec2 size{1};     ///< pixels
  GpcLayout layout{.regions = {}};
  std::string colorCodec;
  size_t colorBytes = 0;
  std::string depthCodec;
  size_t depthBytes = 0;
  double inverseNear = 1;  ///< as RemoteDepth
  double inverseFar = 1;
  int levels = 2;
  double drawSeconds = 0;
  double encodeSeconds = 0;

  bool operator==(const RemoteImageHeader&) const = default;
};

std::string jsonText(const RemoteImageHeader& header);
/// Throws InputError for a text that is no such header, for formats that this build does not have, and for sizes beyond
/// the limits of RemoteImageHeader and image_codec.h.
RemoteImageHeader remoteImageHeaderFromJson(const std::string& text);

struct RemoteImage {
  uint32_t id = 0;
  uint32_t sequence = 0;
  std::string headerJson{};
  std::vector<std::byte> color{};
  std::vector<std::byte> depth{};
};

/// Of a pinhole, plain or general. Its time goes into the header, `drawSeconds` as it is. Throws InputError where
/// settings are not valid.
RemoteImage encodeRemoteImage(const ReferenceImage& image, const RemoteSettings& settings, uint32_t id,
                              uint32_t sequence, double drawSeconds = 0);

/// The other way; depths are smoothed within half a level (depth_smoothing.h). Where `depth` is empty, as while it is
/// on its way, no pixel holds a sample, and the colours serve views from the same eye alone. Throws InputError for
/// whatever bytes are no such image.
ReferenceImage decodeRemoteImage(const std::string& headerJson, std::span<const std::byte> color,
                                 std::span<const std::byte> depth);

}  // namespace ocelli
