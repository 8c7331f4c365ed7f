#include "oc_core/render/bend_rasterizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ocelli {
namespace {

constexpr int kDeepest = 24;  // only guards against numbers gone wrong
/// An edge that might bend more than this is split without a look at its middle, which tells of one bend alone.
constexpr double kMaxBendPixels = 16;

/// Bends of less, for certain: what rounding takes from it.
constexpr double kSurelyStraightPixels = 0.999 * BendRasterizer::kErrorPixels;

/// What rounding to single precision may take from shares, a thousand times.
constexpr double kShareRoom = 1e-4;

/// The pixels of a rectangle that points between these may lie in.
PixelBounds pixelsAround(const glm::dvec2& lower, const glm::dvec2& upper, const PixelBounds& rect) {
  const glm::ivec2 least(rect.x0, rect.y0);
  const glm::ivec2 most(rect.x1, rect.y1);
  const glm::ivec2 first(glm::clamp(glm::floor(lower), glm::dvec2(least), glm::dvec2(most)));
  const glm::ivec2 last(glm::clamp(glm::ceil(upper), glm::dvec2(least), glm::dvec2(most)));
  return {first.x, first.y, last.x, last.y};
}

RasterVertex rasterVertex(const BendRasterizer::Vertex& v) {
  return {static_cast<float>(v.image.pixel.x), static_cast<float>(v.image.pixel.y),
          static_cast<float>(1 / v.image.weight), static_cast<float>(v.b.x), static_cast<float>(v.b.y)};
}

}  // namespace

struct BendRasterizer::OwnScratch final : PieceRasterizer::Scratch {
  BlockVertices points;
  BendImages images;
  bool isStraight = false;                                    ///< no edge of the block is to be split, for certain
  glm::dvec2 lower{std::numeric_limits<double>::infinity()};  ///< around what was drawn of a block
  glm::dvec2 upper{-std::numeric_limits<double>::infinity()};
  Clipper clipper;
  std::vector<Vertex> corners;
};

BendRasterizer::BendRasterizer(const CurvedRayCamera& camera, size_t bend, uint8_t order, const Mesh& mesh,
                               const MeshBlocks& blocks)
    : mesh_(mesh),
      blocks_(blocks),
      projection_(camera, bend),
      order_(order),
      rect_{0, 0, camera.width(), camera.height()} {
  const RegionGrid grid(camera.width(), camera.height());
  for (int row = 0; row < grid.down(); ++row) {
    const PixelBounds strip{0, grid.rect(0, row).y0, camera.width(), grid.rect(0, row).y1};
    sidesOfRows_.push_back(bounds().sidesOf(camera, strip));
  }
  for (size_t region = 0; region < grid.size(); ++region) {
    sidesOfRegions_.push_back(bounds().sidesOf(camera, grid.rect(region)));
  }
}

void BendRasterizer::findBlocks(MeshBlocks::Runs runs, uint32_t piece, const RegionGrid& grid,
                                std::vector<BlockTask>& tasks) const {
  blocks_.forEachWithin(runs, bounds().spaces(), [&](uint32_t block, Placement) {
    const Box& box = blocks_[block].box;
    BlockTask task{piece, block, false, 0, 0, bounds().leastShare(box), {}};
    for (int row = 0; row < grid.down(); ++row) {
      if (placementOf(box, sidesOfRows_[static_cast<size_t>(row)]) == Placement::kOutside) {
        continue;
      }
      for (int column = 0; column < grid.across(); ++column) {
        if (placementOf(box, sidesOfRegions_[static_cast<size_t>(row * grid.across() + column)]) !=
            Placement::kOutside) {
          task.rect = grid.rect(column, row);
          tasks.push_back(task);
        }
      }
    }
  });
}

std::unique_ptr<PieceRasterizer::Scratch> BendRasterizer::makeScratch() const {
  return std::make_unique<OwnScratch>();
}

/// Projects the vertices of a block.
void BendRasterizer::place(uint32_t block, OwnScratch& scratch) const {
  scratch.points.collect(mesh_, blocks_, block);
  projection_.project(scratch.points, scratch.images);
  const BendImages& images = scratch.images;
  const size_t count = scratch.points.size();
  const auto extent = [&](const BendImages::Numbers& n) {
    const auto [least, most] = std::minmax_element(n.begin(), n.begin() + static_cast<std::ptrdiff_t>(count));
    return *most - *least;
  };
  scratch.isStraight =
      std::all_of(images.cells.begin(), images.cells.begin() + static_cast<std::ptrdiff_t>(count),
                  [](CentreCell cell) { return cell.isKnown(); }) &&
      projection_.greatestBend(extent(images.u) + extent(images.v), extent(images.share)) <= kSurelyStraightPixels;
}

/// Whether no edge of a triangle is to be split, for certain.
bool BendRasterizer::isStraight(const BlockVertices::Triangle& triangle, const OwnScratch& scratch) const {
  if (scratch.isStraight) {
    return true;
  }
  const auto [a, b, c] = triangle.corners;
  if (!scratch.images.cells[a].isKnown() || !scratch.images.cells[b].isKnown() || !scratch.images.cells[c].isKnown()) {
    return false;
  }
  // No edge is longer than that, or passes more of the bend.
  const auto extent = [&](const BendImages::Numbers& n) {
    return std::max({n[a], n[b], n[c]}) - std::min({n[a], n[b], n[c]});
  };
  const BendImages& images = scratch.images;
  return projection_.greatestBend(extent(images.u) + extent(images.v), extent(images.share)) <= kSurelyStraightPixels;
}

/// Draws a triangle that is not to be split.
void BendRasterizer::drawStraight(const Sink& sink, const BlockVertices::Triangle& triangle,
                                  OwnScratch& scratch) const {
  const auto [a, b, c] = triangle.corners;
  if (CentreCell::missCentres(scratch.images.cells[a], scratch.images.cells[b], scratch.images.cells[c])) {
    return;
  }
  const BendImages& images = scratch.images;
  const auto corner = [&](size_t i) {
    return RasterVertex{static_cast<float>(images.u[i]), static_cast<float>(images.v[i]), 0, 0, 0};
  };
  const double share = std::min({images.share[a], images.share[b], images.share[c]});
  if (!sink.region.missesAll(sink.region.rect(), corner(a), corner(b), corner(c),
                             static_cast<float>(share * (1 - kShareRoom)))) {
    fill(sink, meshVertex(a, {0, 0}, scratch), meshVertex(b, {1, 0}, scratch), meshVertex(c, {0, 1}, scratch));
    for (const size_t i : {a, b, c}) {
      scratch.lower = glm::min(scratch.lower, glm::dvec2(images.u[i], images.v[i]));
      scratch.upper = glm::max(scratch.upper, glm::dvec2(images.u[i], images.v[i]));
    }
  }
}

/// What drawStraight() has drawn of a block.
void BendRasterizer::touch(RegionBuffer& region, OwnScratch& scratch) const {
  if (scratch.lower.x <= scratch.upper.x) {
    region.touch(pixelsAround(scratch.lower - 1.0, scratch.upper + 1.0, region.rect()));
  }
  scratch.lower = glm::dvec2(std::numeric_limits<double>::infinity());
  scratch.upper = -scratch.lower;
}

BendRasterizer::Vertex BendRasterizer::meshVertex(size_t i, const glm::dvec2& b, const OwnScratch& scratch) const {
  const BendImages& images = scratch.images;
  return {glm::dvec3(scratch.points.position(i)),
          b,
          {{images.u[i], images.v[i]},
           images.weight[i],
           images.behindFirst[i],
           images.beforeLast[i],
           images.imaged[i] != 0}};
}

void BendRasterizer::begin(const RegionBuffer& /*region*/, uint64_t /*kinds*/, Scratch& /*scratch*/) const {}

void BendRasterizer::draw(RegionBuffer& region, const BlockTask& task, Scratch& scratch) const {
  auto& own = static_cast<OwnScratch&>(scratch);
  place(task.block, own);
  for (const BlockVertices::Triangle& triangle : own.points.triangles()) {
    const auto [a, b, c] = triangle.corners;
    if ((own.images.outside[a] & own.images.outside[b] & own.images.outside[c]) != 0) {
      continue;
    }
    const Sink sink{region, triangle.index};
    if ((own.images.outside[a] | own.images.outside[b] | own.images.outside[c]) != 0) {
      drawClipped(sink, own);
    } else if (isStraight(triangle, own)) {
      drawStraight(sink, triangle, own);
    } else {
      refine(sink, meshVertex(a, {0, 0}, own), meshVertex(b, {1, 0}, own), meshVertex(c, {0, 1}, own), 0);
    }
  }
  touch(region, own);
}

void BendRasterizer::drawClipped(const Sink& sink, OwnScratch& scratch) const {
  const glm::uvec3& t = mesh_.triangles[sink.triangle];
  std::vector<Vertex>& corners = scratch.corners;
  corners.clear();
  for (const ClipCorner& corner :
       scratch.clipper.clip(mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z], bounds().slab())) {
    corners.push_back(vertex(corner.p, corner.b));
  }
  for (size_t i = 2; i < corners.size(); ++i) {
    refine(sink, corners[0], corners[i - 1], corners[i], 0);
  }
}

/// Whether a piece misses the region or lies behind what the region holds. An edge bulges by less than half of its
/// length: so does a piece. Pieces with a corner that has no image are looked at in the world.
bool BendRasterizer::isUnseen(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c) const {
  if (!a.image.imaged || !b.image.imaged || !c.image.imaged) {
    return std::any_of(bounds().sides().begin(), bounds().sides().end(), [&](const HalfSpace& space) {
      const auto isOutside = [&](const Vertex& v) { return glm::dot(space, glm::dvec4(v.p, 1)) < 0; };
      return isOutside(a) && isOutside(b) && isOutside(c);
    });
  }
  glm::dvec2 lower = glm::min(a.image.pixel, glm::min(b.image.pixel, c.image.pixel));
  glm::dvec2 upper = glm::max(a.image.pixel, glm::max(b.image.pixel, c.image.pixel));
  const double room = 1 + ((upper.x - lower.x) + (upper.y - lower.y)) / 2;
  lower -= room;
  upper += room;
  const PixelBounds& rect = sink.region.rect();
  if (upper.x < rect.x0 || upper.y < rect.y0 || lower.x > rect.x1 || lower.y > rect.y1) {
    return true;
  }
  // The share of the bend is greatest and least at corners.
  const double share = std::min({a.image.share(), b.image.share(), c.image.share()});
  return !sink.region.mayShow(pixelsAround(lower, upper, rect), static_cast<float>(share * (1 - kShareRoom)));
}

/// The middle of an edge that is to be split.
std::optional<BendRasterizer::Vertex> BendRasterizer::splitOf(const Vertex& a, const Vertex& b) const {
  const bool imaged = a.image.imaged && b.image.imaged;
  const double bend = projection_.greatestBend(glm::distance(a.image.pixel, b.image.pixel),
                                               std::abs(a.image.share() - b.image.share()));
  if (imaged ? bend <= kErrorPixels : glm::distance(a.p, b.p) <= bounds().shortestEdge()) {
    return std::nullopt;
  }
  const Vertex middle = vertex((a.p + b.p) * 0.5, (a.b + b.b) * 0.5);
  const bool isStraight = imaged && middle.image.imaged && bend <= kMaxBendPixels &&
                          projection_.deviation(a.image, b.image, middle.image) <= kErrorPixels;
  return isStraight ? std::nullopt : std::optional(middle);
}

void BendRasterizer::fillAndTouch(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c) const {
  if (!a.image.imaged || !b.image.imaged || !c.image.imaged) {
    return;
  }
  fill(sink, a, b, c);
  const glm::dvec2 lower = glm::min(a.image.pixel, glm::min(b.image.pixel, c.image.pixel));
  const glm::dvec2 upper = glm::max(a.image.pixel, glm::max(b.image.pixel, c.image.pixel));
  sink.region.touch(pixelsAround(lower - 1.0, upper + 1.0, sink.region.rect()));
}

void BendRasterizer::refineOne(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& ab,
                               int depth) const {
  refine(sink, a, ab, c, depth + 1);
  refine(sink, ab, b, c, depth + 1);
}

void BendRasterizer::refineTwo(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& ab,
                               const Vertex& bc, int depth) const {
  refine(sink, ab, b, bc, depth + 1);
  refine(sink, a, ab, bc, depth + 1);
  refine(sink, a, bc, c, depth + 1);
}

void BendRasterizer::refine(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c, int depth) const {
  if (isUnseen(sink, a, b, c)) {
    return;
  }
  if (depth >= kDeepest) {
    fillAndTouch(sink, a, b, c);
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
    fillAndTouch(sink, a, b, c);
  }
}

void BendRasterizer::fill(const Sink& sink, const Vertex& a, const Vertex& b, const Vertex& c) const {
  const auto inSingle = [](double atA, double atB, double atC) {
    return std::array{static_cast<float>(atA), static_cast<float>(atB), static_cast<float>(atC)};
  };
  const auto behind = inSingle(a.image.behindFirst, b.image.behindFirst, c.image.behindFirst);
  const auto ahead = inSingle(a.image.beforeLast, b.image.beforeLast, c.image.beforeLast);
  const std::array<RasterVertex, 3> vertices{rasterVertex(a), rasterVertex(b), rasterVertex(c)};
  sink.region.scan(sink.region.rect(), vertices[0], vertices[1], vertices[2],
                   [&](size_t pixel, float /*weight*/, const PixelWeights& weights) {
                     const float first = weights.of(behind[0], behind[1], behind[2]);
                     const float last = weights.of(ahead[0], ahead[1], ahead[2]);
                     const float share = first > 0 ? first / (first + std::max(last, 0.0f)) : 0;
                     const float depth = std::max(share, 1e-30f);
                     if (sink.region.isNearest(pixel, depth, sink.triangle)) {
                       sink.region.put(pixel, depth, sink.triangle, weights());
                     }
                   });
}

}  // namespace ocelli
