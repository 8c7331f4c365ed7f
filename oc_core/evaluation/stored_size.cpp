#include "oc_core/evaluation/stored_size.h"

#include <zstd.h>

#include <algorithm>
#include <vector>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr int kLevel = 3;

StoredSize sizeOf(const void* bytes, size_t count) {
  std::vector<char> compressed(ZSTD_compressBound(count));
  const size_t size = ZSTD_compress(compressed.data(), compressed.size(), bytes, count, kLevel);
  OC_CHECK(ZSTD_isError(size) == 0, "zstd refused a buffer of the size that it asked for");
  return {count, size};
}

template <class Array>
StoredSize sizeOf(const Array& values) {
  return values.size() == 0 ? StoredSize{} : sizeOf(values.data(), values.size() * sizeof(values[0]));
}

}  // namespace

StoredSize& StoredSize::operator+=(const StoredSize& other) {
  raw += other.raw;
  compressed += other.compressed;
  return *this;
}

StoredSize storedSize(const ReferenceImage& image) {
  StoredSize size = sizeOf(image.color);
  size += sizeOf(image.t);
  if (std::any_of(image.displacement.begin(), image.displacement.end(),
                  [](const glm::vec2& d) { return d != glm::vec2(0); })) {
    size += sizeOf(image.displacement);
  }
  size += sizeOf(image.position);
  return size;
}

StoredSize storedSize(const Mesh& mesh) {
  StoredSize size = sizeOf(mesh.positions);
  size += sizeOf(mesh.colors);
  size += sizeOf(mesh.triangles);
  return size;
}

}  // namespace ocelli
