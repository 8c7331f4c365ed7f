#include "oc_core/render/turn_drawer.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

/// Edges up to so many pixels are straight; longer ones than the second are split, pixels.
constexpr float kShortPixels = 3;
constexpr float kLongPixels = 96;
/// Beyond this, coordinates of images are as good as none, pixels.
constexpr double kMostPixels = 1e6;
/// Weights are at least this share of those in the middle plane.
constexpr double kLeastWeight = 0.05;
constexpr int kDeepest = 24;  // only guards against numbers gone wrong

double weightOf(const glm::dmat4& pixelFromWorld, const glm::dvec3& p) {
  return (pixelFromWorld * glm::dvec4(p, 1)).w;
}

}  // namespace

TurnDrawer::TurnDrawer(const CurvedRayCamera& camera, size_t turn, uint8_t order, const Mesh& mesh,
                       const MeshBlocks& blocks)
    : transition_(camera.turns()[turn]),
      mesh_(mesh),
      blocks_(blocks),
      bounds_(camera, turn),
      turn_(static_cast<uint32_t>(turn)),
      order_(order),
      width_(camera.width()),
      height_(camera.height()) {}

/// Where a point of the turn is seen: its ray meets the middle plane at S, which is projected by a matrix.
TurnDrawer::Vertex TurnDrawer::vertex(const glm::dvec3& p, const glm::dvec2& b) const {
  Vertex v{p, b, {}, 0, 0, false};
  const double first = std::max(transition_.planes().from.height(p), 0.0);
  const double last = std::max(-transition_.planes().to.height(p), 0.0);
  v.behindFirst = static_cast<float>(first);
  v.beforeLast = static_cast<float>(last);
  const std::optional<RayTransition::Place> place = transition_.find(p);
  if (!place) {
    return v;
  }
  const glm::dvec4 h = bounds_.before() * glm::dvec4(place->arc.s, 1);
  const glm::dvec2 pixel(h.x / h.w, h.y / h.w);
  if (!(h.w > 0) || !(std::abs(pixel.x) < kMostPixels) || !(std::abs(pixel.y) < kMostPixels)) {
    return v;
  }
  // Any weight would do; one between those before and after the turn needs the fewest pieces.
  const double share = first + last > 0 ? first / (first + last) : 0;
  const double least = kLeastWeight * h.w;
  const double weight = (1 - share) * std::max(weightOf(bounds_.before(), p), least) +
                        share * std::max(weightOf(bounds_.after(), p), least);
  v.image = {static_cast<float>(pixel.x), static_cast<float>(pixel.y), static_cast<float>(1 / weight),
             static_cast<float>(b.x), static_cast<float>(b.y)};
  v.imaged = true;
  return v;
}

const TurnDrawer::Vertex& TurnDrawer::meshVertex(uint32_t index, Scratch& scratch) const {
  Scratch::Entry& held = scratch.cache[index % Scratch::kVertices];
  const uint64_t tag = static_cast<uint64_t>(turn_) << 32 | index;
  if (held.tag != tag) {
    held = {tag, vertex(glm::dvec3(mesh_.positions[index]), {0, 0})};
  }
  return held.vertex;
}

void TurnDrawer::draw(OrderedBuffer& buffer, const BlockTask& task, Scratch& scratch) const {
  const Plane& from = transition_.planes().from;
  const Plane& to = transition_.planes().to;
  blocks_.forEachTriangle(task.block, [&](uint32_t triangle) {
    const Sink sink{buffer, triangle};
    const glm::uvec3& t = mesh_.triangles[triangle];
    int before = 0;
    int beyond = 0;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 p(mesh_.positions[t[k]]);
      before += from.height(p) < 0;
      beyond += to.height(p) > 0;
    }
    if (before == 3 || beyond == 3) {
      return;
    }
    if (before + beyond > 0) {
      drawClipped(sink, scratch);
      return;
    }
    const Vertex a = meshVertex(t.x, scratch);
    Vertex b = meshVertex(t.y, scratch);
    Vertex c = meshVertex(t.z, scratch);
    b.b.x = b.image.b1 = 1;
    c.b.y = c.image.b2 = 1;
    refine(sink, a, b, c, 0);
  });
}

void TurnDrawer::drawClipped(const Sink& sink, Scratch& scratch) const {
  const glm::uvec3& t = mesh_.triangles[sink.triangle];
  std::vector<Vertex>& corners = scratch.corners;
  corners.clear();
  for (const ClipCorner& corner :
       scratch.clipper.clip(mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z], bounds_.slab())) {
    corners.push_back(vertex(corner.p, corner.b));
  }
  for (size_t i = 2; i < corners.size(); ++i) {
    refine(sink, corners[0], corners[i - 1], corners[i], 0);
  }
}

/// An edge bulges by less than half of its length: so does a piece. Pieces with a corner that has no image are looked
/// at in the world.
bool TurnDrawer::missesImage(const Vertex& a, const Vertex& b, const Vertex& c) const {
  if (!a.imaged || !b.imaged || !c.imaged) {
    return std::any_of(bounds_.sides().begin(), bounds_.sides().end(), [&](const HalfSpace& space) {
      const auto isOutside = [&](const Vertex& v) { return glm::dot(space, glm::dvec4(v.p, 1)) < 0; };
      return isOutside(a) && isOutside(b) && isOutside(c);
    });
  }
  const auto [left, right] = std::minmax({a.image.u, b.image.u, c.image.u});
  const auto [top, bottom] = std::minmax({a.image.v, b.image.v, c.image.v});
  const float room = 1 + ((right - left) + (bottom - top)) / 2;
  return right + room < 0 || bottom + room < 0 || left - room > static_cast<float>(width_) ||
         top - room > static_cast<float>(height_);
}

/// The middle of an edge that is to be split.
std::optional<TurnDrawer::Vertex> TurnDrawer::splitOf(const Vertex& a, const Vertex& b) const {
  const bool imaged = a.imaged && b.imaged;
  const glm::vec2 between(a.image.u - b.image.u, a.image.v - b.image.v);
  if (imaged ? glm::dot(between, between) <= kShortPixels * kShortPixels
             : glm::distance(a.p, b.p) <= bounds_.shortestEdge()) {
    return std::nullopt;
  }
  const Vertex middle = vertex((a.p + b.p) * 0.5, (a.b + b.b) * 0.5);
  if (!imaged || !middle.imaged || glm::dot(between, between) > kLongPixels * kLongPixels) {
    return middle;
  }
  // In perspective the middle comes nearer to the end that is farther away.
  const float share = a.image.inverseZ / (a.image.inverseZ + b.image.inverseZ);
  const glm::vec2 straight = glm::vec2(a.image.u, a.image.v) * (1 - share) + glm::vec2(b.image.u, b.image.v) * share;
  const glm::vec2 error = glm::vec2(middle.image.u, middle.image.v) - straight;
  const bool bends = glm::dot(error, error) > static_cast<float>(kErrorPixels * kErrorPixels);
  return bends ? std::optional(middle) : std::nullopt;
}

void TurnDrawer::refineOne(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& ab,
                           int depth) const {
  refine(sink, a, ab, c, depth + 1);
  refine(sink, ab, b, c, depth + 1);
}

void TurnDrawer::refineTwo(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& ab,
                           const Vertex& bc, int depth) const {
  refine(sink, ab, b, bc, depth + 1);
  refine(sink, a, ab, bc, depth + 1);
  refine(sink, a, bc, c, depth + 1);
}

void TurnDrawer::refine(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c, int depth) const {
  if (missesImage(a, b, c)) {
    return;
  }
  if (depth >= kDeepest) {
    fill(sink, a, b, c);
    return;
  }
  const std::optional<Vertex> ab = splitOf(a, b);
  const std::optional<Vertex> bc = splitOf(b, c);
  const std::optional<Vertex> ca = splitOf(c, a);
  if (ab && bc && ca) {
    refine(sink, a, *ab, *ca, depth + 1);
    refine(sink, *ab, b, *bc, depth + 1);
    refine(sink, *ca, *bc, c, depth + 1);
    refine(sink, *ab, *bc, *ca, depth + 1);
  } else if (ab && bc) {
    refineTwo(sink, a, b, c, *ab, *bc, depth);
  } else if (bc && ca) {
    refineTwo(sink, b, c, a, *bc, *ca, depth);
  } else if (ca && ab) {
    refineTwo(sink, c, a, b, *ca, *ab, depth);
  } else if (ab) {
    refineOne(sink, a, b, c, *ab, depth);
  } else if (bc) {
    refineOne(sink, b, c, a, *bc, depth);
  } else if (ca) {
    refineOne(sink, c, a, b, *ca, depth);
  } else {
    fill(sink, a, b, c);
  }
}

void TurnDrawer::fill(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c) const {
  if (!a.imaged || !b.imaged || !c.imaged) {
    return;
  }
  scanTriangle(width_, height_, a.image, b.image, c.image,
               [&](size_t pixel, float /*weight*/, const PixelWeights& weights) {
                 const float first = weights.of(a.behindFirst, b.behindFirst, c.behindFirst);
                 const float last = weights.of(a.beforeLast, b.beforeLast, c.beforeLast);
                 const float share = first > 0 ? first / (first + std::max(last, 0.0f)) : 0;
                 sink.buffer.offer(pixel, order_, std::max(share, 1e-30f), sink.triangle, weights);
               });
}

}  // namespace ocelli
