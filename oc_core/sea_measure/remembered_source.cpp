#include "oc_core/sea_measure/remembered_source.h"

namespace ocelli {

Image<Rgb8> RememberedSource::image(uint32_t index) const {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = images_.find(index); found != images_.end()) {
      return found->second;
    }
  }
  Image<Rgb8> image = source_.image(index);
  const std::lock_guard lock(mutex_);
  if (bytes_ + image.size() * sizeof(Rgb8) <= kMaxRememberedBytes && images_.emplace(index, image).second) {
    bytes_ += image.size() * sizeof(Rgb8);
  }
  return image;
}

}  // namespace ocelli
