#include "oc_core/constructor/walk_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "oc_core/constructor/frustum_image.h"
#include "oc_core/constructor/image_parts.h"

namespace ocelli {
namespace {

/// Rays that are cast through a part of the image, along each side of the rectangle around it; through one of so few
/// pixels one through each.
constexpr int kRaysAcross = 5;
constexpr double kFewPixels = 64;
/// The same where they are counted.
constexpr int kCountedAcross = 64;
constexpr double kCountedPixels = 4096;
/// Of a cell's height: what lies so low is its floor.
constexpr float kOnFloor = 0.1f;

bool isInPart(const GraphCamera::Part& part, const glm::dvec2& pixel) {
  for (size_t k = 0; k < part.size(); ++k) {
    const glm::dvec2 along = part[(k + 1) % part.size()] - part[k];
    const glm::dvec2 to = pixel - part[k];
    if (along.x * to.y - along.y * to.x < 0) {
      return false;
    }
  }
  return true;
}

/// Pixels within a part, and how many square pixels each stands for: all pixel centres where those are few.
struct PartSamples {
  std::vector<glm::vec2> pixels{};
  double area = 0;
};

PartSamples samplesOf(const GraphCamera::Part& part, int across = kRaysAcross, double fewPixels = kFewPixels) {
  PartSamples samples;
  if (part.empty()) {
    return samples;
  }
  glm::dvec2 least = part[0];
  glm::dvec2 most = part[0];
  for (const glm::dvec2& corner : part) {
    least = glm::min(least, corner);
    most = glm::max(most, corner);
  }
  const glm::dvec2 first = glm::floor(least) + 0.5;
  const glm::dvec2 size = glm::ceil(most) - glm::floor(least);
  const bool areFew = size.x * size.y <= fewPixels;
  const glm::ivec2 count = areFew ? glm::ivec2(size) : glm::ivec2(across);
  const glm::dvec2 step = areFew ? glm::dvec2(1) : (most - least) / static_cast<double>(across);
  const glm::dvec2 from = areFew ? first : least + step / 2.0;
  for (int y = 0; y < count.y; ++y) {
    for (int x = 0; x < count.x; ++x) {
      const glm::dvec2 pixel = from + step * glm::dvec2(x, y);
      if (isInPart(part, pixel)) {
        samples.pixels.emplace_back(pixel);
      }
    }
  }
  const auto found = static_cast<double>(samples.pixels.size());
  samples.area = areFew || samples.pixels.empty() ? 1 : areaOf(part) / found;
  return samples;
}

size_t depthOf(const GraphCamera& camera, int i) {
  size_t depth = 0;
  for (; i != GraphCamera::kRoot; i = camera.frusta()[static_cast<size_t>(i)].parent) {
    ++depth;
  }
  return depth;
}

}  // namespace

std::vector<glm::dvec3> middleOf(const WalkCell& cell) {
  const double half = static_cast<double>(std::min(cell.halfLength, cell.halfWidth)) / 2;
  const glm::dvec3 rise(0, static_cast<double>(cell.floorRise) / (2 * static_cast<double>(cell.halfLength)), 0);
  const glm::dvec3 along = (glm::dvec3(cell.axis) + rise) * half;
  const glm::dvec3 across = glm::dvec3(cell.right()) * half;
  const glm::dvec3 center(cell.center);
  return {center + along - across, center + along + across, center - along + across, center - along - across};
}

bool isOverMiddle(const WalkCell& cell, const glm::vec3& point, float height) {
  const glm::vec3 from = point - cell.center;
  const float half = std::min(cell.halfLength, cell.halfWidth) / 2;
  const float along = glm::dot(from, cell.axis);
  const float floor = cell.floorRise * along / (2 * cell.halfLength);
  return std::abs(along) <= half && std::abs(glm::dot(from, cell.right())) <= half &&
         std::abs(from.y - floor) <= height + std::abs(cell.floorRise) / 10;
}

double WalkSight::throughShare(const GraphCamera& camera, int first, int frustum, const WalkMouth& mouth) const {
  const std::array<glm::dvec3, 4> corners{spaceOf(mouth.left, mouth.floor), spaceOf(mouth.right, mouth.floor),
                                          spaceOf(mouth.right, mouth.top), spaceOf(mouth.left, mouth.top)};
  const PartSamples samples = samplesOf(frustumImage(camera, frustum, corners));
  const size_t from = depthOf(camera, first);
  const size_t last = depthOf(camera, frustum);
  const glm::vec3 ahead(spaceOf(mouth.ahead(), 0));
  const glm::vec3 at(spaceOf(mouth.middle(), 0));
  std::vector<RayPath> ways;
  for (const glm::vec2& pixel : samples.pixels) {
    const RayPath whole = camera.rayPath(pixel);
    if (whole.size() < last + 2) {
      continue;
    }
    const glm::vec3 along = whole[last + 1] - whole[last];
    const float speed = glm::dot(along, ahead);
    const float share = glm::dot(at - whole[last], ahead) / speed;
    if (!(speed > 0) || !(share > 0)) {
      continue;
    }
    RayPath way;
    for (size_t k = from; k <= last; ++k) {
      way.push_back(whole[k]);
    }
    way.push_back(whole[last] + along * std::min(share, 1.0f));
    ways.push_back(way);
  }
  if (ways.empty()) {
    return 0;
  }
  std::vector<Fragment> met(ways.size());
  scene_.intersect(ways, met);
  const auto free = std::count_if(met.begin(), met.end(), [](const Fragment& each) { return !each.covered(); });
  return static_cast<double>(free) / static_cast<double>(samples.pixels.size());
}

double WalkSight::pixelsOfMiddle(const GraphCamera& camera, int first, int frustum, const WalkCell& cell) const {
  const PartSamples samples = samplesOf(frustumImage(camera, frustum, middleOf(cell)));
  const size_t from = depthOf(camera, first);
  std::vector<RayPath> ways;
  for (const glm::vec2& pixel : samples.pixels) {
    const RayPath whole = camera.rayPath(pixel);
    RayPath way;
    for (size_t k = from; k < whole.size(); ++k) {
      way.push_back(whole[k]);
    }
    if (way.size() > 1) {
      ways.push_back(way);
    }
  }
  std::vector<Fragment> met(ways.size());
  scene_.intersect(ways, met);
  size_t seen = 0;
  for (const Fragment& each : met) {
    seen += each.covered() && isOverMiddle(cell, positionOf(each, scene_.mesh()), kOnFloor * cell.height) ? 1 : 0;
  }
  return static_cast<double>(seen) * samples.area;
}

WalkSight::Middle WalkSight::count(const GraphCamera& camera, const WalkCell& cell,
                                   const std::vector<int>& frusta) const {
  struct Sample {
    int frustum;
    double pixels;
  };
  // Each pixel once, though the image of a frustum and that of its child may both hold it.
  std::set<std::pair<float, float>> known;
  std::vector<RayPath> ways;
  std::vector<Sample> samples;
  const std::vector<glm::dvec3> floor = middleOf(cell);
  std::vector<glm::dvec3> above = floor;  // what counts as its floor
  for (glm::dvec3& corner : above) {
    corner.y += static_cast<double>(kOnFloor * cell.height);
  }
  for (const int i : frusta) {
    for (const std::vector<glm::dvec3>& corners : {floor, above}) {
      const PartSamples all = samplesOf(frustumImage(camera, i, corners), kCountedAcross, kCountedPixels);
      for (const glm::vec2& pixel : all.pixels) {
        if (known.emplace(pixel.x, pixel.y).second) {
          ways.push_back(camera.rayPath(pixel));
          samples.push_back({i, all.area});
        }
      }
      if (all.area != 1) {
        break;  // of the many that it shows, not all are sampled
      }
    }
  }
  std::vector<Fragment> met(ways.size());
  scene_.intersect(ways, met);
  Middle middle;
  std::map<int, size_t> stopped;
  for (size_t k = 0; k < ways.size(); ++k) {
    if (!met[k].covered()) {
      continue;
    }
    const glm::vec3 point = positionOf(met[k], scene_.mesh());
    if (isOverMiddle(cell, point, kOnFloor * cell.height)) {
      middle.pixels += samples[k].pixels;
      continue;
    }
    const size_t segment = ways[k].positionNear(point).segment;
    int in = samples[k].frustum;
    for (size_t depth = depthOf(camera, in); depth > segment; --depth) {
      in = camera.frusta()[static_cast<size_t>(in)].parent;
    }
    ++stopped[in];
  }
  size_t most = 0;
  for (const auto& [frustum, rays] : stopped) {
    if (rays > most) {
      most = rays;
      middle.stoppedIn = frustum;
    }
  }
  return middle;
}

}  // namespace ocelli
