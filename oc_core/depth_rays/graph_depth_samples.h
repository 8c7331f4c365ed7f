// What each pixel of a graph camera's image shows, as graph_depth_image.h compares it: the frustum, and 1/w of the
// surface in it.
#pragma once

#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

class GraphDepthSamples {
 public:
  static constexpr int kTile = 8;  ///< pixels a side

  struct Sample {
    int frustum = -1;  ///< -1 where nothing is seen
    double inverseWeight = 0;
  };
  /// What the pixels of a tile show, and those around it that a step out of it may look at.
  struct Tile {
    bool uniform = true;  ///< all of one frustum, or all nothing
    int frustum = -1;
    double nearest = 0;  ///< the greatest 1/w
    double farthest = 0;
  };

  /// `fragments` is of the camera's size.
  GraphDepthSamples(const GraphCamera& camera, const FragmentImage& fragments);

  /// The pixel at image coordinates; beyond the borders the nearest one.
  glm::ivec2 pixelOf(const glm::dvec2& place) const;
  const Sample& operator[](const glm::ivec2& pixel) const { return samples_(pixel.x, pixel.y); }
  bool shows(const glm::ivec2& pixel, int frustum) const;
  /// What a pixel's surface would show at a place nearby if it were flat.
  Sample extended(const glm::ivec2& pixel, const glm::dvec2& place) const;
  /// The tile that holds a pixel, and its first pixel.
  const Tile& tileOf(const glm::ivec2& pixel) const { return tiles_(pixel.x / kTile, pixel.y / kTile); }
  static glm::ivec2 tileCorner(const glm::ivec2& pixel) { return pixel / kTile * kTile; }

  /// Whether k is i, or rays of i go on to it, now or later.
  bool comesBefore(int i, int k) const;

 private:
  void numberFrusta(const GraphCamera& camera);
  void readSamples(const GraphCamera& camera, const FragmentImage& fragments);
  void sumUpTiles();

  std::vector<int> order_;       ///< of each frustum, a number: those that its rays go on to come right after it,
  std::vector<int> lastBehind_;  ///< up to this one
  Image<Sample> samples_;
  Image<Tile> tiles_;
};

}  // namespace ocelli
