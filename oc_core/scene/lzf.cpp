#include "oc_core/scene/lzf.h"

#include <algorithm>

namespace ocelli {

// A byte below 32 begins a run of that many bytes and one more. In others the upper three bits are the length of a copy
// less 2, where 7 says that the next byte is to be added; the lower five bits and the next byte are how far back it
// begins, less 1.
std::optional<std::vector<std::byte>> lzfDecompressed(std::span<const std::byte> bytes, size_t size) {
  constexpr size_t kRuns = 32;
  constexpr size_t kLongCopy = 7;
  std::vector<std::byte> result(size);
  size_t in = 0;
  size_t out = 0;
  const auto next = [&] { return std::to_integer<size_t>(bytes[in++]); };
  while (in < bytes.size()) {
    const size_t control = next();
    if (control < kRuns) {
      const size_t run = control + 1;
      if (run > bytes.size() - in || run > size - out) {
        return std::nullopt;
      }
      std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(in), run,
                  result.begin() + static_cast<std::ptrdiff_t>(out));
      in += run;
      out += run;
      continue;
    }
    size_t length = control >> 5;
    if (length == kLongCopy) {
      if (in == bytes.size()) {
        return std::nullopt;
      }
      length += next();
    }
    length += 2;
    if (in == bytes.size()) {
      return std::nullopt;
    }
    const size_t back = ((control & 31) << 8 | next()) + 1;
    if (back > out || length > size - out) {
      return std::nullopt;
    }
    // One after the other: a copy may overlap what it makes.
    for (size_t i = 0; i < length; ++i, ++out) {
      result[out] = result[out - back];
    }
  }
  if (out != size) {
    return std::nullopt;
  }
  return result;
}

}  // namespace ocelli
