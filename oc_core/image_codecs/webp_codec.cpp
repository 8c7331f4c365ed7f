#include "oc_core/image_codecs/webp_codec.h"

#include <webp/decode.h>
#include <webp/encode.h>

#include <string>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/image_codecs/codec_error.h"
#include "oc_core/image_codecs/depth_prediction.h"

namespace ocelli {
namespace {

constexpr const char* kWebpName = "WebP";
constexpr int kStride = 3;

const uint8_t* webpBytes(const std::byte* bytes) {
  return reinterpret_cast<const uint8_t*>(bytes);
}

/// Frees what libwebp allocated.
struct WebpMemory {
  WebPPicture picture;
  WebPMemoryWriter writer;

  WebpMemory() : picture(), writer() {
    OC_CHECK(WebPPictureInit(&picture) != 0, "headers and library of WebP belong together");
    WebPMemoryWriterInit(&writer);
  }
  ~WebpMemory() {
    WebPPictureFree(&picture);
    WebPMemoryWriterClear(&writer);
  }
  WebpMemory(const WebpMemory&) = delete;
  WebpMemory& operator=(const WebpMemory&) = delete;
};

std::vector<std::byte> webpFile(const Image<Rgb8>& image, const WebPConfig& config) {
  WebpMemory memory;
  memory.picture.use_argb = 1;
  memory.picture.width = image.width();
  memory.picture.height = image.height();
  memory.picture.writer = WebPMemoryWrite;
  memory.picture.custom_ptr = &memory.writer;
  const auto* pixels = reinterpret_cast<const uint8_t*>(image.data());
  if (WebPPictureImportRGB(&memory.picture, pixels, kStride * image.width()) == 0 ||
      WebPEncode(&config, &memory.picture) == 0) {
    throw WorkError("cannot make a WebP of this image (error " + std::to_string(memory.picture.error_code) + ")",
                    "image", "use a smaller one");
  }
  const auto* first = reinterpret_cast<const std::byte*>(memory.writer.mem);
  return {first, first + memory.writer.size};
}

}  // namespace

std::vector<std::byte> encodeWebp(const Image<Rgb8>& image, double quality) {
  WebPConfig config;
  OC_CHECK(WebPConfigInit(&config) != 0, "headers and library of WebP belong together");
  config.quality = static_cast<float>(quality);
  config.method = 4;
  config.use_sharp_yuv = 1;
  config.thread_level = 1;
  return webpFile(image, config);
}

std::vector<std::byte> encodeLosslessWebp(const Image<Rgb8>& image, double /*quality*/) {
  constexpr int kLevel = 4;  // of 9: higher ones take several times as long for a few bytes
  WebPConfig config;
  OC_CHECK(WebPConfigInit(&config) != 0 && WebPConfigLosslessPreset(&config, kLevel) != 0,
           "headers and library of WebP belong together");
  config.exact = 1;
  config.thread_level = 1;
  return webpFile(image, config);
}

Image<Rgb8> decodeWebp(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  checkExpectedSize(kWebpName, expectedSize);
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(webpBytes(bytes.data()), bytes.size(), &features) != VP8_STATUS_OK) {
    failDecoding(kWebpName, "it does not start like one");
  }
  if (features.has_animation != 0) {
    failDecoding(kWebpName, "it is animated");
  }
  checkDecodedSize(kWebpName, features.width, features.height, expectedSize);
  Image<Rgb8> image(expectedSize.x, expectedSize.y);
  auto* pixels = reinterpret_cast<uint8_t*>(image.data());
  if (WebPDecodeRGBInto(webpBytes(bytes.data()), bytes.size(), pixels, image.size() * sizeof(Rgb8),
                        kStride * image.width()) == nullptr) {
    failDecoding(kWebpName, "it is damaged, or ends too early");
  }
  return image;
}

std::vector<std::byte> encodeWebpDepth(const Image<uint16_t>& image) {
  const std::vector<std::byte> residuals = depthResiduals(image);
  Image<Rgb8> split(image.width(), image.height());
  for (size_t i = 0; i < image.size(); ++i) {
    split[i] = {static_cast<uint8_t>(residuals[i]), static_cast<uint8_t>(residuals[image.size() + i]), 0};
  }
  return encodeLosslessWebp(split, 0);
}

Image<uint16_t> decodeWebpDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  const Image<Rgb8> split = decodeWebp(bytes, expectedSize);
  std::vector<std::byte> residuals(2 * split.size());
  for (size_t i = 0; i < split.size(); ++i) {
    residuals[i] = static_cast<std::byte>(split[i].x);
    residuals[split.size() + i] = static_cast<std::byte>(split[i].y);
  }
  return depthFromResiduals(residuals, expectedSize);
}

}  // namespace ocelli
