#include "oc_core/render/camera_stretches.h"

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

std::vector<Stretch> stretchesOf(const GraphCamera& camera, const PixelLeaves& leaves) {
  const std::vector<GraphCamera::Frustum>& frusta = camera.frusta();
  std::vector<char> isLeaf(frusta.size(), 0);
  for (const uint16_t leaf : leaves) {
    isLeaf[leaf] = 1;
  }
  std::vector<Stretch> stretches;
  for (const GraphCamera::Frustum& frustum : frusta) {
    Stretch stretch;
    stretch.order =
        frustum.parent < 0 ? 0 : static_cast<uint8_t>(stretches[static_cast<size_t>(frustum.parent)].order + 1);
    stretch.viewpoint = frustum.viewpoint;
    stretch.pixelFromWorld = frustum.pixelFromWorld;
    stretch.begin = frustum.plane;
    stretch.part = frustum.part;
    stretch.endsOfLeaf.assign(frusta.size(), -1);
    stretches.push_back(std::move(stretch));
  }
  // Each leaf that is seen ends at its limits; the frusta on the way there end where the next one begins.
  std::vector<int> endsAt(frusta.size(), -1);  // of a child: the kind of its parent's rays
  for (size_t leaf = 0; leaf < frusta.size(); ++leaf) {
    if (isLeaf[leaf] == 0) {
      continue;
    }
    stretches[leaf].endsOfLeaf[leaf] = static_cast<int16_t>(stretches[leaf].ends.size());
    stretches[leaf].ends.push_back(frusta[leaf].limits);
    for (size_t child = leaf; frusta[child].parent >= 0; child = static_cast<size_t>(frusta[child].parent)) {
      Stretch& parent = stretches[static_cast<size_t>(frusta[child].parent)];
      if (endsAt[child] < 0) {
        endsAt[child] = static_cast<int>(parent.ends.size());
        parent.ends.push_back({frusta[child].plane});
      }
      parent.endsOfLeaf[leaf] = static_cast<int16_t>(endsAt[child]);
    }
  }
  return stretches;
}

std::vector<Stretch> stretchesOf(const CurvedRayCamera& camera) {
  const PinholeCamera& root = camera.root();
  const double width = camera.width();
  const double height = camera.height();
  const glm::dvec3 eye(root.eye());
  const glm::dvec3 forward(root.forward());
  std::vector<Stretch> stretches;
  for (size_t i = 0; i <= camera.turns().size(); ++i) {
    Stretch stretch;
    stretch.order = static_cast<uint8_t>(2 * i);
    stretch.pixelFromWorld = camera.pixelFromWorld(i);
    stretch.part = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    stretch.viewpoint = i == 0 ? eye : camera.turns()[i - 1].beyond();
    stretch.begin = i == 0 ? Plane::through(eye + forward * static_cast<double>(root.view().zNear), forward)
                           : camera.turns()[i - 1].planes().to;
    stretch.ends.emplace_back();
    if (i < camera.turns().size()) {
      stretch.ends.back().push_back(camera.turns()[i].planes().from);
    }
    stretch.endsOfLeaf = {0};
    stretches.push_back(std::move(stretch));
  }
  return stretches;
}

}  // namespace ocelli
