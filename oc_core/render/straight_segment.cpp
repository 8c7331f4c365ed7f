#include "oc_core/render/straight_segment.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

/// How far beyond its part of the image the triangles of a segment are kept, pixels: clipping must not move what is
/// inside.
constexpr double kPartMargin = 2;
/// Vertices farther beyond the borders are clipped first, pixels.
constexpr float kGuardPixels = 4096;
/// Vertices are snapped to 1/256 pixel: cut edges of neighbouring segments come as far apart.
constexpr float kOverlapPixels = 1.0f / 64;
/// What surfaces in a plane may be off by, relative to their coordinates: they come in single precision.
constexpr double kRounding = 1e-6;

// Flags of vertices.
constexpr uint8_t kBefore = 1;  // the first plane
constexpr uint8_t kBeyond = 2;  // one of the planes where rays end
constexpr uint8_t kClip = 4;    // has no image near the part
constexpr uint8_t kHidden = 8;  // farther before the first plane than triangles are drawn
constexpr uint8_t kEnded = 16;  // as far beyond where all rays end

/// The least and the most height over a plane.
std::pair<double, double> heights(const Plane& plane, const Box& box) {
  const glm::dvec3 half = (glm::dvec3(box.upper) - glm::dvec3(box.lower)) * 0.5;
  const double middle = plane.height(glm::dvec3(box.lower) + half);
  const double reach = glm::dot(glm::abs(plane.normal), half);
  return {middle - reach, middle + reach};
}

/// The height over a plane of what a pixel sees of a triangle, and whether it is within rounding of the image.
class HeightOver {
 public:
  HeightOver(const Plane& plane, const std::array<RasterVertex, 3>& v, const std::array<glm::dvec3, 3>& points)
      : rounding_(static_cast<float>(kRounding * (1 + glm::length(points[0])))) {
    // Height times inverse weight is linear over the image.
    std::array<float, 3> slopes{};
    for (size_t i = 0; i < 3; ++i) {
      at_[i] = static_cast<float>(plane.height(points[i]));
      slopes[i] = at_[i] * v[i].inverseZ;
    }
    const glm::vec2 e1(v[1].u - v[0].u, v[1].v - v[0].v);
    const glm::vec2 e2(v[2].u - v[0].u, v[2].v - v[0].v);
    const float s1 = slopes[1] - slopes[0];
    const float s2 = slopes[2] - slopes[0];
    const float area = e1.x * e2.y - e1.y * e2.x;
    const glm::vec2 gradient = glm::vec2(s1 * e2.y - s2 * e1.y, s2 * e1.x - s1 * e2.x) / area;
    overlap_ = area != 0 ? glm::length(gradient) * kOverlapPixels : 0;
    most_ = static_cast<float>(pixelOnTriangle(v, points));
  }

  bool isBefore(const PixelWeights& weights) const { return height(weights) < -tolerance(weights); }
  bool isBeyond(const PixelWeights& weights) const { return height(weights) > tolerance(weights); }

 private:
  float height(const PixelWeights& weights) const { return weights.of(at_[0], at_[1], at_[2]); }
  float tolerance(const PixelWeights& weights) const { return std::min(overlap_ * weights.z(), most_) + rounding_; }

  /// How long a pixel is on the triangle, along its longest edge in the image: across a triangle that is seen nearly
  /// edge on, what a share of a pixel is on it means nothing.
  static double pixelOnTriangle(const std::array<RasterVertex, 3>& v, const std::array<glm::dvec3, 3>& points) {
    double longest = 0;
    double size = 0;
    for (size_t i = 0; i < 3; ++i) {
      const size_t k = (i + 1) % 3;
      const double pixels = glm::length(glm::dvec2(v[k].u - v[i].u, v[k].v - v[i].v));
      if (pixels > longest) {
        longest = pixels;
        size = glm::distance(points[i], points[k]) / pixels;
      }
    }
    return size;
  }

  std::array<float, 3> at_{};
  float overlap_ = 0;
  float most_ = 0;
  float rounding_;
};

/// The pixels whose centres may lie in a polygon.
PixelBounds rectAround(const std::vector<glm::dvec2>& part, const PixelLeaves& leaves) {
  glm::dvec2 lower = part[0];
  glm::dvec2 upper = part[0];
  for (const glm::dvec2& corner : part) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  const glm::dvec2 size(leaves.width(), leaves.height());
  const glm::ivec2 first(glm::clamp(glm::floor(lower), glm::dvec2(0), size));
  const glm::ivec2 last(glm::clamp(glm::ceil(upper), glm::dvec2(0), size));
  return {first.x, first.y, last.x, last.y};
}

}  // namespace

SegmentBounds::SegmentBounds(const StraightSegment& segment)
    : segment_(segment),
      margin_(-1e-3 * segment.begin.height(segment.viewpoint)),
      spaces_(within(segment.part, segment.pixelFromWorld, kPartMargin)) {
  spaces_.push_back(beyond(segment.begin, margin_));
}

/// Whether no ray ends before the box does.
bool SegmentBounds::endsBehind(const Box& box) const {
  return std::all_of(segment_.ends.begin(), segment_.ends.end(), [&](const std::vector<Plane>& planes) {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const Plane& plane) { return heights(plane, box).second <= 0; });
  });
}

/// Whether all rays end before the box begins.
bool SegmentBounds::endsBefore(const Box& box) const {
  return std::all_of(segment_.ends.begin(), segment_.ends.end(), [&](const std::vector<Plane>& planes) {
    return std::any_of(planes.begin(), planes.end(),
                       [&](const Plane& plane) { return heights(plane, box).first > margin_; });
  });
}

void SegmentBounds::findBlocks(const MeshBlocks& blocks, uint32_t piece, std::vector<BlockTask>& tasks) const {
  blocks.forEachWithin(spaces_, [&](uint32_t block, Placement placement) {
    const Box& box = blocks[block].box;
    if (!endsBefore(box)) {
      const bool inside = placement == Placement::kInside && heights(segment_.begin, box).first >= 0;
      tasks.push_back({piece, block, inside && endsBehind(box)});
    }
  });
}

SegmentRasterizer::SegmentRasterizer(const StraightSegment& segment, const Mesh& mesh, const MeshBlocks& blocks,
                                     const PixelLeaves& leaves)
    : segment_(segment),
      mesh_(mesh),
      blocks_(blocks),
      leaves_(leaves),
      bounds_(segment),
      rect_(rectAround(segment.part, leaves)) {
  const glm::dmat4 rows = glm::transpose(segment.pixelFromWorld);
  uRow_ = rows[0];
  vRow_ = rows[1];
  weightRow_ = rows[3];
  holdsAllPixels_ = true;
  for (int y = rect_.y0; y < rect_.y1 && holdsAllPixels_; ++y) {
    for (int x = rect_.x0; x < rect_.x1; ++x) {
      holdsAllPixels_ = holdsAllPixels_ && segment.endsOfLeaf[leaves(x, y)] >= 0;
    }
  }
}

RasterVertex SegmentRasterizer::project(const glm::dvec3& p) const {
  const auto row = [&](const glm::dvec4& r) { return r.x * p.x + r.y * p.y + r.z * p.z + r.w; };
  const double inverse = 1 / row(weightRow_);
  return {static_cast<float>(row(uRow_) * inverse), static_cast<float>(row(vRow_) * inverse),
          static_cast<float>(inverse), 0, 0};
}

/// Whether rays of some kind end before a point.
bool SegmentRasterizer::isBeyondEnds(const glm::dvec3& p) const {
  return std::any_of(segment_.ends.begin(), segment_.ends.end(), [&](const std::vector<Plane>& planes) {
    return std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) { return plane.height(p) > 0; });
  });
}

/// Whether rays of all kinds end before a point, each at one plane: then what lies between such points is not seen.
bool SegmentRasterizer::isBehindAll(const glm::dvec3& p) const {
  return std::all_of(segment_.ends.begin(), segment_.ends.end(), [&](const std::vector<Plane>& planes) {
    return planes.size() == 1 && planes[0].height(p) > bounds_.margin();
  });
}

const SegmentRasterizer::Scratch::Vertex& SegmentRasterizer::vertex(uint32_t index, bool inside,
                                                                    Scratch& scratch) const {
  Scratch::Vertex& held = scratch.cache[index % Scratch::kVertices];
  const uint64_t tag = scratch.serial << 32 | index;
  if (held.tag == tag) {
    return held;
  }
  const glm::dvec3 p(mesh_.positions[index]);
  held = {tag, project(p), 0};
  if (!inside) {
    const double height = segment_.begin.height(p);
    const double margin = bounds_.margin();
    const RasterVertex& v = held.image;
    const bool imaged = height >= -margin && v.inverseZ > 0 && v.u > -kGuardPixels && v.v > -kGuardPixels &&
                        v.u < static_cast<float>(leaves_.width()) + kGuardPixels &&
                        v.v < static_cast<float>(leaves_.height()) + kGuardPixels;
    held.flags = static_cast<uint8_t>((height < 0 ? kBefore : 0) | (isBeyondEnds(p) ? kBeyond : 0) |
                                      (imaged ? 0 : kClip) | (height < -margin ? kHidden : 0));
  }
  return held;
}

void SegmentRasterizer::draw(OrderedBuffer& buffer, const BlockTask& task, Scratch& scratch) const {
  ++scratch.serial;
  blocks_.forEachTriangle(task.block, [&](uint32_t triangle) {
    const glm::uvec3& t = mesh_.triangles[triangle];
    const Scratch::Vertex a = vertex(t.x, task.inside, scratch);
    Scratch::Vertex b = vertex(t.y, task.inside, scratch);
    Scratch::Vertex c = vertex(t.z, task.inside, scratch);
    const uint8_t flags = a.flags | b.flags | c.flags;
    if (flags != 0) {
      if ((a.flags & b.flags & c.flags & (kHidden | kEnded)) == 0) {
        drawCut(buffer, triangle, (flags & kClip) != 0, scratch);
      }
      return;
    }
    b.image.b1 = 1;
    c.image.b2 = 1;
    fill(buffer, triangle, {a.image, b.image, c.image});
  });
}

/// Of triangles that lie between the planes of the segment.
void SegmentRasterizer::fill(OrderedBuffer& buffer, uint32_t triangle,
                             const std::array<RasterVertex, 3>& vertices) const {
  scanTriangle(leaves_.width(), rect_, vertices[0], vertices[1], vertices[2],
               [&](size_t pixel, float weight, const PixelWeights& weights) {
                 if (buffer.isNearest(pixel, segment_.order, weight, triangle) &&
                     (holdsAllPixels_ || segment_.endsOfLeaf[leaves_[pixel]] >= 0)) {
                   buffer.put(pixel, segment_.order, weight, triangle, weights());
                 }
               });
}

void SegmentRasterizer::drawCut(OrderedBuffer& buffer, uint32_t triangle, bool clips, Scratch& scratch) const {
  const glm::uvec3& t = mesh_.triangles[triangle];
  const std::vector<ClipCorner>& polygon =
      scratch.clipper.clip(mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z],
                           clips ? std::span<const HalfSpace>(bounds_.spaces()) : std::span<const HalfSpace>());
  std::vector<RasterVertex>& corners = scratch.corners;
  corners.clear();
  for (const ClipCorner& corner : polygon) {
    corners.push_back(project(corner.p));
    corners.back().b1 = static_cast<float>(corner.b.x);
    corners.back().b2 = static_cast<float>(corner.b.y);
  }
  const bool within = std::none_of(polygon.begin(), polygon.end(), [&](const ClipCorner& corner) {
    return segment_.begin.height(corner.p) < 0 || isBeyondEnds(corner.p);
  });
  for (size_t i = 2; i < corners.size(); ++i) {
    const std::array<RasterVertex, 3> vertices{corners[0], corners[i - 1], corners[i]};
    if (within) {
      fill(buffer, triangle, vertices);
    } else {
      fillTested(buffer, triangle, vertices, {polygon[0].p, polygon[i - 1].p, polygon[i].p});
    }
  }
}

void SegmentRasterizer::fillTested(OrderedBuffer& buffer, uint32_t triangle,
                                   const std::array<RasterVertex, 3>& vertices,
                                   const std::array<glm::dvec3, 3>& points) const {
  const HeightOver begin(segment_.begin, vertices, points);
  int held = -1;  // the kind of rays whose ends these are
  std::vector<HeightOver> ends;
  scanTriangle(
      leaves_.width(), rect_, vertices[0], vertices[1], vertices[2],
      [&](size_t pixel, float weight, const PixelWeights& weights) {
        const int kind = segment_.endsOfLeaf[leaves_[pixel]];
        if (kind < 0 || !buffer.isNearest(pixel, segment_.order, weight, triangle) || begin.isBefore(weights)) {
          return;
        }
        if (kind != held) {
          held = kind;
          ends.clear();
          for (const Plane& plane : segment_.ends[static_cast<size_t>(kind)]) {
            ends.emplace_back(plane, vertices, points);
          }
        }
        if (std::none_of(ends.begin(), ends.end(), [&](const HeightOver& end) { return end.isBeyond(weights); })) {
          buffer.put(pixel, segment_.order, weight, triangle, weights());
        }
      });
}

}  // namespace ocelli
