#include "study/views/image_store.h"

#include <algorithm>

#include "display_sim/observing/tone.h"

namespace ocelli {

const KeptImage& PoseImages::at(size_t pose, const TrialLayout& layout) {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<KeptImage>& image = images_[pose];
  if (!image) {
    if (!light_) {
      light_ = std::make_unique<DisplayLight>(options_, layout, camera_);
    }
    if (!gain_) {
      gain_ = light_->gain();
    }
    DisplayLight::Seen seen = light_->at(pose);
    applyTone(seen.light, {.gain = *gain_});
    image = std::make_unique<KeptImage>(srgbFromLinear(seen.light), seen.objects);
    bytes_ += image->bytes();
  }
  return *image;
}

void PoseImages::forgetVolumes() {
  if (const std::unique_lock lock(mutex_, std::try_to_lock); lock) {
    light_.reset();
  }
}

std::shared_ptr<PoseImages> ImageStore::get(const DisplayViewOptions& options, const TrialLayout& layout,
                                            const PinholeCamera& camera) {
  Key key{layout.scene->maze(), layout.scene->mesh().positions.size(),
          layout.objectOffsets, camera.view(),
          camera.width(),       camera.height()};
  const std::lock_guard lock(mutex_);
  const auto known =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.key == key; });
  if (known != entries_.end()) {
    std::rotate(entries_.begin(), known, known + 1);
    return entries_.front().images;
  }
  size_t sum = 0;
  for (const Entry& entry : entries_) {
    sum += entry.images->bytes();
  }
  while (!entries_.empty() && sum > kMaxBytes) {
    sum -= entries_.back().images->bytes();
    entries_.pop_back();
  }
  entries_.push_front({std::move(key), std::make_shared<PoseImages>(options, camera)});
  for (size_t i = kMaxWithVolumes; i < entries_.size(); ++i) {
    entries_[i].images->forgetVolumes();
  }
  return entries_.front().images;
}

size_t ImageStore::bytes() const {
  const std::lock_guard lock(mutex_);
  size_t sum = 0;
  for (const Entry& entry : entries_) {
    sum += entry.images->bytes();
  }
  return sum;
}

}  // namespace ocelli
