// LZF, the compression of Marc Lehmann's LibLZF: runs of bytes as they are, and copies of what came before. Point
// clouds (pcd_points.h) have it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ocelli {

/// The most bytes that three bytes of LZF stand for: no honest file says that it has more.
inline constexpr size_t kMaxLzfCopy = 264;

/// Decompresses to exactly `size` bytes. Nothing where the bytes are damaged, or stand for more or fewer.
std::optional<std::vector<std::byte>> lzfDecompressed(std::span<const std::byte> bytes, size_t size);

}  // namespace ocelli
