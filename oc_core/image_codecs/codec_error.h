// What decoders of this room throw.
#pragma once

#include <glm/vec2.hpp>
#include <string>

namespace ocelli {

/// Throws InputError: bytes of a format are damaged, or not what was announced.
[[noreturn]] void failDecoding(const char* codec, const std::string& problem);

/// Throws InputError where a size is not positive or exceeds the limits of image_codec.h, or is not the expected one.
void checkExpectedSize(const char* codec, const glm::ivec2& expectedSize);
void checkDecodedSize(const char* codec, int64_t width, int64_t height, const glm::ivec2& expectedSize);

}  // namespace ocelli
