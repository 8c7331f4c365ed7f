#include "oc_core/image_codecs/deflate_codec.h"

#include <zlib.h>

#include "oc_core/base/check.h"
#include "oc_core/image_codecs/codec_error.h"
#include "oc_core/image_codecs/depth_prediction.h"

namespace ocelli {
namespace {

constexpr const char* kDeflateName = "deflate depth";
constexpr int kLevel = 9;

/// Bytes as zlib takes them.
const Bytef* zlibBytes(const std::byte* bytes) {
  return reinterpret_cast<const Bytef*>(bytes);
}
Bytef* zlibBytes(std::byte* bytes) {
  return reinterpret_cast<Bytef*>(bytes);
}

}  // namespace

std::vector<std::byte> encodeDeflateDepth(const Image<uint16_t>& image) {
  const std::vector<std::byte> residuals = depthResiduals(image);
  uLongf size = compressBound(residuals.size());
  std::vector<std::byte> bytes(size);
  const int status = compress2(zlibBytes(bytes.data()), &size, zlibBytes(residuals.data()), residuals.size(), kLevel);
  OC_CHECK(status == Z_OK, "zlib has room for all that it makes");
  bytes.resize(size);
  return bytes;
}

Image<uint16_t> decodeDeflateDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  checkExpectedSize(kDeflateName, expectedSize);
  std::vector<std::byte> residuals(2 * static_cast<size_t>(expectedSize.x) * static_cast<size_t>(expectedSize.y));
  uLongf size = residuals.size();
  uLong taken = bytes.size();
  const int status = uncompress2(zlibBytes(residuals.data()), &size, zlibBytes(bytes.data()), &taken);
  if (status != Z_OK || size != residuals.size() || taken != bytes.size()) {
    failDecoding(kDeflateName, status == Z_BUF_ERROR ? "it is too long, or ends too early"
                               : status != Z_OK      ? "it is damaged"
                                                     : "it is of another size");
  }
  return depthFromResiduals(residuals, expectedSize);
}

}  // namespace ocelli
