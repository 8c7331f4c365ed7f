#include "display_sim/quilt/color_and_depth.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/ocri/reference_image.h"

namespace ocelli {
namespace {

constexpr float kDepthSteps = 254;

}  // namespace

const std::vector<DepthSide>& depthSides() {
  static const std::vector<DepthSide> sides{{"top", 0, {0, 0}, {0, 1}},
                                            {"bottom", 1, {0, 1}, {0, 0}},
                                            {"right", 2, {1, 0}, {0, 0}},
                                            {"left", 3, {0, 0}, {1, 0}}};
  return sides;
}

const DepthSide& depthSideNamed(const std::string& name, const std::string& where) {
  std::string names;
  for (const DepthSide& side : depthSides()) {
    if (side.name == name) {
      return side;
    }
    names += (names.empty() ? "" : ", ") + std::string(side.name);
  }
  throw InputError("the depth does not stand \"" + name + "\"", where, "one of " + names);
}

ReferenceImage middleDepthImage(const QuiltViews& views, const Mesh& scene) {
  return buildDepthImage(views.middle(views.stretch(), views.display().tileWidth()), scene);
}

ColorAndDepth colorAndDepth(const ReferenceImage& middle) {
  ColorAndDepth pair{srgbFromLinear(middle.color), Image<uint8_t>(middle.width(), middle.height(), uint8_t{0})};
  for (size_t i = 0; i < middle.t.size(); ++i) {
    if (middle.holds(i)) {
      const float w = 1 / middle.t[i];
      pair.nearInverseZ = std::max(pair.nearInverseZ, w);
      pair.farInverseZ = pair.farInverseZ > 0 ? std::min(pair.farInverseZ, w) : w;
    }
  }
  const float range = std::max(pair.nearInverseZ - pair.farInverseZ, 1e-12f);
  for (size_t i = 0; i < middle.t.size(); ++i) {
    if (middle.holds(i)) {
      const float share = std::clamp((1 / middle.t[i] - pair.farInverseZ) / range, 0.0f, 1.0f);
      pair.depth[i] = static_cast<uint8_t>(1 + std::lround(share * kDepthSteps));
    } else {
      pair.color[i] = Rgb8(0);
    }
  }
  return pair;
}

Image<Rgb8> pictureOf(const ColorAndDepth& pair, const DepthSide& side) {
  const glm::ivec2 size(pair.color.width(), pair.color.height());
  const glm::ivec2 both = size * (glm::max(side.depthAt, side.colorAt) + 1);
  Image<Rgb8> picture(both.x, both.y);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::ivec2 color = glm::ivec2(x, y) + side.colorAt * size;
      const glm::ivec2 depth = glm::ivec2(x, y) + side.depthAt * size;
      picture(color.x, color.y) = pair.color(x, y);
      picture(depth.x, depth.y) = Rgb8(pair.depth(x, y));
    }
  }
  return picture;
}

ReferenceImage depthImageOf(const ColorAndDepth& pair, const QuiltViews& views) {
  const PinholeCamera middle = views.middle(views.stretch(), views.display().tileWidth());
  ReferenceImage image = blankReferenceImage("di", middle.view(), middle.width(), middle.height());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (pair.depth(x, y) > 0) {
        const float share = static_cast<float>(pair.depth(x, y) - 1) / kDepthSteps;
        const Rgb8& c = pair.color(x, y);
        image.set(x, y, 1 / (pair.farInverseZ + share * (pair.nearInverseZ - pair.farInverseZ)),
                  {linearFromSrgbByte(c.x), linearFromSrgbByte(c.y), linearFromSrgbByte(c.z)});
      }
    }
  }
  return image;
}

QuiltPicture quiltFromDepthImage(const QuiltViews& views, const ReferenceImage& middle, QuiltDepths depths) {
  const QuiltLines lines{
      sampleLines(middle, {straightRays()}), views.stretch(), 0, views.count(), middle.sampleCount(), middle.width()};
  return quiltFromLines(views, {lines}, depths);
}

}  // namespace ocelli
