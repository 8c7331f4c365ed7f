// What FFmpeg's error codes say. For the .cpp files of this room.
#pragma once

#include <string>

namespace ocelli {

std::string ffmpegErrorText(int code);

}  // namespace ocelli
