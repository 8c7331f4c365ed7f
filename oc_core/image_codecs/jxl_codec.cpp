#include "oc_core/image_codecs/jxl_codec.h"

#include <jxl/decode.h>
#include <jxl/encode.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/image_codecs/codec_error.h"
#include "oc_core/image_codecs/jxl_stream.h"

namespace ocelli {
namespace {

constexpr int kColorEffort = 5;  // of 9: 7, which is libjxl's own, takes three times as long
constexpr int kDepthEffort = 4;

using JxlEncoderHolder = std::unique_ptr<JxlEncoder, decltype(&JxlEncoderDestroy)>;
using JxlDecoderHolder = std::unique_ptr<JxlDecoder, decltype(&JxlDecoderDestroy)>;

/// The loops of libjxl on the threads of the toolkit. It wants to know which thread works, below the number it is
/// told: that is the chunk here. Exceptions must not pass through libjxl.
JxlParallelRetCode runJxlLoop(void* /*runner*/, void* jxl, JxlParallelRunInit init, JxlParallelRunFunction body,
                              uint32_t begin, uint32_t end) {
  const auto chunks = static_cast<size_t>(std::max(1, threadCount()));
  if (const JxlParallelRetCode failed = init(jxl, chunks); failed != 0) {
    return failed;
  }
  try {
    parallelChunks(end - begin, chunks, [&](size_t chunk, size_t first, size_t last) {
      for (size_t i = first; i < last; ++i) {
        body(jxl, begin + static_cast<uint32_t>(i), chunk);
      }
    });
  } catch (...) {  // memory has run out; libjxl ends its work
    return JXL_PARALLEL_RET_RUNNER_ERROR;
  }
  return 0;
}

/// The relation of cjxl between its quality and the Butteraugli distance.
float jxlDistance(double quality) {
  constexpr double kFarthest = 15;
  const double distance = quality >= 30 ? 0.1 + (100 - quality) * 0.09 : 6.4 + std::pow(2.5, (30 - quality) / 5) / 6.25;
  return static_cast<float>(std::min(distance, kFarthest));
}

/// How samples lie in memory, and what they are.
struct JxlPixels {
  const void* data;
  size_t bytes;
  glm::ivec2 size;
  uint32_t channels;
  uint32_t bits;

  JxlPixelFormat format() const {
    return {channels, bits == 8 ? JXL_TYPE_UINT8 : JXL_TYPE_UINT16, JXL_NATIVE_ENDIAN, 0};
  }
};

JxlBasicInfo basicInfoOf(const JxlPixels& pixels, bool lossless) {
  JxlBasicInfo info;
  JxlEncoderInitBasicInfo(&info);
  info.xsize = static_cast<uint32_t>(pixels.size.x);
  info.ysize = static_cast<uint32_t>(pixels.size.y);
  info.bits_per_sample = pixels.bits;
  info.num_color_channels = pixels.channels;
  info.uses_original_profile = lossless ? JXL_TRUE : JXL_FALSE;
  return info;
}

std::vector<std::byte> jxlOutput(JxlEncoder* encoder, const std::string& failure) {
  std::vector<std::byte> bytes(size_t{1} << 16);
  size_t used = 0;
  while (true) {
    auto* next = reinterpret_cast<uint8_t*>(bytes.data() + used);
    size_t left = bytes.size() - used;
    const JxlEncoderStatus status = JxlEncoderProcessOutput(encoder, &next, &left);
    used = bytes.size() - left;
    if (status == JXL_ENC_SUCCESS) {
      break;
    }
    if (status != JXL_ENC_NEED_MORE_OUTPUT) {
      throw WorkError(failure, "image", "use another format");
    }
    bytes.resize(2 * bytes.size());
  }
  bytes.resize(used);
  return bytes;
}

/// What libjxl makes frames for that are not shown; readJxl() takes none.
constexpr JxlEncoderFrameSettingId kHiddenFrames[] = {JXL_ENC_FRAME_SETTING_PATCHES, JXL_ENC_FRAME_SETTING_DOTS,
                                                      JXL_ENC_FRAME_SETTING_PROGRESSIVE_DC};

bool setJxlOption(JxlEncoderFrameSettings* settings, JxlEncoderFrameSettingId option, int64_t value) {
  return JxlEncoderFrameSettingsSetOption(settings, option, value) == JXL_ENC_SUCCESS;
}

/// `distance` of 0: lossless.
std::vector<std::byte> jxlFile(const JxlPixels& pixels, float distance, int effort) {
  const std::string failure = "libjxl cannot make a JPEG XL of this image";
  const JxlEncoderHolder encoder(JxlEncoderCreate(nullptr), JxlEncoderDestroy);
  const bool lossless = distance == 0;
  JxlColorEncoding color;
  JxlColorEncodingSetToSRGB(&color, pixels.channels == 1 ? JXL_TRUE : JXL_FALSE);
  const JxlBasicInfo info = basicInfoOf(pixels, lossless);
  const JxlPixelFormat format = pixels.format();
  bool works = encoder != nullptr &&
               JxlEncoderSetParallelRunner(encoder.get(), runJxlLoop, nullptr) == JXL_ENC_SUCCESS &&
               JxlEncoderSetBasicInfo(encoder.get(), &info) == JXL_ENC_SUCCESS &&
               JxlEncoderSetColorEncoding(encoder.get(), &color) == JXL_ENC_SUCCESS;
  JxlEncoderFrameSettings* settings = works ? JxlEncoderFrameSettingsCreate(encoder.get(), nullptr) : nullptr;
  works = settings != nullptr && setJxlOption(settings, JXL_ENC_FRAME_SETTING_EFFORT, effort) &&
          std::ranges::all_of(kHiddenFrames, [&](auto option) { return setJxlOption(settings, option, 0); }) &&
          (lossless ? JxlEncoderSetFrameLossless(settings, JXL_TRUE)
                    : JxlEncoderSetFrameDistance(settings, distance)) == JXL_ENC_SUCCESS &&
          JxlEncoderAddImageFrame(settings, &format, pixels.data, pixels.bytes) == JXL_ENC_SUCCESS;
  if (!works) {
    throw WorkError(failure, "image", "use another format");
  }
  JxlEncoderCloseInput(encoder.get());
  return jxlOutput(encoder.get(), failure);
}

void checkJxlInfo(JxlDecoder* decoder, const JxlPixels& pixels) {
  JxlBasicInfo info;
  if (JxlDecoderGetBasicInfo(decoder, &info) != JXL_DEC_SUCCESS) {
    failDecoding(kJxlName, "it has no header");
  }
  checkDecodedSize(kJxlName, info.xsize, info.ysize, pixels.size);
  if (info.num_color_channels != pixels.channels || info.num_extra_channels != 0 || info.have_preview != 0 ||
      info.have_animation != 0 || info.bits_per_sample != pixels.bits || info.exponent_bits_per_sample != 0) {
    failDecoding(kJxlName, "it is of another kind");
  }
}

void checkJxlFrame(JxlDecoder* decoder, const JxlPixels& pixels) {
  JxlFrameHeader frame;
  if (JxlDecoderGetFrameHeader(decoder, &frame) != JXL_DEC_SUCCESS) {
    failDecoding(kJxlName, "a frame has no header");
  }
  if (frame.is_last == 0 || frame.layer_info.have_crop != 0 ||
      frame.layer_info.xsize != static_cast<uint32_t>(pixels.size.x) ||
      frame.layer_info.ysize != static_cast<uint32_t>(pixels.size.y)) {
    failDecoding(kJxlName, "it has more than one frame");
  }
}

/// The decoder has read the headers of the image, and nothing of frames. Hands it the rest, which is the last input.
void checkFirstJxlFrame(JxlDecoder* decoder, std::span<const std::byte> stream) {
  const std::span<const std::byte> rest = stream.last(JxlDecoderReleaseInput(decoder));
  checkJxlFrameShown(rest);
  if (JxlDecoderSetInput(decoder, reinterpret_cast<const uint8_t*>(rest.data()), rest.size()) != JXL_DEC_SUCCESS) {
    failDecoding(kJxlName, "libjxl does not go on");
  }
  JxlDecoderCloseInput(decoder);
}

/// `pixels.data` is written to.
void readJxl(std::span<const std::byte> bytes, const JxlPixels& pixels, void* data) {
  const std::span<const std::byte> stream = jxlCodestream(bytes);
  const JxlDecoderHolder decoder(JxlDecoderCreate(nullptr), JxlDecoderDestroy);
  constexpr int kEvents = JXL_DEC_BASIC_INFO | JXL_DEC_COLOR_ENCODING | JXL_DEC_FRAME | JXL_DEC_FULL_IMAGE;
  if (decoder == nullptr || JxlDecoderSetParallelRunner(decoder.get(), runJxlLoop, nullptr) != JXL_DEC_SUCCESS ||
      JxlDecoderSubscribeEvents(decoder.get(), kEvents) != JXL_DEC_SUCCESS ||
      JxlDecoderSetCoalescing(decoder.get(), JXL_FALSE) != JXL_DEC_SUCCESS ||
      JxlDecoderSetInput(decoder.get(), reinterpret_cast<const uint8_t*>(stream.data()), stream.size()) !=
          JXL_DEC_SUCCESS) {
    throw WorkError("libjxl does not start", "JPEG XL", "check its installation");
  }
  const JxlPixelFormat format = pixels.format();
  bool isWhole = false;
  while (true) {
    switch (JxlDecoderProcessInput(decoder.get())) {
      case JXL_DEC_BASIC_INFO:
        checkJxlInfo(decoder.get(), pixels);
        break;
      case JXL_DEC_COLOR_ENCODING:
        checkFirstJxlFrame(decoder.get(), stream);
        break;
      case JXL_DEC_FRAME:
        checkJxlFrame(decoder.get(), pixels);
        break;
      case JXL_DEC_NEED_IMAGE_OUT_BUFFER:
        if (JxlDecoderSetImageOutBuffer(decoder.get(), &format, data, pixels.bytes) != JXL_DEC_SUCCESS) {
          failDecoding(kJxlName, "its pixels are of another kind");
        }
        break;
      case JXL_DEC_FULL_IMAGE:
        isWhole = true;
        break;
      case JXL_DEC_SUCCESS:
        if (!isWhole) {
          failDecoding(kJxlName, "it has no image");
        }
        return;
      default:
        failDecoding(kJxlName, "it is damaged, or ends too early");
    }
  }
}

template <class Pixel>
JxlPixels jxlPixelsOf(const Image<Pixel>& image, uint32_t channels, uint32_t bits) {
  return {image.data(), image.size() * sizeof(Pixel), {image.width(), image.height()}, channels, bits};
}

}  // namespace

std::vector<std::byte> encodeJxl(const Image<Rgb8>& image, double quality) {
  return jxlFile(jxlPixelsOf(image, 3, 8), quality >= 100 ? 0 : jxlDistance(quality), kColorEffort);
}

Image<Rgb8> decodeJxl(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  checkExpectedSize(kJxlName, expectedSize);
  Image<Rgb8> image(expectedSize.x, expectedSize.y);
  readJxl(bytes, jxlPixelsOf(image, 3, 8), image.data());
  return image;
}

std::vector<std::byte> encodeJxlDepth(const Image<uint16_t>& image) {
  return jxlFile(jxlPixelsOf(image, 1, 16), 0, kDepthEffort);
}

Image<uint16_t> decodeJxlDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  checkExpectedSize(kJxlName, expectedSize);
  Image<uint16_t> image(expectedSize.x, expectedSize.y);
  readJxl(bytes, jxlPixelsOf(image, 1, 16), image.data());
  return image;
}

}  // namespace ocelli
