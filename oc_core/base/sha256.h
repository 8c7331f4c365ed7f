// SHA-256, for telling whether two texts or images are the same.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ocelli {

/// Hexadecimal, 64 characters.
std::string sha256(std::span<const uint8_t> bytes);
std::string sha256(std::string_view text);

}  // namespace ocelli
