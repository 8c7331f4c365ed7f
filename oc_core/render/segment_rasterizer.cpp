#include "oc_core/render/segment_rasterizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace ocelli {
namespace {

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
constexpr uint8_t kLeft = 8;    // outside of the region, beyond each of its borders
constexpr uint8_t kRight = 16;
constexpr uint8_t kAbove = 32;
constexpr uint8_t kBelow = 64;
constexpr uint8_t kHidden = 128;  // farther before the first plane than triangles are drawn
/// Nothing is seen of a triangle all of whose corners have one of these.
constexpr uint8_t kUnseen = kLeft | kRight | kAbove | kBelow | kHidden;
/// Depths of pixels are at least this part of the nearest corner's: rounding takes a thousandth of the rest.
constexpr float kNearer = 0.9999f;
/// Triangles that cover a few pixels at most.
constexpr float kSmallPixels = 2;
/// As far outside of a region, in pixels, snapping and cut edges do not matter.
constexpr double kRegionMargin = 2;

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

  /// More than what any pixel tolerates of a triangle, and what rounding takes from heights in between.
  static float mostTolerance(const std::array<RasterVertex, 3>& v, const std::array<glm::dvec3, 3>& points) {
    const double rounding = kRounding * (1 + glm::length(points[0]));
    return static_cast<float>(1.001 * (pixelOnTriangle(v, points) + rounding));
  }
  /// Whether all pixels that see the triangle are before the plane, or beyond it.
  bool isBeforeAll() const { return std::max({at_[0], at_[1], at_[2]}) < -mostTolerance(); }
  bool isBeyondAll() const { return std::min({at_[0], at_[1], at_[2]}) > mostTolerance(); }
  bool isBefore(const PixelWeights& weights) const { return height(weights) < -tolerance(weights); }
  bool isBeyond(const PixelWeights& weights) const { return height(weights) > tolerance(weights); }

 private:
  float height(const PixelWeights& weights) const { return weights.of(at_[0], at_[1], at_[2]); }
  /// More than what any pixel tolerates, and what rounding takes from heights in between.
  float mostTolerance() const {
    return std::isnan(overlap_) ? std::numeric_limits<float>::infinity() : 1.001f * (most_ + rounding_);
  }
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

RasterVertex rasterVertex(const glm::dvec3& image) {
  const double inverse = 1 / image.z;
  return {static_cast<float>(image.x * inverse), static_cast<float>(image.y * inverse), static_cast<float>(inverse), 0,
          0};
}

/// The longer side of the box around a triangle, pixels.
float extentOf(const std::array<RasterVertex, 3>& v) {
  const auto [leftmost, rightmost] = std::minmax({v[0].u, v[1].u, v[2].u});
  const auto [highest, lowest] = std::minmax({v[0].v, v[1].v, v[2].v});
  return std::max(rightmost - leftmost, lowest - highest);
}

struct SegmentScratch final : PieceRasterizer::Scratch {
  struct Vertex {
    uint64_t tag = ~uint64_t{0};
    RasterVertex image;
    uint8_t flags = 0;
    uint64_t beyondKinds = 0;  ///< kinds of rays (RegionBuffer::kindBit()) that end before it
    float beyond = 0;          ///< least height over where rays of some kind end
  };
  static constexpr size_t kVertices = 64;

  // Of a region.
  uint64_t kinds = 0;
  std::vector<std::pair<size_t, const std::vector<Plane>*>> ends;  ///< the kinds, and where each ends
  bool endsAreSingle = false;                                      ///< each kind ends at one plane
  glm::dvec2 lower{0};                                             ///< its borders, with a margin
  glm::dvec2 upper{0};

  uint64_t serial = 0;
  BlockVertices points;
  SegmentImages images;
  std::array<Vertex, kVertices> cache;
  Clipper clipper;
  std::vector<RasterVertex> corners;
  std::vector<HeightOver> heights;
};

/// The kinds of rays that end before a point.
uint64_t kindsEndingBefore(const SegmentScratch& scratch, const glm::dvec3& p) {
  uint64_t kinds = 0;
  for (const auto& [kind, planes] : scratch.ends) {
    const bool ends =
        std::any_of(planes->begin(), planes->end(), [&](const Plane& plane) { return plane.height(p) > 0; });
    kinds |= ends ? RegionBuffer::kindBit(kind) : 0;
  }
  return kinds;
}

/// The pixels of `rect` around a triangle.
PixelBounds pixelsAround(const std::array<RasterVertex, 3>& v, const PixelBounds& rect) {
  const auto [leftmost, rightmost] = std::minmax({v[0].u, v[1].u, v[2].u});
  const auto [highest, lowest] = std::minmax({v[0].v, v[1].v, v[2].v});
  const auto within = [](float at, int least, int most) {
    return static_cast<int>(std::clamp(at, static_cast<float>(least), static_cast<float>(most)));
  };
  return {within(std::floor(leftmost) - 1, rect.x0, rect.x1), within(std::floor(highest) - 1, rect.y0, rect.y1),
          within(std::ceil(rightmost) + 1, rect.x0, rect.x1), within(std::ceil(lowest) + 1, rect.y0, rect.y1)};
}

}  // namespace

/// A block as it is drawn to a region.
class SegmentRasterizer::Drawing {
 public:
  Drawing(const SegmentRasterizer& of, RegionBuffer& region, const BlockTask& task, SegmentScratch& scratch)
      : of_(of),
        segment_(of.segment_),
        region_(region),
        rect_{std::max(task.rect.x0, region.rect().x0), std::max(task.rect.y0, region.rect().y0),
              std::min(task.rect.x1, region.rect().x1), std::min(task.rect.y1, region.rect().y1)},
        inside_(task.within && (scratch.kinds & ~task.clear) == 0),
        scratch_(scratch) {}

  void draw(const BlockVertices::Triangle& triangle);

 private:
  void drawAcross(uint32_t triangle);
  using Vertex = SegmentScratch::Vertex;

  const Vertex& vertex(uint32_t index);
  void place(const glm::dvec3& p, const glm::dvec3& image, Vertex& vertex) const;
  bool endsBefore(const Vertex& a, const Vertex& b, const Vertex& c, const std::array<glm::dvec3, 3>& points) const;
  void drawClipped(uint32_t triangle);
  void fill(uint32_t triangle, const std::array<RasterVertex, 3>& vertices);
  void fillTested(uint32_t triangle, const std::array<RasterVertex, 3>& vertices,
                  const std::array<glm::dvec3, 3>& points, uint64_t kinds);

  const SegmentRasterizer& of_;
  const StraightSegment& segment_;
  RegionBuffer& region_;
  PixelBounds rect_;
  bool inside_;  ///< nothing is to be clipped or tested
  SegmentScratch& scratch_;
};

SegmentRasterizer::SegmentRasterizer(const StraightSegment& segment, const Mesh& mesh, const MeshBlocks& blocks,
                                     int width, int height)
    : segment_(segment),
      mesh_(mesh),
      blocks_(blocks),
      width_(width),
      height_(height),
      bounds_(segment),
      rect_(bounds_.rectIn(width, height)) {
  const glm::dmat4 rows = glm::transpose(segment.pixelFromWorld);
  const auto upper = [](int pixels) {
    return std::min(static_cast<float>(pixels) + kGuardPixels, CentreCell::kMaxPixels);
  };
  setup_ = {rows[0],           rows[1],       rows[3],      segment.begin.normal, segment.begin.distance,
            -bounds_.margin(), -kGuardPixels, upper(width), upper(height)};
}

void SegmentRasterizer::findBlocks(MeshBlocks::Runs runs, uint32_t piece, const RegionGrid& /*grid*/,
                                   std::vector<BlockTask>& tasks) const {
  bounds_.findBlocks(blocks_, runs, piece, rect_, tasks);
}

std::unique_ptr<PieceRasterizer::Scratch> SegmentRasterizer::makeScratch() const {
  return std::make_unique<SegmentScratch>();
}

void SegmentRasterizer::begin(const RegionBuffer& region, uint64_t kinds, Scratch& scratch) const {
  auto& own = static_cast<SegmentScratch&>(scratch);
  own.kinds = kinds;
  own.ends.clear();
  own.endsAreSingle = true;
  for (size_t kind = 0; kind < segment_.ends.size(); ++kind) {
    if ((kinds & RegionBuffer::kindBit(kind)) != 0) {
      own.ends.emplace_back(kind, &segment_.ends[kind]);
      own.endsAreSingle = own.endsAreSingle && segment_.ends[kind].size() == 1;
    }
  }
  own.lower = glm::dvec2(region.rect().x0, region.rect().y0) - kRegionMargin;
  own.upper = glm::dvec2(region.rect().x1, region.rect().y1) + kRegionMargin;
}

void SegmentRasterizer::draw(RegionBuffer& region, const BlockTask& task, Scratch& scratch) const {
  auto& own = static_cast<SegmentScratch&>(scratch);
  ++own.serial;
  Drawing drawing(*this, region, task, own);
  own.points.collect(mesh_, blocks_, task.block);
  projectBlock(setup_, own.points, own.images);
  for (const BlockVertices::Triangle& triangle : own.points.triangles()) {
    drawing.draw(triangle);
  }
  region.touch(task.rect);
}

glm::dvec3 SegmentRasterizer::image(const glm::dvec3& p) const {
  const auto row = [&](const glm::dvec4& r) { return r.x * p.x + r.y * p.y + r.z * p.z + r.w; };
  return {row(setup_.uRow), row(setup_.vRow), row(setup_.weightRow)};
}

const SegmentScratch::Vertex& SegmentRasterizer::Drawing::vertex(uint32_t index) {
  Vertex& held = scratch_.cache[index % SegmentScratch::kVertices];
  const uint64_t tag = scratch_.serial << 32 | index;
  if (held.tag != tag) {
    const glm::dvec3 p(of_.mesh_.positions[index]);
    const glm::dvec3 image = of_.image(p);
    held = {tag, rasterVertex(image), 0, 0, 0};
    place(p, image, held);
  }
  return held;
}

/// Finds out where a vertex lies.
void SegmentRasterizer::Drawing::place(const glm::dvec3& p, const glm::dvec3& image, Vertex& vertex) const {
  const double height = segment_.begin.height(p);
  const double margin = of_.bounds_.margin();
  const RasterVertex& v = vertex.image;
  const bool imaged = height >= -margin && v.inverseZ > 0 && v.u > -kGuardPixels && v.v > -kGuardPixels &&
                      v.u < static_cast<float>(of_.width_) + kGuardPixels &&
                      v.v < static_cast<float>(of_.height_) + kGuardPixels;
  unsigned flags = (height < 0 ? kBefore : 0u) | (imaged ? 0u : kClip) | (height < -margin ? kHidden : 0u);
  // The borders are planes through the viewpoint: that holds behind it too.
  flags |= (image.x < scratch_.lower.x * image.z ? kLeft : 0u) | (image.x > scratch_.upper.x * image.z ? kRight : 0u) |
           (image.y < scratch_.lower.y * image.z ? kAbove : 0u) | (image.y > scratch_.upper.y * image.z ? kBelow : 0u);
  if (scratch_.endsAreSingle) {
    double beyond = std::numeric_limits<double>::infinity();
    for (const auto& [kind, planes] : scratch_.ends) {
      const double over = planes->front().height(p);
      beyond = std::min(beyond, over);
      vertex.beyondKinds |= over > 0 ? RegionBuffer::kindBit(kind) : 0;
    }
    vertex.beyond = static_cast<float>(beyond);
  } else {
    vertex.beyondKinds = kindsEndingBefore(scratch_, p);
  }
  flags |= vertex.beyondKinds != 0 ? kBeyond : 0u;
  vertex.flags = static_cast<uint8_t>(flags);
}

void SegmentRasterizer::Drawing::draw(const BlockVertices::Triangle& triangle) {
  const SegmentImages& images = scratch_.images;
  const auto [a, b, c] = triangle.corners;
  if (CentreCell::missCentres(images.cells[a], images.cells[b], images.cells[c])) {
    return;
  }
  const auto corner = [&](size_t i, float b1, float b2) {
    return RasterVertex{images.u[i], images.v[i], images.inverseZ[i], b1, b2};
  };
  const std::array<RasterVertex, 3> vertices{corner(a, 0, 0), corner(b, 1, 0), corner(c, 0, 1)};
  if (images.cells[a].isKnown() && images.cells[b].isKnown() && images.cells[c].isKnown()) {
    const float nearest = kNearer / std::max({vertices[0].inverseZ, vertices[1].inverseZ, vertices[2].inverseZ});
    if (region_.missesAll(rect_, vertices[0], vertices[1], vertices[2], nearest)) {
      return;
    }
  }
  if (inside_) {
    fill(triangle.index, vertices);
  } else {
    drawAcross(triangle.index);
  }
}

/// A triangle of a block that is not wholly within.
void SegmentRasterizer::Drawing::drawAcross(uint32_t triangle) {
  const glm::uvec3& t = of_.mesh_.triangles[triangle];
  const Vertex a = vertex(t.x);
  Vertex b = vertex(t.y);
  Vertex c = vertex(t.z);
  if ((a.flags & b.flags & c.flags & kUnseen) != 0) {
    return;
  }
  const uint8_t flags = a.flags | b.flags | c.flags;
  if ((flags & kClip) != 0) {
    drawClipped(triangle);
    return;
  }
  b.image.b1 = 1;
  c.image.b2 = 1;
  const std::array<RasterVertex, 3> vertices{a.image, b.image, c.image};
  uint64_t kinds = scratch_.kinds;
  if ((flags & kBeyond) != 0) {
    kinds &= region_.kindsIn(pixelsAround(vertices, rect_), segment_.endsOfLeaf);
    if (kinds == 0) {
      return;
    }
  }
  if ((flags & kBefore) == 0 && (kinds & (a.beyondKinds | b.beyondKinds | c.beyondKinds)) == 0) {
    fill(triangle, vertices);
    return;
  }
  const std::vector<glm::vec3>& positions = of_.mesh_.positions;
  const std::array<glm::dvec3, 3> points{glm::dvec3(positions[t.x]), glm::dvec3(positions[t.y]),
                                         glm::dvec3(positions[t.z])};
  if (!endsBefore(a, b, c, points)) {
    fillTested(triangle, vertices, points, kinds);
  }
}

/// Whether all rays end before a triangle, as HeightOver::isBeyondAll() would have it: a quick look that finds most.
bool SegmentRasterizer::Drawing::endsBefore(const Vertex& a, const Vertex& b, const Vertex& c,
                                            const std::array<glm::dvec3, 3>& points) const {
  const float beyond = std::min({a.beyond, b.beyond, c.beyond});
  if (!scratch_.endsAreSingle || !(beyond > 0)) {
    return false;
  }
  return HeightOver::mostTolerance({a.image, b.image, c.image}, points) < beyond;
}

/// Of triangles that lie between the planes of the segment.
void SegmentRasterizer::Drawing::fill(uint32_t triangle, const std::array<RasterVertex, 3>& vertices) {
  region_.fill(rect_, triangle, vertices[0], vertices[1], vertices[2]);
}

void SegmentRasterizer::Drawing::drawClipped(uint32_t triangle) {
  const glm::uvec3& t = of_.mesh_.triangles[triangle];
  const std::vector<glm::vec3>& positions = of_.mesh_.positions;
  const std::vector<ClipCorner>& polygon =
      scratch_.clipper.clip(positions[t.x], positions[t.y], positions[t.z], of_.bounds_.spaces());
  std::vector<RasterVertex>& corners = scratch_.corners;
  corners.clear();
  for (const ClipCorner& corner : polygon) {
    corners.push_back(rasterVertex(of_.image(corner.p)));
    corners.back().b1 = static_cast<float>(corner.b.x);
    corners.back().b2 = static_cast<float>(corner.b.y);
  }
  const bool within = std::none_of(polygon.begin(), polygon.end(), [&](const ClipCorner& corner) {
    return segment_.begin.height(corner.p) < 0 || kindsEndingBefore(scratch_, corner.p) != 0;
  });
  for (size_t i = 2; i < corners.size(); ++i) {
    const std::array<RasterVertex, 3> vertices{corners[0], corners[i - 1], corners[i]};
    if (within) {
      fill(triangle, vertices);
    } else {
      fillTested(triangle, vertices, {polygon[0].p, polygon[i - 1].p, polygon[i].p}, scratch_.kinds);
    }
  }
}

/// `kinds`: of rays that may meet it.
void SegmentRasterizer::Drawing::fillTested(uint32_t triangle, const std::array<RasterVertex, 3>& vertices,
                                            const std::array<glm::dvec3, 3>& points, uint64_t kinds) {
  // Of a small triangle few pixels ask for heights, so they are not worked out ahead.
  const bool isSmall = extentOf(vertices) <= kSmallPixels;
  std::optional<HeightOver> begin;
  if (!isSmall) {
    begin.emplace(segment_.begin, vertices, points);
    if (begin->isBeforeAll()) {
      return;
    }
  }
  int held = -1;  // the kind of rays whose ends these are
  std::vector<HeightOver>& ends = scratch_.heights;
  const auto hold = [&](size_t kind) {
    held = static_cast<int>(kind);
    ends.clear();
    for (const Plane& plane : segment_.ends[kind]) {
      ends.emplace_back(plane, vertices, points);
    }
  };
  bool endsBefore = !isSmall;
  for (auto kind = scratch_.ends.begin(); kind != scratch_.ends.end() && endsBefore; ++kind) {
    if ((kinds & RegionBuffer::kindBit(kind->first)) != 0) {
      hold(kind->first);
      endsBefore = std::any_of(ends.begin(), ends.end(), [](const HeightOver& end) { return end.isBeyondAll(); });
    }
  }
  if (endsBefore) {
    return;
  }
  region_.scan(
      rect_, vertices[0], vertices[1], vertices[2], [&](size_t pixel, float weight, const PixelWeights& weights) {
        if (!region_.isNearest(pixel, weight, triangle)) {
          return;
        }
        if (!begin) {
          begin.emplace(segment_.begin, vertices, points);
        }
        if (begin->isBefore(weights)) {
          return;
        }
        const int kind = segment_.endsOfLeaf[region_.leaf(pixel)];
        if (kind != held) {
          hold(static_cast<size_t>(kind));
        }
        if (std::none_of(ends.begin(), ends.end(), [&](const HeightOver& end) { return end.isBeyond(weights); })) {
          region_.put(pixel, weight, triangle, weights());
        }
      });
}

}  // namespace ocelli
