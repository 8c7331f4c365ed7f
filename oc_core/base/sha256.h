// SHA-256, for telling whether two texts or images are the same.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ocelli {

using Digest = std::array<uint8_t, 32>;
Digest sha256Digest(std::string_view bytes);
/// 64 small hexadecimal digits.
std::string hexadecimal(const Digest& digest);

/// Hexadecimal.
std::string sha256(std::span<const uint8_t> bytes);
std::string sha256(std::string_view text);

}  // namespace ocelli
