#include "bench/pruned_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oc_core/base/parallel.h"
#include "oc_core/image/color.h"
#include "oc_core/ocri/set_difference.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

constexpr int kBlockPixels = 16;

/// Of a view, where nothing is pruned yet.
Image<uint8_t> heldPixels(const ReferenceImage& image) {
  Image<uint8_t> mask(image.width(), image.height(), 0);
  for (size_t i = 0; i < mask.size(); ++i) {
    mask[i] = image.holds(i) ? 1 : 0;
  }
  return mask;
}

float smallestLumaStep(const ReferenceImage& image, int x, int y, float luma) {
  float least = std::numeric_limits<float>::max();
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      if (image.t.contains(u, v) && image.holds(u, v)) {
        least = std::min(least, std::abs(linearLuma(image.color(u, v)) - luma));
      }
    }
  }
  return least;
}

/// Takes the pixels off the mask that `earlier`, drawn from the image's view, has too.
void prune(Image<uint8_t>& mask, const ReferenceImage& image, const Mesh& earlier, const PruningRule& rule) {
  const FragmentImage drawn = rasterize(image.reference(), earlier);
  parallelFor(static_cast<size_t>(image.height()), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < image.width(); ++x) {
        const Fragment& fragment = drawn(x, y);
        if (mask(x, y) != 0 && fragment.covered() &&
            std::abs(fragment.t - image.t(x, y)) <= rule.depthTolerance * image.t(x, y) &&
            smallestLumaStep(image, x, y, linearLuma(colorOf(fragment, earlier))) <= rule.lumaTolerance) {
          mask(x, y) = 0;
        }
      }
    }
  });
}

/// One pixel off every border of what has that value, to all 8 sides; what lies beyond the image's borders has it too.
void shrink(Image<uint8_t>& mask, uint8_t value) {
  const Image<uint8_t> before = mask;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      for (int v = y - 1; v <= y + 1; ++v) {
        for (int u = x - 1; u <= x + 1; ++u) {
          if (before.contains(u, v) && before(u, v) != value) {
            mask(x, y) = before(u, v);
          }
        }
      }
    }
  }
}

/// Of the connected parts (8 neighbours) of a mask.
size_t pixelsOfRectangles(Image<uint8_t> mask) {
  size_t pixels = 0;
  std::vector<glm::ivec2> open;
  for (int row = 0; row < mask.height(); ++row) {
    for (int column = 0; column < mask.width(); ++column) {
      if (mask(column, row) == 0) {
        continue;
      }
      glm::ivec2 low(column, row);
      glm::ivec2 high = low;
      mask(column, row) = 0;
      open.assign(1, low);
      while (!open.empty()) {
        const glm::ivec2 at = open.back();
        open.pop_back();
        low = glm::min(low, at);
        high = glm::max(high, at);
        for (int v = at.y - 1; v <= at.y + 1; ++v) {
          for (int u = at.x - 1; u <= at.x + 1; ++u) {
            if (mask.contains(u, v) && mask(u, v) != 0) {
              mask(u, v) = 0;
              open.emplace_back(u, v);
            }
          }
        }
      }
      const glm::ivec2 blocks = high / kBlockPixels - low / kBlockPixels + 1;
      pixels += static_cast<size_t>(blocks.x) * static_cast<size_t>(blocks.y) * kBlockPixels * kBlockPixels;
    }
  }
  return pixels;
}

}  // namespace

float linearLuma(const glm::vec3& linear) {
  return 0.2126f * srgbFromLinear(linear.x) + 0.7152f * srgbFromLinear(linear.y) + 0.0722f * srgbFromLinear(linear.z);
}

PrunedViews pruneViews(const std::vector<DepthView>& views, const PruningRule& rule) {
  PrunedViews pruned;
  for (size_t i = 0; i < views.size(); ++i) {
    ReferenceImage image = views[i].image;
    image.seenFromAside = true;
    Image<uint8_t> mask = heldPixels(image);
    if (i > 0) {
      for (const ReferenceImage& earlier : pruned.images) {
        prune(mask, image, unionMesh({earlier}), rule);
      }
      for (int step = 0; step < rule.erode; ++step) {
        shrink(mask, 1);
      }
      for (int step = 0; step < rule.dilate; ++step) {
        shrink(mask, 0);
      }
    }
    pruned.packedPixels += pixelsOfRectangles(mask);
    keepMarked(image, mask);
    pruned.samples += image.sampleCount();
    pruned.images.push_back(std::move(image));
  }
  return pruned;
}

}  // namespace ocelli
