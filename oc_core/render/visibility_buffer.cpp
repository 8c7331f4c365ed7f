#include "oc_core/render/visibility_buffer.h"

namespace ocelli {

void VisibilityBuffer::mergePixels(const VisibilityBuffer& other, size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i) {
    if (other.samples_[i].key < samples_[i].key) {
      samples_[i] = other.samples_[i];
    }
  }
}

}  // namespace ocelli
