#include "oc_core/constructor/maze_display.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

const glm::vec3 kGrey(0.35f);

struct Extent {
  glm::dvec2 least;
  glm::dvec2 most;
};

Extent extentOf(const GraphCamera::Part& part) {
  Extent extent{part[0], part[0]};
  for (const glm::dvec2& corner : part) {
    extent.least = {std::min(extent.least.x, corner.x), std::min(extent.least.y, corner.y)};
    extent.most = {std::max(extent.most.x, corner.x), std::max(extent.most.y, corner.y)};
  }
  return extent;
}

/// As wide as a 600th of the image.
Image<glm::vec3> withLines(const GraphCamera& camera, Image<glm::vec3> image) {
  OC_CHECK(image.width() == camera.width() && image.height() == camera.height(), "an image of this camera");
  const double half = std::max(0.5, image.width() / 1200.0);
  for (const SplitLine& line : splitLines(camera)) {
    for (int y = static_cast<int>(std::max(line.top, 0.0)); y < std::min<double>(line.bottom, image.height()); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (std::abs(x + 0.5 - line.u) <= half) {
          image(x, y) = kGrey;
        }
      }
    }
  }
  return image;
}

}  // namespace

std::vector<SplitLine> splitLines(const GraphCamera& camera) {
  std::vector<SplitLine> lines;
  const std::vector<int>& ways = camera.frusta()[GraphCamera::kRoot].children;
  for (const int left : ways) {
    const Extent one = extentOf(camera.frusta()[static_cast<size_t>(left)].part);
    for (const int right : ways) {
      const Extent other = extentOf(camera.frusta()[static_cast<size_t>(right)].part);
      if (left != right && std::abs(one.most.x - other.least.x) < 0.01) {  // of a pixel
        lines.push_back({one.most.x, std::min(one.least.y, other.least.y), std::max(one.most.y, other.most.y)});
      }
    }
  }
  std::sort(lines.begin(), lines.end(), [](const SplitLine& a, const SplitLine& b) { return a.u < b.u; });
  return lines;
}

Image<glm::vec3> layOut(const GraphCamera& forward, const Image<glm::vec3>& ahead, const GraphCamera& backward,
                        const Image<glm::vec3>& behind) {
  OC_CHECK(ahead.height() == behind.height(), "both images have one height");
  const Image<glm::vec3> left = withLines(backward, behind);
  const Image<glm::vec3> right = withLines(forward, ahead);
  Image<glm::vec3> both(left.width() + right.width(), left.height());
  for (int y = 0; y < both.height(); ++y) {
    for (int x = 0; x < both.width(); ++x) {
      both(x, y) = x < left.width() ? left(x, y) : right(x - left.width(), y);
    }
  }
  return both;
}

}  // namespace ocelli
