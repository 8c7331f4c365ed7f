#include "oc_core/render/camera_segments.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// How far outside of an edge a pixel still belongs to a part, as GraphCamera::childAt() has it.
constexpr double kPixelRounding = 1e-7;

/// The pixels of a row whose centres lie in a convex polygon, clockwise as seen: [first, second).
std::pair<int, int> pixelsWithin(const GraphCamera::Part& part, int y, int width) {
  double least = 0;
  double most = width - 1;
  for (size_t i = 0; i < part.size(); ++i) {
    const glm::dvec2& a = part[i];
    const glm::dvec2 along = glm::normalize(part[(i + 1) % part.size()] - a);
    // cross(along, p - a) >= -rounding, at p = (x + 0.5, y + 0.5): offset - along.y x >= 0.
    const double offset = along.x * (y + 0.5 - a.y) - along.y * (0.5 - a.x) + kPixelRounding;
    if (along.y > 0) {
      most = std::min(most, std::floor(offset / along.y));
    } else if (along.y < 0) {
      least = std::max(least, std::ceil(offset / along.y));
    } else if (offset < 0) {
      return {0, 0};
    }
  }
  return least <= most ? std::pair(static_cast<int>(least), static_cast<int>(most) + 1) : std::pair(0, 0);
}

}  // namespace

PixelLeaves leavesOf(const GraphCamera& camera) {
  PixelLeaves leaves(camera.width(), camera.height(), GraphCamera::kRoot);
  const std::vector<GraphCamera::Frustum>& frusta = camera.frusta();
  parallelFor(static_cast<size_t>(camera.height()), 16, [&](size_t begin, size_t end) {
    // Parents come before their children, and of those the first has what several claim.
    for (size_t i = 1; i < frusta.size(); ++i) {
      for (size_t row = begin; row < end; ++row) {
        const int y = static_cast<int>(row);
        const auto [first, last] = pixelsWithin(frusta[i].part, y, camera.width());
        for (int x = first; x < last; ++x) {
          uint16_t& leaf = leaves(x, y);
          leaf = leaf == frusta[i].parent ? static_cast<uint16_t>(i) : leaf;
        }
      }
    }
  });
  return leaves;
}

std::vector<StraightSegment> segmentsOf(const GraphCamera& camera, const PixelLeaves& leaves) {
  const std::vector<GraphCamera::Frustum>& frusta = camera.frusta();
  std::vector<char> isLeaf(frusta.size(), 0);
  for (const uint16_t leaf : leaves) {
    isLeaf[leaf] = 1;
  }
  std::vector<StraightSegment> segments;
  for (const GraphCamera::Frustum& frustum : frusta) {
    StraightSegment segment;
    segment.order =
        frustum.parent < 0 ? 0 : static_cast<uint8_t>(segments[static_cast<size_t>(frustum.parent)].order + 1);
    segment.viewpoint = frustum.viewpoint;
    segment.pixelFromWorld = frustum.pixelFromWorld;
    segment.begin = frustum.plane;
    segment.part = frustum.part;
    segment.endsOfLeaf.assign(frusta.size(), -1);
    segments.push_back(std::move(segment));
  }
  // Each leaf that is seen ends at its limits; the frusta on the way there end where the next one begins.
  std::vector<int> endsAt(frusta.size(), -1);  // of a child: the kind of its parent's rays
  for (size_t leaf = 0; leaf < frusta.size(); ++leaf) {
    if (isLeaf[leaf] == 0) {
      continue;
    }
    segments[leaf].endsOfLeaf[leaf] = static_cast<int16_t>(segments[leaf].ends.size());
    segments[leaf].ends.push_back(frusta[leaf].limits);
    for (size_t child = leaf; frusta[child].parent >= 0; child = static_cast<size_t>(frusta[child].parent)) {
      StraightSegment& parent = segments[static_cast<size_t>(frusta[child].parent)];
      if (endsAt[child] < 0) {
        endsAt[child] = static_cast<int>(parent.ends.size());
        parent.ends.push_back({frusta[child].plane});
      }
      parent.endsOfLeaf[leaf] = static_cast<int16_t>(endsAt[child]);
    }
  }
  return segments;
}

std::vector<StraightSegment> segmentsOf(const CurvedRayCamera& camera) {
  const PinholeCamera& root = camera.root();
  const double width = camera.width();
  const double height = camera.height();
  const glm::dvec3 eye(root.eye());
  const glm::dvec3 forward(root.forward());
  std::vector<StraightSegment> segments;
  for (size_t i = 0; i <= camera.bends().size(); ++i) {
    StraightSegment segment;
    segment.order = static_cast<uint8_t>(2 * i);
    segment.pixelFromWorld = camera.pixelFromWorld(i);
    segment.part = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    segment.viewpoint = i == 0 ? eye : camera.bends()[i - 1].beyond();
    segment.begin = i == 0 ? Plane::through(eye + forward * static_cast<double>(root.view().zNear), forward)
                           : camera.bends()[i - 1].planes().to;
    segment.ends.emplace_back();
    if (i < camera.bends().size()) {
      segment.ends.back().push_back(camera.bends()[i].planes().from);
    }
    segment.endsOfLeaf = {0};
    segments.push_back(std::move(segment));
  }
  return segments;
}

}  // namespace ocelli
