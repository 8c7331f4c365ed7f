#include "oc_core/image_codecs/jxl_stream.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "oc_core/image_codecs/codec_error.h"

namespace ocelli {
namespace {

constexpr std::string_view kCodestreamMark = "\xff\x0a";
constexpr size_t kBoxHeader = 8;  ///< the size of the box with its header, high bytes first, and its type

std::string_view asText(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

size_t boxSize(std::span<const std::byte> file) {
  uint32_t size = 0;
  for (const std::byte each : file.first(4)) {
    size = size << 8 | std::to_integer<uint32_t>(each);
  }
  return size == 0 ? file.size() : size;  // 0: to the end of the file
}

}  // namespace

std::span<const std::byte> jxlCodestream(std::span<const std::byte> file) {
  if (asText(file).starts_with(kCodestreamMark)) {
    return file;
  }
  constexpr std::string_view kSkipped[] = {"JXL ", "ftyp", "jxll"};  // signature, kind of file, level
  while (file.size() >= kBoxHeader) {
    const size_t size = boxSize(file);
    if (size < kBoxHeader || size > file.size()) {
      break;
    }
    const std::string_view type = asText(file.subspan(4, 4));
    if (type == "jxlc") {
      return file.first(size).subspan(kBoxHeader);
    }
    if (std::ranges::find(kSkipped, type) == std::end(kSkipped)) {
      failDecoding(kJxlName, "its file has more than an image");
    }
    file = file.subspan(size);
  }
  failDecoding(kJxlName, "it is damaged, or ends too early");
}

void checkJxlFrameShown(std::span<const std::byte> frame) {
  // ISO/IEC 18181-1, FrameHeader, from the lowest bit: all_default, a frame that is shown; else two bits frame_type, of
  // which 0 is a frame that is shown, and others give what later frames are made of.
  if (frame.empty()) {
    failDecoding(kJxlName, "it ends before its first frame");
  }
  const auto bits = std::to_integer<uint32_t>(frame.front());
  if ((bits & 1U) == 0 && (bits >> 1 & 3U) != 0) {
    failDecoding(kJxlName, "it has a hidden frame");
  }
}

}  // namespace ocelli
