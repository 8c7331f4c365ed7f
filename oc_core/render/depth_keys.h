// A depth buffer that all threads share: the least key of each pixel, where keys order samples by depth and then by
// triangle index, as those of the visibility buffer do. So what it holds in the end does not depend on any order.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "oc_core/render/fragment_image.h"

namespace ocelli {

class DepthKeys {
 public:
  explicit DepthKeys(size_t pixels) : keys_(pixels) {
    for (std::atomic<uint64_t>& key : keys_) {
      key.store(kEmpty, std::memory_order_relaxed);
    }
  }

  /// `z` is positive, so its bits are ordered as integers.
  static uint64_t key(float z, uint32_t triangle) {
    return static_cast<uint64_t>(std::bit_cast<uint32_t>(z)) << 32 | triangle;
  }

  void offer(size_t pixel, uint64_t key) {
    uint64_t held = keys_[pixel].load(std::memory_order_relaxed);
    while (key < held && !keys_[pixel].compare_exchange_weak(held, key, std::memory_order_relaxed)) {
    }
  }
  bool holds(size_t pixel, uint64_t key) const { return keys_[pixel].load(std::memory_order_relaxed) == key; }

  size_t size() const { return keys_.size(); }
  bool covered(size_t pixel) const { return !holds(pixel, kEmpty); }
  float z(size_t pixel) const {
    return std::bit_cast<float>(static_cast<uint32_t>(keys_[pixel].load(std::memory_order_relaxed) >> 32));
  }
  uint32_t triangle(size_t pixel) const { return static_cast<uint32_t>(keys_[pixel].load(std::memory_order_relaxed)); }

 private:
  static constexpr uint64_t kEmpty = ~uint64_t{0};

  std::vector<std::atomic<uint64_t>> keys_;
};

}  // namespace ocelli
