#include "display_sim/volume_slicing/swept_weights.h"

#include <algorithm>

namespace ocelli {

void SweptWeights::Some::add(size_t brick, const Brick& weights) {
  if (std::ranges::all_of(weights, [](uint8_t weight) { return weight == 255; })) {
    return;
  }
  bricks_.push_back(brick);
  weights_.insert(weights_.end(), weights.begin(), weights.end());
}

SweptWeights::SweptWeights(size_t bricks, const std::vector<Some>& parts) {
  size_t bytes = 0;
  for (const Some& part : parts) {
    bytes += part.weights_.size();
  }
  if (bytes == 0) {
    return;
  }
  places_.assign(bricks, kFull);
  weights_.reserve(bytes);
  for (const Some& part : parts) {
    for (size_t i = 0; i < part.bricks_.size(); ++i) {
      places_[part.bricks_[i]] = static_cast<uint32_t>(weights_.size() / kSweptBrickVoxels + i);
    }
    weights_.insert(weights_.end(), part.weights_.begin(), part.weights_.end());
  }
}

}  // namespace ocelli
