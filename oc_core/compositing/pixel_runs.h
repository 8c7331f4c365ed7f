// The pixels of a part of an image that hold something, as a message: runs of neighbours. What a rank draws of its
// share of a scene covers a part of the image alone, and what is empty is not sent.
//
// A run is a header of 16 bytes, its first pixel and how many there are, and the pixels.
#pragma once

#include <cstring>
#include <span>
#include <type_traits>

#include "oc_core/base/check.h"
#include "oc_core/ranks/ranks.h"

namespace ocelli {

struct PixelRun {
  uint64_t first = 0;
  uint64_t count = 0;
};

/// Pixels [begin, end), of which those that `holds(pixel)` are sent.
template <class Pixel, class Holds>
Bytes packRuns(std::span<const Pixel> pixels, size_t begin, size_t end, const Holds& holds) {
  static_assert(std::is_trivially_copyable_v<Pixel>);
  size_t runs = 0;
  size_t held = 0;
  for (size_t i = begin; i < end; ++i) {
    const bool here = holds(pixels[i]);
    held += here ? 1 : 0;
    runs += here && (i == begin || !holds(pixels[i - 1])) ? 1 : 0;
  }
  Bytes bytes(runs * sizeof(PixelRun) + held * sizeof(Pixel));
  std::byte* next = bytes.data();
  for (size_t i = begin; i < end;) {
    if (!holds(pixels[i])) {
      ++i;
      continue;
    }
    const size_t first = i;
    while (i < end && holds(pixels[i])) {
      ++i;
    }
    const PixelRun run{first, i - first};
    std::memcpy(next, &run, sizeof(run));
    std::memcpy(next + sizeof(run), &pixels[first], run.count * sizeof(Pixel));
    next += sizeof(run) + run.count * sizeof(Pixel);
  }
  return bytes;
}

/// Calls `visit(index, pixel)` for the pixels of a message, of an image of `size` pixels.
template <class Pixel, class Visit>
void unpackRuns(std::span<const std::byte> bytes, size_t size, const Visit& visit) {
  while (!bytes.empty()) {
    PixelRun run;
    OC_CHECK(bytes.size() >= sizeof(run), "runs of pixels are whole");
    std::memcpy(&run, bytes.data(), sizeof(run));
    bytes = bytes.subspan(sizeof(run));
    OC_CHECK(run.first <= size && run.count <= size - run.first && run.count * sizeof(Pixel) <= bytes.size(),
             "runs of pixels lie in the image, and are whole");
    for (size_t i = 0; i < run.count; ++i) {
      Pixel pixel;
      std::memcpy(&pixel, bytes.data() + i * sizeof(Pixel), sizeof(Pixel));
      visit(static_cast<size_t>(run.first) + i, pixel);
    }
    bytes = bytes.subspan(run.count * sizeof(Pixel));
  }
}

}  // namespace ocelli
