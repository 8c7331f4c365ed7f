#include "oc_core/relief/relief_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numeric>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// By which boxes are grown, of their largest coordinate: more than moving a ray into a tile rounds.
constexpr float kBoxMargin = 1e-5f;

bool isInvertible(const glm::mat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) {
        return false;
      }
    }
  }
  const float determinant = glm::determinant(glm::mat3(m));
  return std::isfinite(determinant) && std::abs(determinant) > 1e-30f;
}

Box movedBox(const Box& box, const glm::mat4& worldFromTile) {
  Box moved;
  if (box.empty()) {
    return moved;
  }
  for (const glm::vec3& corner : cornersOf(box)) {
    moved.add(glm::vec3(worldFromTile * glm::vec4(corner, 1)));
  }
  const glm::vec3 largest = glm::max(glm::abs(moved.lower), glm::abs(moved.upper));
  const float margin = kBoxMargin * std::max({largest.x, largest.y, largest.z});
  moved.lower -= margin;
  moved.upper += margin;
  return moved;
}

void add(Box& box, const Box& other) {
  if (!other.empty()) {
    box.add(other.lower);
    box.add(other.upper);
  }
}

/// Where the ray enters the box, as a share of its step; nothing where it misses it.
std::optional<float> entryOf(const StraightRay& ray, const Box& box) {
  const glm::dvec3 origin(ray.origin);
  const auto reach = static_cast<double>(ray.reach);
  const auto part = partWithin(box, origin, origin + glm::dvec3(ray.step) * reach);
  return part ? std::optional(static_cast<float>(part->first * reach)) : std::nullopt;
}

}  // namespace

ReliefScene::ReliefScene(Objects objects, std::vector<ReliefTile> tiles)
    : objects_(std::move(objects)), tiles_(std::move(tiles)) {
  std::vector<size_t> met;
  for (size_t i = 0; i < tiles_.size(); ++i) {
    OC_CHECK(tiles_[i].object < objects_.size(), "each tile names one of the objects");
    if (!isInvertible(tiles_[i].worldFromTile)) {
      throw InputError("relief tile " + std::to_string(i + 1) +
                           " is placed without an extent, or by numbers that are "
                           "not finite",
                       "the scene", "scale it by other factors than 0");
    }
    tileFromWorld_.push_back(glm::mat4(glm::inverse(glm::dmat4(tiles_[i].worldFromTile))));
    scales_.push_back(std::cbrt(std::abs(glm::determinant(glm::mat3(tiles_[i].worldFromTile)))));
    boxes_.push_back(movedBox(objects_[tiles_[i].object]->bounds(), tiles_[i].worldFromTile));
    if (!boxes_.back().empty()) {
      met.push_back(i);
    }
  }
  if (!met.empty()) {
    nodes_.emplace_back();
    build(0, std::move(met));
  }
}

void ReliefScene::build(size_t node, std::vector<size_t> tiles) {
  Box box;
  Box middles;
  for (const size_t tile : tiles) {
    add(box, boxes_[tile]);
    middles.add(boxes_[tile].center());
  }
  nodes_[node].box = box;
  if (tiles.size() == 1) {
    nodes_[node].tile = tiles[0];
    return;
  }
  const glm::vec3 size = middles.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::sort(tiles.begin(), tiles.end(), [&](size_t a, size_t b) {
    return std::pair(boxes_[a].center()[axis], a) < std::pair(boxes_[b].center()[axis], b);
  });
  const auto middle = tiles.begin() + static_cast<std::ptrdiff_t>(tiles.size() / 2);
  const size_t left = nodes_.size();
  nodes_[node].leaf = false;
  nodes_[node].left = left;
  nodes_.resize(left + 2);
  build(left, {tiles.begin(), middle});
  build(left + 1, {middle, tiles.end()});
}

StraightRay ReliefScene::rayInTile(const StraightRay& ray, size_t tile) const {
  const glm::mat4& m = tileFromWorld_[tile];
  return {glm::vec3(m * glm::vec4(ray.origin, 1)), glm::vec3(m * glm::vec4(ray.step, 0)), ray.reach};
}

template <class Visit>
void ReliefScene::visitAlong(StraightRay& ray, const Visit& visit) const {
  if (nodes_.empty()) {
    return;
  }
  // Halves: 2^32 tiles have 32 levels, and each leaves one node waiting.
  constexpr size_t kMaxWaiting = 64;
  std::array<std::pair<float, size_t>, kMaxWaiting> waiting;
  size_t count = 0;
  if (const auto entry = entryOf(ray, nodes_[0].box)) {
    waiting[count++] = {*entry, 0};
  }
  while (count > 0) {
    const auto [entry, index] = waiting[--count];
    if (entry > ray.reach) {
      continue;
    }
    const Node& node = nodes_[index];
    if (node.leaf) {
      if (visit(node.tile)) {
        return;
      }
      continue;
    }
    const auto left = entryOf(ray, nodes_[node.left].box);
    const auto right = entryOf(ray, nodes_[node.left + 1].box);
    // The nearer one is next.
    const bool leftFirst = left && (!right || *left <= *right);
    if (leftFirst && right) {
      waiting[count++] = {*right, node.left + 1};
    }
    if (left) {
      waiting[count++] = {*left, node.left};
    }
    if (!leftFirst && right) {
      waiting[count++] = {*right, node.left + 1};
    }
  }
}

std::optional<ReliefScene::Meeting> ReliefScene::meet(const StraightRay& ray, RayCost& cost) const {
  std::optional<Meeting> best;
  StraightRay shorter = ray;
  visitAlong(shorter, [&](size_t tile) {
    const StraightRay inTile = rayInTile(shorter, tile);
    const auto found = inTile.hasDirection() ? objectOf(tile).meet(inTile, cost) : std::nullopt;
    if (found && (!best || std::pair(found->share, tile) < std::pair(best->meeting.share, best->tile))) {
      best = Meeting{tile, *found};
      shorter.reach = std::nextafter(static_cast<float>(found->share), std::numeric_limits<float>::max());
    }
    return false;
  });
  return best;
}

bool ReliefScene::meetsAny(const StraightRay& ray, RayCost& cost) const {
  bool meets = false;
  StraightRay same = ray;
  visitAlong(same, [&](size_t tile) {
    const StraightRay inTile = rayInTile(ray, tile);
    meets = inTile.hasDirection() && objectOf(tile).meet(inTile, cost).has_value();
    return meets;
  });
  return meets;
}

std::optional<ReliefScene::Meeting> ReliefScene::meetSlowly(const StraightRay& ray) const {
  std::optional<Meeting> best;
  for (size_t tile = 0; tile < tiles_.size(); ++tile) {
    const StraightRay inTile = rayInTile(ray, tile);
    const auto found = inTile.hasDirection() ? objectOf(tile).meetSlowly(inTile) : std::nullopt;
    if (found && (!best || found->share < best->meeting.share)) {
      best = Meeting{tile, *found};
    }
  }
  return best;
}

ReliefScene::Surface ReliefScene::surfaceAt(const Meeting& meeting, const glm::vec3& towards) const {
  const ReliefSurface surface = objectOf(meeting.tile).surfaceAt(meeting.meeting);
  const glm::vec3 normal = glm::transpose(glm::mat3(tileFromWorld_[meeting.tile])) * surface.normal;
  const float length = glm::length(normal);
  const glm::vec3 unit = length > 0 ? normal / length : -glm::normalize(towards);
  return {surface.color * tiles_[meeting.tile].tint, glm::dot(unit, towards) > 0 ? -unit : unit};
}

Box ReliefScene::bounds() const {
  return nodes_.empty() ? Box{} : nodes_[0].box;
}

}  // namespace ocelli
