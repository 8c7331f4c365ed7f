#include "oc_core/render/visibility_buffer.h"

namespace ocelli {

void VisibilityBuffer::mergePixels(const VisibilityBuffer& other, size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i) {
    if (other.samples_[i].key < samples_[i].key) {
      samples_[i] = other.samples_[i];
    }
  }
}

Fragment VisibilityBuffer::fragment(size_t pixel) const {
  const Sample& sample = samples_[pixel];
  if (sample.key == kEmpty) {
    return {};
  }
  return {std::bit_cast<float>(static_cast<uint32_t>(sample.key >> 32)), static_cast<uint32_t>(sample.key), sample.b1,
          sample.b2};
}

}  // namespace ocelli
