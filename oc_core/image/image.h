// A dense image in memory, row 0 at the top.
#pragma once

#include <cstddef>
#include <vector>

#include "oc_core/base/check.h"

namespace ocelli {

template <class Pixel>
class Image {
 public:
  Image() = default;
  Image(int width, int height, const Pixel& fill = Pixel{})
      : width_(width), height_(height), pixels_(pixelCount(width, height), fill) {}

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }
  size_t size() const { return pixels_.size(); }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  Pixel& operator()(int x, int y) { return pixels_[index(x, y)]; }
  const Pixel& operator()(int x, int y) const { return pixels_[index(x, y)]; }
  Pixel& operator[](size_t i) { return pixels_[i]; }
  const Pixel& operator[](size_t i) const { return pixels_[i]; }
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }

  Pixel* data() { return pixels_.data(); }
  const Pixel* data() const { return pixels_.data(); }
  auto begin() { return pixels_.begin(); }
  auto end() { return pixels_.end(); }
  auto begin() const { return pixels_.begin(); }
  auto end() const { return pixels_.end(); }

  bool operator==(const Image&) const = default;

 private:
  static size_t pixelCount(int width, int height) {
    OC_CHECK(width >= 0 && height >= 0, "an image cannot have a negative size");
    return static_cast<size_t>(width) * static_cast<size_t>(height);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

}  // namespace ocelli
