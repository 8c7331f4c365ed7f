#include "oc_core/render/straight_segment.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

/// How far beyond its part of the image the triangles of a segment are kept, pixels: clipping must not move what is
/// inside.
constexpr double kPartMargin = 2;
/// What single precision and snapping may move pixels of a box by, pixels, and depths, relative to them: a thousand
/// times what they round by.
constexpr double kRoomPixels = 1;
constexpr double kRoomDepth = 1e-4;

/// The least and the most height over a plane.
std::pair<double, double> heights(const Plane& plane, const Box& box) {
  const glm::dvec3 half = (glm::dvec3(box.upper) - glm::dvec3(box.lower)) * 0.5;
  const double middle = plane.height(glm::dvec3(box.lower) + half);
  const double reach = glm::dot(glm::abs(plane.normal), half);
  return {middle - reach, middle + reach};
}

}  // namespace

SegmentBounds::SegmentBounds(const StraightSegment& segment)
    : segment_(segment),
      margin_(-1e-3 * segment.begin.height(segment.viewpoint)),
      spaces_(within(segment.part, segment.pixelFromWorld, kPartMargin)) {
  spaces_.push_back(beyond(segment.begin, margin_));
}

PixelBounds SegmentBounds::rectIn(int width, int height) const {
  glm::dvec2 lower = segment_.part[0];
  glm::dvec2 upper = segment_.part[0];
  for (const glm::dvec2& corner : segment_.part) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  const glm::dvec2 size(width, height);
  const glm::ivec2 first(glm::clamp(glm::floor(lower), glm::dvec2(0), size));
  const glm::ivec2 last(glm::clamp(glm::ceil(upper), glm::dvec2(0), size));
  return {first.x, first.y, last.x, last.y};
}

SegmentBounds::Ends SegmentBounds::endsOf(const Box& box) const {
  Ends ends;
  for (size_t kind = 0; kind < segment_.ends.size(); ++kind) {
    bool endsBefore = false;
    for (const Plane& plane : segment_.ends[kind]) {
      const auto [least, most] = heights(plane, box);
      endsBefore = endsBefore || least > margin_;
      ends.clear &= most <= 0 ? ~uint64_t{0} : ~RegionBuffer::kindBit(kind);
    }
    ends.ended &= endsBefore ? ~uint64_t{0} : ~RegionBuffer::kindBit(kind);
    ends.before = ends.before && endsBefore;
  }
  return ends;
}

/// Where a box may be seen, and how near.
void SegmentBounds::placeInImage(const Box& box, BlockTask& task) const {
  const glm::dmat4& m = segment_.pixelFromWorld;
  const auto row = [&](int i) { return glm::dvec4(m[0][i], m[1][i], m[2][i], m[3][i]); };
  const glm::dvec3 lower(box.lower);
  const glm::dvec3 size = glm::dvec3(box.upper) - lower;
  const glm::dvec4 weights = row(3);
  double weight = glm::dot(weights, glm::dvec4(lower, 1));
  double most = weight;
  for (int axis = 0; axis < 3; ++axis) {
    weight += std::min(weights[axis] * size[axis], 0.0);
    most += std::max(weights[axis] * size[axis], 0.0);
  }
  if (!(weight > 1e-6 * most)) {
    return;  // it reaches to the viewpoint or behind it: anywhere, however near
  }
  task.nearest = static_cast<float>(weight * (1 - kRoomDepth));
  glm::dvec2 first(std::numeric_limits<double>::infinity());
  glm::dvec2 last = -first;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 p(lower + size * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2), 1);
    const glm::dvec2 pixel = glm::dvec2(glm::dot(row(0), p), glm::dot(row(1), p)) / glm::dot(weights, p);
    first = glm::min(first, pixel);
    last = glm::max(last, pixel);
  }
  const PixelBounds part = task.rect;
  const auto inside = [](double at, int least, int greatest) {
    return static_cast<int>(std::clamp(at, static_cast<double>(least), static_cast<double>(greatest)));
  };
  task.rect = {inside(std::floor(first.x - kRoomPixels), part.x0, part.x1),
               inside(std::floor(first.y - kRoomPixels), part.y0, part.y1),
               inside(std::ceil(last.x + kRoomPixels), part.x0, part.x1),
               inside(std::ceil(last.y + kRoomPixels), part.y0, part.y1)};
}

void SegmentBounds::findBlocks(const MeshBlocks& blocks, MeshBlocks::Runs runs, uint32_t piece, const PixelBounds& rect,
                               std::vector<BlockTask>& tasks) const {
  blocks.forEachWithin(runs, spaces_, [&](uint32_t block, Placement placement) {
    const Box& box = blocks[block].box;
    const Ends ends = endsOf(box);
    if (!ends.before) {
      BlockTask task{piece,      block,      placement == Placement::kInside && heights(segment_.begin, box).first >= 0,
                     ends.clear, ends.ended, 0,
                     rect};
      placeInImage(box, task);
      tasks.push_back(task);
    }
  });
}

}  // namespace ocelli
