#include "oc_core/render/rasterize_layers.h"

#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/pinhole_triangles.h"

namespace ocelli {
namespace {

/// The closest fragments of different depth at each pixel. What it holds does not depend on the order of drawing.
class LayerBuffer {
 public:
  LayerBuffer(int width, int height, size_t layers)
      : width_(width), height_(height), layers_(layers), samples_(static_cast<size_t>(width) * height * layers) {}

  void draw(uint32_t triangle, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
    scanTriangle(width_, height_, a, b, c, [&](size_t pixel, float z, const auto& weights) {
      const uint64_t key = KeyedSample::keyOf(z, triangle);
      if (key < samples_[(pixel + 1) * layers_ - 1].key) {
        const glm::vec2 w = weights();
        insert(pixel, {key, w.x, w.y});
      }
    });
  }

  void mergePixels(const LayerBuffer& other, size_t begin, size_t end) {
    for (size_t pixel = begin; pixel < end; ++pixel) {
      for (size_t i = pixel * layers_; i < (pixel + 1) * layers_ && other.samples_[i].key != KeyedSample::kEmpty; ++i) {
        insert(pixel, other.samples_[i]);
      }
    }
  }

  Fragment fragment(size_t pixel, size_t layer) const { return samples_[pixel * layers_ + layer].fragment(); }

 private:
  static bool sameDepth(const KeyedSample& a, const KeyedSample& b) { return a.key >> 32 == b.key >> 32; }

  void insert(size_t pixel, const KeyedSample& sample) {
    const auto first = samples_.begin() + static_cast<std::ptrdiff_t>(pixel * layers_);
    const auto last = first + static_cast<std::ptrdiff_t>(layers_);
    const auto behind =
        std::upper_bound(first, last, sample, [](const KeyedSample& a, const KeyedSample& b) { return a.key < b.key; });
    if (behind == last || (behind != first && sameDepth(*(behind - 1), sample))) {
      return;
    }
    if (!sameDepth(*behind, sample)) {
      std::move_backward(behind, last - 1, last);
    }
    *behind = sample;
  }

  int width_;
  int height_;
  size_t layers_;
  std::vector<KeyedSample> samples_;  ///< those of a pixel side by side, by key
};

bool isDrawn(DrawnSides sides, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
  switch (sides) {
    case DrawnSides::kBoth:
      return true;
    case DrawnSides::kFront:
      return snappedArea(a, b, c) < 0;
    case DrawnSides::kBack:
      return snappedArea(a, b, c) > 0;
  }
  OC_CHECK(false, "every choice of sides is handled");
}

}  // namespace

std::vector<FragmentImage> rasterizeLayers(const PinholeCamera& camera, const Mesh& mesh, int layers,
                                           const std::vector<DrawnSides>& sides) {
  OC_CHECK(layers >= 1 && layers <= kMaxLayers, "the number of layers is 1 to kMaxLayers");
  OC_CHECK(sides.empty() || sides.size() == mesh.triangles.size(), "each triangle has its sides");
  const auto layerCount = static_cast<size_t>(layers);
  const ProjectedMesh projected(camera, mesh);
  const PinholeTriangles triangles(projected);
  std::vector<FragmentImage> images(layerCount, FragmentImage(camera.width(), camera.height()));
  const size_t pixels = images[0].size();
  const LayerBuffer buffer = drawOnBuffers(
      pixels, pixels * layerCount, mesh.triangles.size(),
      [&] { return LayerBuffer(camera.width(), camera.height(), layerCount); },
      [&](LayerBuffer& worker, size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const auto triangle = static_cast<uint32_t>(i);
          const DrawnSides drawn = sides.empty() ? DrawnSides::kBoth : sides[i];
          triangles.forEachPart(triangle, [&](const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
            if (isDrawn(drawn, a, b, c)) {
              worker.draw(triangle, a, b, c);
            }
          });
        }
      });
  parallelFor(pixels, 1 << 14, [&](size_t begin, size_t end) {
    for (size_t layer = 0; layer < layerCount; ++layer) {
      for (size_t pixel = begin; pixel < end; ++pixel) {
        images[layer][pixel] = buffer.fragment(pixel, layer);
      }
    }
  });
  return images;
}

}  // namespace ocelli
