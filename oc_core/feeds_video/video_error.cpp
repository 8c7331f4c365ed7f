#include "oc_core/feeds_video/video_error.h"

extern "C" {
#include <libavutil/error.h>
}

#include <array>

namespace ocelli {

std::string ffmpegErrorText(int code) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(code, text.data(), text.size());
  return text.data();
}

}  // namespace ocelli
