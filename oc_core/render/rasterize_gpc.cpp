#include "oc_core/render/rasterize_gpc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/gpc_vertices.h"
#include "oc_core/render/pinhole_triangles.h"

namespace ocelli {
namespace {

bool boxesOverlap(const ImageBox& a, const ImageBox& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y;
}
/// Whether a box without its slack holds another.
bool boxHolds(const ImageBox& whole, const ImageBox& part) {
  constexpr float kBoth = 2 * GpcRasterZone::kBoxSlack;
  return part.lower.x >= whole.lower.x + kBoth && part.lower.y >= whole.lower.y + kBoth &&
         part.upper.x <= whole.upper.x - kBoth && part.upper.y <= whole.upper.y - kBoth;
}

/// A triangle or a part of one: in the pinhole's image, and its corners in the camera's.
struct GpcTriangle {
  RasterVertex a;
  RasterVertex b;
  RasterVertex c;
  std::array<bool, 3>
      isChord;   ///< whether the edge opposite of a corner may be filled as a straight one in a transition
  ImageBox box;  ///< in the pinhole's image
};

/// A triangle where samples bend: from its first corner, and how far from each edge a pixel belongs to it.
class TransitionTriangle {
 public:
  explicit TransitionTriangle(const GpcTriangle& triangle)
      : triangle_(triangle),
        pa_(triangle.a.u, triangle.a.v),
        ab_(glm::dvec2(triangle.b.u, triangle.b.v) - pa_),
        ac_(glm::dvec2(triangle.c.u, triangle.c.v) - pa_) {
    const double area = ab_.x * ac_.y - ab_.y * ac_.x;
    isEmpty_ = area == 0;
    perArea_ = 1 / area;
    // Triangles that share an edge evaluate it at the same places. Only one that is straight for a small neighbour may
    // lie a chord beside: pixels so near to it belong to both.
    constexpr double kRounding = 1e-6;
    const auto outside = [&](bool isChord, const glm::dvec2& along) {
      // Its length, or up to 1.09 times that.
      const glm::dvec2 size = glm::abs(along);
      const double length = std::max(size.x, size.y) + 0.41421357 * std::min(size.x, size.y);
      return -std::abs(perArea_) * length * (isChord ? GpcRasterZone::kChordPixels : kRounding);
    };
    onEdge_ = {outside(triangle.isChord[0], ac_ - ab_), outside(triangle.isChord[1], ac_),
               outside(triangle.isChord[2], ab_)};
  }

  bool isEmpty() const { return isEmpty_; }

  /// The part of the pixels `first` to `last` of a line whose samples may be covered: the first of them lies at `at`,
  /// each next one a step farther. Never too small.
  void clip(const glm::dvec2& at, const glm::dvec2& step, double spacing, int& first, int& last) const {
    const glm::dvec2 p = at - pa_;
    const double b = (p.x * ac_.y - p.y * ac_.x) * perArea_;
    const double c = (ab_.x * p.y - ab_.y * p.x) * perArea_;
    const double stepB = (step.x * ac_.y - step.y * ac_.x) * perArea_;
    const double stepC = (ab_.x * step.y - ab_.y * step.x) * perArea_;
    double from = 0;
    double to = last - first;
    const auto clipEdge = [&](double share, double change, double least) {
      const double crossing = (least - share) / change;  // not finite where the line runs along the edge
      from = change > 0 && crossing > from ? crossing : from;
      to = change < 0 && crossing < to ? crossing : to;
    };
    clipEdge(1 - b - c, -stepB - stepC, onEdge_.x * spacing);
    clipEdge(b, stepB, onEdge_.y * spacing);
    clipEdge(c, stepC, onEdge_.z * spacing);
    // A pixel more at either end, for rounding.
    last = to < 0 || to < from - 2 ? first - 1 : std::min(last, first + static_cast<int>(to) + 1);
    first = from > last - first + 2 ? last + 1 : first + std::max(static_cast<int>(from) - 1, 0);
  }

  /// Calls `emit(z, weights)` where the triangle covers a sample at `at`, whose neighbours are `spacing` away.
  template <class Emit>
  void sample(const glm::dvec2& at, double spacing, const Emit& emit) const {
    const double px = at.x - pa_.x;
    const double py = at.y - pa_.y;
    const double shareB = (px * ac_.y - py * ac_.x) * perArea_;
    const double shareC = (ab_.x * py - ab_.y * px) * perArea_;
    const double shareA = 1 - shareB - shareC;
    if ((shareA < onEdge_.x * spacing) | (shareB < onEdge_.y * spacing) | (shareC < onEdge_.z * spacing)) {
      return;
    }
    const glm::dvec3 shares = glm::max(glm::dvec3(shareA, shareB, shareC), 0.0);
    const PixelWeights weights(triangle_.a, triangle_.b, triangle_.c,
                               glm::vec3(shares / (shares.x + shares.y + shares.z)), false);
    emit(weights.z(), weights);
  }

 private:
  const GpcTriangle& triangle_;
  glm::dvec2 pa_;
  glm::dvec2 ab_;
  glm::dvec2 ac_;
  double perArea_;
  glm::dvec3 onEdge_{0};
  bool isEmpty_;
};

std::vector<GpcRasterZone> rasterZones(const GpcCamera& camera) {
  std::vector<GpcRasterZone> zones;
  zones.reserve(camera.map().zones().size());
  for (const GpcZone& zone : camera.map().zones()) {
    zones.emplace_back(zone, static_cast<uint32_t>(zones.size()), glm::ivec2(camera.width(), camera.height()));
  }
  return zones;
}

/// Which zones a box of the pinhole's image may touch, by square cells of the image.
class ZoneCells {
 public:
  ZoneCells(std::span<const GpcRasterZone> zones, const glm::ivec2& size)
      : zones_(zones), cells_((size.x - 1) / kCell + 1, (size.y - 1) / kCell + 1) {
    for (uint32_t zone = 0; zone < zones.size(); ++zone) {
      forEachCell(zones[zone].outerBox(), [&](int x, int y) { cells_(x, y).push_back(zone); });
    }
  }

  /// Calls `visit(zone)` for the zones whose outer rectangle touches a box, each once.
  template <class Visit>
  void forEachTouching(const ImageBox& box, const Visit& visit) const {
    forEachCell(box, [&](int x, int y) {
      for (const uint32_t index : cells_(x, y)) {
        const GpcRasterZone& zone = zones_[index];
        const ImageBox& outer = zone.outerBox();
        // In the first cell of both, so that it comes once.
        if (boxesOverlap(box, outer) && x == cellAt(std::max(box.lower.x, outer.lower.x), cells_.width()) &&
            y == cellAt(std::max(box.lower.y, outer.lower.y), cells_.height())) {
          visit(zone);
        }
      }
    });
  }

 private:
  static constexpr int kCell = 32;  ///< pixels

  /// That of the border for what is beyond: zones lie in the image.
  static int cellAt(float pixel, int count) {
    return std::clamp(static_cast<int>(std::floor(pixel / kCell)), 0, count - 1);
  }
  template <class Visit>
  void forEachCell(const ImageBox& box, const Visit& visit) const {
    const int x1 = cellAt(box.upper.x, cells_.width());
    const int y1 = cellAt(box.upper.y, cells_.height());
    for (int y = cellAt(box.lower.y, cells_.height()); y <= y1; ++y) {
      for (int x = cellAt(box.lower.x, cells_.width()); x <= x1; ++x) {
        visit(x, y);
      }
    }
  }

  std::span<const GpcRasterZone> zones_;
  Image<std::vector<uint32_t>> cells_;
};

class GpcTriangles {
 public:
  GpcTriangles(const GpcCamera& camera, const ProjectedMesh& projected, bool hasStraightEdges)
      : projected_(projected),
        triangles_(projected),
        width_(camera.width()),
        height_(camera.height()),
        longestChord_(hasStraightEdges ? 1.0f : -1.0f),
        zones_(rasterZones(camera)),
        cells_(zones_, {width_, height_}),
        vertices_(zones_, projected),
        isOfZone_(static_cast<size_t>(width_) * static_cast<size_t>(height_), 0) {
    for (const GpcRasterZone& zone : zones_) {
      const PixelBounds& pixels = zone.outerPixels();
      for (int y = pixels.y0; y < pixels.y1; ++y) {
        std::fill_n(isOfZone_.begin() + static_cast<ptrdiff_t>(index(pixels.x0, y)), pixels.x1 - pixels.x0, 1);
      }
    }
  }

  /// Fetches what draw() reads first of a triangle: the vertices of large meshes are in no cache.
  void prefetch(size_t triangle) const {
    const glm::uvec3& t = projected_.mesh().triangles[triangle];
    __builtin_prefetch(&vertices_[t.x]);
    __builtin_prefetch(&vertices_[t.y]);
    __builtin_prefetch(&vertices_[t.z]);
  }
  void draw(VisibilityBuffer& buffer, uint32_t triangle) const {
    const glm::uvec3& t = projected_.mesh().triangles[triangle];
    const GpcVertex& a = vertices_[t.x];
    const GpcVertex& b = vertices_[t.y];
    const GpcVertex& c = vertices_[t.z];
    const ImageBox image{{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
                         {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
    const GpcBend most = max(max(a.bend, b.bend), c.bend);
    const glm::vec2 size = image.upper - image.lower;
    const bool isOnePart = (a.part == b.part) & (b.part == c.part);
    if (isOnePart && most(size.x, size.y) <= longestChord_) {
      if (!CentreCell::missCentres(a.cell, b.cell, c.cell)) {
        buffer.draw(triangle, {a.x, a.y, a.inverseZ, 0, 0}, {b.x, b.y, b.inverseZ, 1, 0}, {c.x, c.y, c.inverseZ, 0, 1});
      }
    } else if (most.xx < GpcBend::kUnknown) {
      const ProjectedVertex& pa = projected_.vertex(t.x);
      const ProjectedVertex& pb = projected_.vertex(t.y);
      const ProjectedVertex& pc = projected_.vertex(t.z);
      const GpcTriangle whole{{pa.u, pa.v, pa.inverseZ, 0, 0},
                              {pb.u, pb.v, pb.inverseZ, 1, 0},
                              {pc.u, pc.v, pc.inverseZ, 0, 1},
                              chords({&a, &b, &c}),
                              boxOf(pa, pb, pc)};
      if (isOnePart && GpcRasterZone::isInTransition(a.part)) {
        const GpcRasterZone& zone = zones_[a.part / GpcRasterZone::kParts];
        if (size.x * size.x + size.y * size.y <= zone.longestSquared()) {
          // A chord strays by an eighth of the second derivative at most; twice that for what changes along it.
          const float stray = most(size.x, size.y) * (GpcRasterZone::kMaxBend / 4) + GpcRasterZone::kBoxSlack;
          drawBent(buffer, triangle, zone, whole, {image.lower - stray, image.upper + stray});
          return;
        }
      }
      drawPieces(buffer, triangle, whole);
    } else {
      triangles_.forEachPartAnywhere(triangle, [&](const RasterVertex& p, const RasterVertex& q,
                                                   const RasterVertex& r) { drawClipped(buffer, triangle, p, q, r); });
    }
  }

 private:
  /// Which edges, each opposite of a corner, are filled as straight ones where they are those of small triangles.
  std::array<bool, 3> chords(const std::array<const GpcVertex*, 3>& v) const {
    std::array<bool, 3> result{};
    for (size_t i = 0; i < 3; ++i) {
      const GpcVertex& a = *v[(i + 1) % 3];
      const GpcVertex& b = *v[(i + 2) % 3];
      result[i] = a.part == b.part && GpcRasterZone::isInTransition(a.part) &&
                  max(a.bend, b.bend)(std::abs(a.x - b.x), std::abs(a.y - b.y)) <= longestChord_;
    }
    return result;
  }

  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }

  void drawClipped(VisibilityBuffer& buffer, uint32_t triangle, const RasterVertex& a, const RasterVertex& b,
                   const RasterVertex& c) const {
    const std::array<ProjectedVertex, 3> corners{
        {{a.u, a.v, a.inverseZ}, {b.u, b.v, b.inverseZ}, {c.u, c.v, c.inverseZ}}};
    std::array<GpcVertex, 3> placed;
    vertices_.place(corners, placed);
    drawPieces(buffer, triangle, {a, b, c, chords({&placed[0], &placed[1], &placed[2]}), boxOf(a, b, c)});
  }

  template <class Vertex>
  static ImageBox boxOf(const Vertex& a, const Vertex& b, const Vertex& c) {
    return {{std::min({a.u, b.u, c.u}), std::min({a.v, b.v, c.v})},
            {std::max({a.u, b.u, c.u}), std::max({a.v, b.v, c.v})}};
  }

  void drawPieces(VisibilityBuffer& buffer, uint32_t triangle, const GpcTriangle& part) const {
    bool isCovered = false;  // by one zone: nothing of it is around the regions
    bool touches = false;
    cells_.forEachTouching(part.box, [&](const GpcRasterZone& zone) {
      touches = true;
      isCovered = isCovered || boxHolds(zone.outerBox(), part.box);
      if (boxesOverlap(part.box, zone.innerBox())) {
        drawInner(buffer, triangle, zone, part);
      }
      if (!boxHolds(zone.innerBox(), part.box)) {
        drawTransition(buffer, triangle, zone, part);
      }
    });
    if (!touches) {
      buffer.draw(triangle, part.a, part.b, part.c);
    } else if (!isCovered) {
      drawAround(buffer, triangle, part);
    }
  }

  /// As the pinhole draws it, in pixels of no zone.
  void drawAround(VisibilityBuffer& buffer, uint32_t triangle, const GpcTriangle& part) const {
    scanTriangle(width_, height_, part.a, part.b, part.c, [&](size_t pixel, float z, const PixelWeights& weights) {
      if (isOfZone_[pixel] == 0) {
        buffer.offer(pixel, z, triangle, weights);
      }
    });
  }

  void drawInner(VisibilityBuffer& buffer, uint32_t triangle, const GpcRasterZone& zone,
                 const GpcTriangle& part) const {
    const auto zoomed = [&](const RasterVertex& v) {
      const glm::vec2 image = zone.zoomed(v.u, v.v);
      return RasterVertex{image.x, image.y, v.inverseZ, v.b1, v.b2};
    };
    scanTriangle(
        width_, zone.innerPixels(), zoomed(part.a), zoomed(part.b), zoomed(part.c),
        [&](size_t pixel, float z, const PixelWeights& weights) { buffer.offer(pixel, z, triangle, weights); });
  }

  /// Edge functions where the samples of the pixels lie in the pinhole's image.
  void drawTransition(VisibilityBuffer& buffer, uint32_t triangle, const GpcRasterZone& zone,
                      const GpcTriangle& part) const {
    const ImageBox& outer = zone.outerBox();
    drawBent(buffer, triangle, zone, part,
             zone.imageBox({glm::max(part.box.lower, outer.lower), glm::min(part.box.upper, outer.upper)}));
  }

  static PixelBounds pixelsWithin(const GpcRasterZone& zone, const ImageBox& image) {
    const PixelBounds& pixels = zone.outerPixels();
    return {std::max(static_cast<int>(std::ceil(image.lower.x - 0.5f)), pixels.x0),
            std::max(static_cast<int>(std::ceil(image.lower.y - 0.5f)), pixels.y0),
            std::min(static_cast<int>(std::floor(image.upper.x - 0.5f)) + 1, pixels.x1),
            std::min(static_cast<int>(std::floor(image.upper.y - 0.5f)) + 1, pixels.y1)};
  }

  /// In the pixels of the transition that lie in a box.
  void drawBent(VisibilityBuffer& buffer, uint32_t triangle, const GpcRasterZone& zone, const GpcTriangle& part,
                const ImageBox& image) const {
    const PixelBounds within = pixelsWithin(zone, image);
    if (within.x0 >= within.x1 || within.y0 >= within.y1) {
      return;
    }
    const TransitionTriangle bent(part);
    if (bent.isEmpty()) {
      return;
    }
    constexpr int kFew = 16;
    if ((within.x1 - within.x0) * (within.y1 - within.y0) <= kFew) {
      for (int y = within.y0; y < within.y1; ++y) {
        for (int x = within.x0; x < within.x1; ++x) {
          if (!zone.isInner(x, y)) {
            drawPixel(buffer, triangle, zone, bent, x, y);
          }
        }
      }
      return;
    }
    // Row by row above and below the region, column by column beside it: along these lines samples are equally far
    // apart, so that the edges tell which pixels they cover.
    const glm::dvec2 center = zone.zone().center();
    for (int y = within.y0; y < within.y1; ++y) {
      const GpcRasterZone::Line& row = zone.row(y);
      GpcRasterZone::Range x = zone.columnsNearerThan(row, within.x0, within.x1 - 1);
      if (row.r > 1 && x.first <= x.last) {
        const glm::dvec2 at = center + glm::dvec2(zone.column(x.first).offset, row.offset) * row.scale;
        bent.clip(at, {row.scale, 0}, row.spacing, x.first, x.last);
        for (; x.first <= x.last; ++x.first) {
          drawPixel(buffer, triangle, zone, bent, x.first, y);
        }
      }
    }
    for (int x = within.x0; x < within.x1; ++x) {
      const GpcRasterZone::Line& column = zone.column(x);
      GpcRasterZone::Range y = zone.rowsNoFartherThan(column, within.y0, within.y1 - 1);
      if (column.r > 1 && y.first <= y.last) {
        const glm::dvec2 at = center + glm::dvec2(column.offset, zone.row(y.first).offset) * column.scale;
        bent.clip(at, {0, column.scale}, column.spacing, y.first, y.last);
        for (; y.first <= y.last; ++y.first) {
          drawPixel(buffer, triangle, zone, bent, x, y.first);
        }
      }
    }
  }

  /// A pixel of the transition.
  void drawPixel(VisibilityBuffer& buffer, uint32_t triangle, const GpcRasterZone& zone, const TransitionTriangle& bent,
                 int x, int y) const {
    const GpcRasterZone::Line& row = zone.row(y);
    const GpcRasterZone::Line& column = zone.column(x);
    const GpcRasterZone::Line& line = column.r >= row.r ? column : row;
    const glm::dvec2 at = zone.zone().center() + glm::dvec2(column.offset, row.offset) * line.scale;
    bent.sample(at, line.spacing,
                [&](float z, const PixelWeights& weights) { buffer.offer(index(x, y), z, triangle, weights); });
  }

  const ProjectedMesh& projected_;
  PinholeTriangles triangles_;
  int width_;
  int height_;
  float longestChord_;  ///< how much a straight edge may bend (GpcBend); negative for none
  std::vector<GpcRasterZone> zones_;
  ZoneCells cells_;
  GpcVertices vertices_;
  std::vector<uint8_t> isOfZone_;  ///< whether a pixel is one of a zone
};

FragmentImage drawGpc(const GpcCamera& camera, const ProjectedMesh& projected, bool hasStraightEdges) {
  constexpr size_t kAhead = 12;  // triangles
  const GpcTriangles triangles(camera, projected, hasStraightEdges);
  return drawParallel(camera.width(), camera.height(), projected.mesh().triangles.size(),
                      [&](VisibilityBuffer& buffer, size_t begin, size_t end) {
                        for (size_t i = begin; i < end; ++i) {
                          triangles.prefetch(std::min(i + kAhead, end - 1));
                          triangles.draw(buffer, static_cast<uint32_t>(i));
                        }
                      });
}

}  // namespace

FragmentImage rasterizeGpc(const GpcCamera& camera, const ProjectedMesh& projected) {
  return drawGpc(camera, projected, true);
}

FragmentImage rasterizeGpc(const GpcCamera& camera, const Mesh& mesh) {
  return rasterizeGpc(camera, ProjectedMesh(camera.reference(), mesh));
}

FragmentImage rasterizeGpcExactly(const GpcCamera& camera, const ProjectedMesh& projected) {
  return drawGpc(camera, projected, false);
}

SubdivisionOptions gpcSubdivision(const GpcCamera& camera) {
  SubdivisionOptions options;
  options.shortestEdgePixels /= std::max(camera.greatestRate(), 1.0f);
  return options;
}

}  // namespace ocelli
