#include "oc_core/depth_rays/graph_depth_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// A step reaches into the next tile by a pixel, and takes one more for the slope of what is there.
constexpr int kTileMargin = 2;

/// How near to a pixel's ray a point on it is projected by the frustum that holds it, pixels.
constexpr double kOnRay = 1e-3;

/// What a pixel shows at a point of its ray: that of the last frustum on its way that begins before the point and sees
/// it there. Rays may bend so far that points behind the plane of one frustum lie before those of its parents.
GraphDepthSamples::Sample sampleOf(const GraphCamera& camera, const glm::dvec2& pixel, const glm::dvec3& point) {
  GraphDepthSamples::Sample sample;
  for (int i = GraphCamera::kRoot; i >= 0; i = camera.childAt(i, pixel)) {
    const GraphCamera::Frustum& frustum = camera.frusta()[static_cast<size_t>(i)];
    const glm::dvec4 h = frustum.pixelFromWorld * glm::dvec4(point, 1);
    const bool begins = i == GraphCamera::kRoot || frustum.plane.height(point) >= 0;
    if (begins && h.w > 0 && glm::distance(glm::dvec2(h) / h.w, pixel) < kOnRay) {
      sample = {i, 1 / h.w};
    }
  }
  return sample;
}

/// The gentler of two slopes; level between slopes that rise and fall.
double gentler(double a, double b) {
  return a * b > 0 ? (std::abs(a) < std::abs(b) ? a : b) : 0;
}

}  // namespace

GraphDepthSamples::GraphDepthSamples(const GraphCamera& camera, const FragmentImage& fragments)
    : order_(camera.frusta().size()),
      lastBehind_(camera.frusta().size()),
      samples_(camera.width(), camera.height()),
      tiles_((camera.width() + kTile - 1) / kTile, (camera.height() + kTile - 1) / kTile) {
  OC_CHECK(fragments.width() == camera.width() && fragments.height() == camera.height(),
           "the image is not of the camera's size");
  numberFrusta(camera);
  readSamples(camera, fragments);
  sumUpTiles();
}

/// In an order in which all frusta that rays of one go on to come next to it.
void GraphDepthSamples::numberFrusta(const GraphCamera& camera) {
  const std::vector<GraphCamera::Frustum>& frusta = camera.frusta();
  std::vector<int> sizes(frusta.size(), 1);  // of the frustum and all behind it
  for (size_t i = frusta.size(); i-- > 1;) {
    sizes[static_cast<size_t>(frusta[i].parent)] += sizes[i];
  }
  for (size_t i = 0; i < frusta.size(); ++i) {
    lastBehind_[i] = order_[i] + sizes[i] - 1;
    int next = order_[i] + 1;
    for (const int child : frusta[i].children) {
      order_[static_cast<size_t>(child)] = next;
      next += sizes[static_cast<size_t>(child)];
    }
  }
}

bool GraphDepthSamples::comesBefore(int i, int k) const {
  const int order = order_[static_cast<size_t>(k)];
  return order_[static_cast<size_t>(i)] <= order && order <= lastBehind_[static_cast<size_t>(i)];
}

void GraphDepthSamples::readSamples(const GraphCamera& camera, const FragmentImage& fragments) {
  parallelFor(static_cast<size_t>(camera.height()), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < camera.width(); ++x) {
        const Fragment& fragment = fragments(x, y);
        const glm::dvec2 pixel(x + 0.5, y + 0.5);
        const auto point = fragment.covered()
                               ? camera.unprojectExactly({pixel.x, pixel.y, static_cast<double>(fragment.t)})
                               : std::nullopt;
        if (point) {
          samples_(x, y) = sampleOf(camera, pixel, *point);
        }
      }
    }
  });
}

void GraphDepthSamples::sumUpTiles() {
  for (int y = 0; y < tiles_.height(); ++y) {
    for (int x = 0; x < tiles_.width(); ++x) {
      const Sample& first = samples_(x * kTile, y * kTile);
      Tile tile{true, first.frustum, first.inverseWeight, first.inverseWeight};
      for (int v = y * kTile - kTileMargin; v < (y + 1) * kTile + kTileMargin; ++v) {
        for (int u = x * kTile - kTileMargin; u < (x + 1) * kTile + kTileMargin; ++u) {
          // At the border of the image surfaces go on beyond their samples.
          const Sample sample = samples_.contains(u, v) ? samples_(u, v) : Sample{};
          tile.uniform &= sample.frustum == tile.frustum;
          tile.nearest = std::max(tile.nearest, sample.inverseWeight);
          tile.farthest = std::min(tile.farthest, sample.inverseWeight);
        }
      }
      tiles_(x, y) = tile;
    }
  }
}

glm::ivec2 GraphDepthSamples::pixelOf(const glm::dvec2& place) const {
  return glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0),
                    glm::ivec2(samples_.width() - 1, samples_.height() - 1));
}

bool GraphDepthSamples::shows(const glm::ivec2& pixel, int frustum) const {
  return samples_.contains(pixel.x, pixel.y) && samples_(pixel.x, pixel.y).frustum == frustum;
}

GraphDepthSamples::Sample GraphDepthSamples::extended(const glm::ivec2& pixel, const glm::dvec2& place) const {
  Sample sample = (*this)[pixel];
  const double here = sample.inverseWeight;
  const auto rise = [&](const glm::ivec2& step) {
    const glm::ivec2 beside = pixel + step;
    return shows(beside, sample.frustum) ? std::optional((*this)[beside].inverseWeight - here) : std::nullopt;
  };
  const auto slope = [&](const glm::ivec2& step) {
    const std::optional<double> forth = rise(step);
    const std::optional<double> back = rise(-step);
    return forth && back ? gentler(*forth, -*back) : forth.value_or(-back.value_or(0));
  };
  if (sample.frustum >= 0) {
    const glm::dvec2 offset = place - (glm::dvec2(pixel) + 0.5);
    sample.inverseWeight += offset.x * slope({1, 0}) + offset.y * slope({0, 1});
  }
  return sample;
}

}  // namespace ocelli
