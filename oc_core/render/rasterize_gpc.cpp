#include "oc_core/render/rasterize_gpc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/pinhole_triangles.h"

namespace ocelli {
namespace {

/// Pixels whose centres lie within `half` of a place on an axis; both ends included.
struct GpcPixels {
  int first;
  int last;
};
GpcPixels gpcPixelsAlong(double center, double half, int count) {
  const auto clamped = [&](double pixel) {
    return static_cast<int>(std::clamp(pixel, -1.0, static_cast<double>(count)));
  };
  return {std::max(clamped(std::ceil(center - half - 0.5)), 0),
          std::min(clamped(std::floor(center + half - 0.5)), count - 1)};
}

PixelBounds gpcPixelBounds(const glm::dvec2& center, const glm::dvec2& half, const glm::ivec2& size) {
  const GpcPixels x = gpcPixelsAlong(center.x, half.x, size.x);
  const GpcPixels y = gpcPixelsAlong(center.y, half.y, size.y);
  return {x.first, y.first, x.last + 1, y.last + 1};
}

bool boxesOverlap(const ImageBox& a, const ImageBox& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y;
}
bool boxHolds(const ImageBox& whole, const ImageBox& part) {
  return part.lower.x >= whole.lower.x && part.lower.y >= whole.lower.y && part.upper.x <= whole.upper.x &&
         part.upper.y <= whole.upper.y;
}
ImageBox grownBox(const ImageBox& box, float by) {
  return {box.lower - by, box.upper + by};
}

/// What may be wrong with boxes for rounding, pixels.
constexpr float kBoxSlack = 1.0f / 256;

/// How far the straight edge of a small triangle may lie beside its image, pixels.
constexpr double kChordPixels = 1.0 / 64;

/// How long the edges of a triangle may be whose image has straight edges, but for kChordPixels: squares of pixels, for
/// equal steps of f from the inner edge of a transition to its outer one.
class ShortEdges {
 public:
  explicit ShortEdges(const GpcZone& zone)
      : inner_(1 / zone.profile().zoom()), perStep_((kSteps - 1) / (zone.profile().outer() - inner_)) {
    std::array<double, kSteps> bends{};
    for (size_t i = 0; i < kSteps; ++i) {
      bends[i] = bendAt(zone, static_cast<double>(i));
    }
    constexpr double kMargin = 1.5;  // between the places that were looked at
    for (size_t i = 0; i < kSteps; ++i) {
      const double around = std::max({bends[i], bends[i > 0 ? i - 1 : 0], bends[std::min(i + 1, kSteps - 1)]});
      squared_[i] = static_cast<float>(8 * kChordPixels / (kMargin * around + 1e-9));
    }
  }

  float at(double f) const {
    return squared_[static_cast<size_t>(std::clamp((f - inner_) * perStep_ + 0.5, 0.0, kSteps - 1.0))];
  }

 private:
  static constexpr size_t kSteps = 48;

  /// A chord of length L in the image lies at most L^2 / 8 times this beside its curve. From differences over one half
  /// of each sector; the other half is its mirror image.
  double bendAt(const GpcZone& zone, double place) const {
    constexpr int kAcross = 6;
    const double step = 0.01 / perStep_;
    // Not so near to an edge that a difference reaches across it.
    const double f = inner_ + std::clamp(place, 0.05, kSteps - 1.05) / perStep_;
    double greatest = 0;
    for (int k = 0; k < kAcross; ++k) {
      const double beside = f * (0.98 * k / (kAcross - 1));
      for (const int axis : {0, 1}) {
        glm::dvec2 at(beside);
        at[axis] = f;
        const glm::dvec2 p = zone.center() + zone.half() * at;
        for (const glm::dvec2 direction : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1), glm::dvec2(1, -1)}) {
          const glm::dvec2 d = zone.half() * direction * step;
          const glm::dvec2 before = zone.imageFromPinhole(p - d);
          const glm::dvec2 after = zone.imageFromPinhole(p + d);
          const glm::dvec2 half = (after - before) / 2.0;
          greatest = std::max(greatest, glm::length(before + after - 2.0 * zone.imageFromPinhole(p)) /
                                            (half.x * half.x + half.y * half.y));
        }
      }
    }
    return greatest;
  }

  double inner_;
  double perStep_;
  std::array<float, kSteps> squared_{};
};

/// A zone, and which pixels are in its rectangles.
struct GpcPiece {
  const GpcZone* zone;
  PixelBounds inner;
  PixelBounds outer;
  ImageBox innerBox;  ///< the inner rectangle in the pinhole's image
  ImageBox outerBox;
  float zoom;
  glm::vec2 shift;  ///< image = zoom * pinhole + shift within the inner rectangle
  ShortEdges shortEdges;

  bool isInner(int x, int y) const { return x >= inner.x0 && x < inner.x1 && y >= inner.y0 && y < inner.y1; }
  bool isOuter(int x, int y) const { return x >= outer.x0 && x < outer.x1 && y >= outer.y0 && y < outer.y1; }
};

class GpcTriangles {
 public:
  GpcTriangles(const GpcCamera& camera, const ProjectedMesh& projected)
      : projected_(projected),
        triangles_(projected),
        width_(camera.width()),
        height_(camera.height()),
        samples_(camera.width(), camera.height()),
        tiles_((camera.width() + kTile - 1) / kTile, (camera.height() + kTile - 1) / kTile) {
    const glm::ivec2 size(width_, height_);
    for (const GpcZone& zone : camera.map().zones()) {
      const glm::dvec2 c = zone.center();
      const double zoom = zone.profile().zoom();
      const auto box = [&](const glm::dvec2& half) {
        return grownBox({glm::vec2(c - half), glm::vec2(c + half)}, kBoxSlack);
      };
      pieces_.push_back({&zone, gpcPixelBounds(c, zone.half(), size), gpcPixelBounds(c, zone.outerHalf(), size),
                         box(zone.innerHalfInPinhole()), box(zone.outerHalf()), static_cast<float>(zoom),
                         glm::vec2(c * (1 - zoom)), ShortEdges(zone)});
      around_ = {glm::min(around_.lower, pieces_.back().outerBox.lower),
                 glm::max(around_.upper, pieces_.back().outerBox.upper)};
      placeSamples(pieces_.back());
    }
    boundTiles();
    placed_.resize(projected.mesh().positions.size());
    parallelFor(placed_.size(), 1 << 12, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const ProjectedVertex& q = projected.vertex(static_cast<uint32_t>(i));
        if (q.inverseZ > 0 && q.u >= around_.lower.x && q.v >= around_.lower.y && q.u <= around_.upper.x &&
            q.v <= around_.upper.y) {
          placed_[i] = placed({q.u, q.v});
        }
      }
    });
  }

  void draw(VisibilityBuffer& buffer, uint32_t triangle) const {
    const glm::uvec3& t = projected_.mesh().triangles[triangle];
    const ProjectedVertex& a = projected_.vertex(t.x);
    const ProjectedVertex& b = projected_.vertex(t.y);
    const ProjectedVertex& c = projected_.vertex(t.z);
    const Placed& pa = placed_[t.x];
    const Placed& pb = placed_[t.y];
    const Placed& pc = placed_[t.z];
    if (isShort(pa, pb) && isShort(pb, pc) && isShort(pc, pa)) {
      if (!CentreCell::missCentres(pa.cell, pb.cell, pc.cell)) {
        buffer.draw(triangle, {pa.image.x, pa.image.y, a.inverseZ, 0, 0}, {pb.image.x, pb.image.y, b.inverseZ, 1, 0},
                    {pc.image.x, pc.image.y, c.inverseZ, 0, 1});
      }
      return;
    }
    const bool isWhole = a.inverseZ > 0 && b.inverseZ > 0 && c.inverseZ > 0;
    if (isWhole && !touchesZone(boxOf(a, b, c))) {
      triangles_.forEachPart(triangle, [&](const RasterVertex& p, const RasterVertex& q, const RasterVertex& r) {
        buffer.draw(triangle, p, q, r);
      });
      return;
    }
    triangles_.forEachPartAnywhere(triangle, [&](const RasterVertex& p, const RasterVertex& q, const RasterVertex& r) {
      drawPart(buffer, triangle, p, q, r);
    });
  }

 private:
  static constexpr uint32_t kAround = ~uint32_t{0};
  static constexpr float kAnyLength = 1e30f;
  static constexpr uint32_t kParts = 5;  ///< of a zone: the inner rectangle, and the transition's four sides

  bool touchesZone(const ImageBox& box) const {
    return boxesOverlap(box, around_) && std::any_of(pieces_.begin(), pieces_.end(), [&](const GpcPiece& piece) {
             return boxesOverlap(box, piece.outerBox);
           });
  }

  /// Where the sample of a pixel lies in the pinhole's image, and how far a step of a pixel leads there.
  struct PixelSample {
    float u = 0;
    float v = 0;
    float spacing = 0;  ///< 0 for pixels out of transitions
  };

  static constexpr int kTile = 16;

  /// What the samples of a tile's pixels lie in.
  struct TileBounds {
    ImageBox box{glm::vec2(1e30f), glm::vec2(-1e30f)};
    float spacing = 0;
  };

  /// A triangle as the pinhole sees it: from its first corner, and how far from each edge a pixel belongs to it.
  struct TransitionTriangle {
    const RasterVertex& a;
    const RasterVertex& b;
    const RasterVertex& c;
    glm::dvec2 pa;
    glm::dvec2 ab;
    glm::dvec2 ac;
    double perArea;
    glm::dvec3 onEdge;

    /// Whether all of a tile lies outside of one edge.
    bool misses(const TileBounds& tile) const {
      const glm::dvec2 lower = glm::dvec2(tile.box.lower) - pa;
      const glm::dvec2 upper = glm::dvec2(tile.box.upper) - pa;
      const glm::dvec2 forB = glm::dvec2(ac.y, -ac.x) * perArea;
      const glm::dvec2 forC = glm::dvec2(-ab.y, ab.x) * perArea;
      const auto greatest = [&](const glm::dvec2& slope) {
        return std::max(slope.x * lower.x, slope.x * upper.x) + std::max(slope.y * lower.y, slope.y * upper.y);
      };
      const auto spacing = static_cast<double>(tile.spacing);
      return tile.box.lower.x > tile.box.upper.x || 1 + greatest(-forB - forC) < onEdge.x * spacing ||
             greatest(forB) < onEdge.y * spacing || greatest(forC) < onEdge.z * spacing;
    }
  };

  /// A vertex in the image, and in which part of which zone it lies: kParts * zone + part.
  struct Placed {
    glm::vec2 image{0};
    CentreCell cell;
    uint32_t part = kAround;
    float shortSquared = -1;  ///< edges up to this, squared, are straight there
  };

  Placed placed(const glm::vec2& pinhole) const {
    for (size_t i = 0; i < pieces_.size(); ++i) {
      const GpcZone& zone = *pieces_[i].zone;
      const glm::dvec2 d = (glm::dvec2(pinhole) - zone.center()) / zone.half();
      const double f = std::max(std::abs(d.x), std::abs(d.y));
      if (f < zone.profile().outer()) {
        const uint32_t side = std::abs(d.x) >= std::abs(d.y) ? (d.x > 0 ? 1 : 2) : (d.y > 0 ? 3 : 4);
        const bool isInner = f * zone.profile().zoom() <= 1;
        const glm::vec2 image(zone.center() + (glm::dvec2(pinhole) - zone.center()) * zone.magnification(f));
        return {image, CentreCell::at(image.x, image.y), static_cast<uint32_t>(i) * kParts + (isInner ? 0 : side),
                isInner ? kAnyLength : pieces_[i].shortEdges.at(f)};
      }
    }
    return {};
  }
  static bool isShort(const Placed& a, const Placed& b) {
    const glm::vec2 along = a.image - b.image;
    return a.part == b.part && along.x * along.x + along.y * along.y <= std::min(a.shortSquared, b.shortSquared);
  }

  template <class Vertex>
  static ImageBox boxOf(const Vertex& a, const Vertex& b, const Vertex& c) {
    return {{std::min({a.u, b.u, c.u}), std::min({a.v, b.v, c.v})},
            {std::max({a.u, b.u, c.u}), std::max({a.v, b.v, c.v})}};
  }

  void drawPart(VisibilityBuffer& buffer, uint32_t triangle, const RasterVertex& a, const RasterVertex& b,
                const RasterVertex& c) const {
    const ImageBox box = boxOf(a, b, c);
    bool isCovered = false;  // by one zone: nothing of it is around the regions
    bool touches = false;
    for (const GpcPiece& piece : pieces_) {
      if (!boxesOverlap(box, piece.outerBox)) {
        continue;
      }
      touches = true;
      isCovered = isCovered || boxHolds(grownBox(piece.outerBox, -2 * kBoxSlack), box);
      if (boxesOverlap(box, piece.innerBox)) {
        drawInner(buffer, triangle, piece, a, b, c);
      }
      if (!boxHolds(grownBox(piece.innerBox, -2 * kBoxSlack), box)) {
        drawTransition(buffer, triangle, piece, box, a, b, c);
      }
    }
    if (!touches) {
      buffer.draw(triangle, a, b, c);
    } else if (!isCovered) {
      drawAround(buffer, triangle, box, a, b, c);
    }
  }

  /// As the pinhole draws it, in pixels of no zone.
  void drawAround(VisibilityBuffer& buffer, uint32_t triangle, const ImageBox& box, const RasterVertex& a,
                  const RasterVertex& b, const RasterVertex& c) const {
    scanTriangle(width_, height_, a, b, c, [&](size_t pixel, float z, const PixelWeights& weights) {
      const int x = static_cast<int>(pixel % static_cast<size_t>(width_));
      const int y = static_cast<int>(pixel / static_cast<size_t>(width_));
      for (const GpcPiece& piece : pieces_) {
        if (piece.isOuter(x, y) && boxesOverlap(box, piece.outerBox)) {
          return;
        }
      }
      buffer.offer(pixel, z, triangle, weights);
    });
  }

  void drawInner(VisibilityBuffer& buffer, uint32_t triangle, const GpcPiece& piece, const RasterVertex& a,
                 const RasterVertex& b, const RasterVertex& c) const {
    const auto zoomed = [&](const RasterVertex& v) {
      return RasterVertex{v.u * piece.zoom + piece.shift.x, v.v * piece.zoom + piece.shift.y, v.inverseZ, v.b1, v.b2};
    };
    scanTriangle(
        width_, piece.inner, zoomed(a), zoomed(b), zoomed(c),
        [&](size_t pixel, float z, const PixelWeights& weights) { buffer.offer(pixel, z, triangle, weights); });
  }

  /// Edge functions where the samples of the pixels lie in the pinhole's image.
  void drawTransition(VisibilityBuffer& buffer, uint32_t triangle, const GpcPiece& piece, const ImageBox& box,
                      const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) const {
    const ImageBox within{glm::max(box.lower, piece.outerBox.lower), glm::min(box.upper, piece.outerBox.upper)};
    const ImageBox image = grownBox(piece.zone->imageBox(within), kBoxSlack);
    const int x0 = std::max(static_cast<int>(std::ceil(image.lower.x - 0.5f)), piece.outer.x0);
    const int y0 = std::max(static_cast<int>(std::ceil(image.lower.y - 0.5f)), piece.outer.y0);
    const int x1 = std::min(static_cast<int>(std::floor(image.upper.x - 0.5f)), piece.outer.x1 - 1);
    const int y1 = std::min(static_cast<int>(std::floor(image.upper.y - 0.5f)), piece.outer.y1 - 1);
    if (x0 > x1 || y0 > y1) {
      return;
    }
    const glm::dvec2 pa(a.u, a.v);
    const glm::dvec2 ab = glm::dvec2(b.u, b.v) - pa;
    const glm::dvec2 ac = glm::dvec2(c.u, c.v) - pa;
    const double area = ab.x * ac.y - ab.y * ac.x;
    if (area == 0) {
      return;
    }
    // Triangles that share an edge evaluate it at the same places. Only one that is straight for a small neighbour may
    // lie a chord beside: pixels so near to it belong to both.
    const double perArea = 1 / area;
    const Placed placedA = placed({a.u, a.v});
    const Placed placedB = placed({b.u, b.v});
    const Placed placedC = placed({c.u, c.v});
    constexpr double kRounding = 1e-6;
    const auto outside = [&](const Placed& from, const Placed& to, const glm::dvec2& along) {
      return -std::abs(perArea) * glm::length(along) * (isShort(from, to) ? kChordPixels : kRounding);
    };
    const glm::dvec3 onEdge(outside(placedB, placedC, ac - ab), outside(placedC, placedA, ac),
                            outside(placedA, placedB, ab));
    const TransitionTriangle part{a, b, c, pa, ab, ac, perArea, onEdge};
    if (x1 - x0 < kTile && y1 - y0 < kTile) {
      drawPixels(buffer, triangle, piece, part, {x0, y0, x1 + 1, y1 + 1});
      return;
    }
    // The boxes of large triangles hold much that they do not: those tiles are left out.
    for (int row = y0 / kTile; row <= y1 / kTile; ++row) {
      for (int column = x0 / kTile; column <= x1 / kTile; ++column) {
        if (!part.misses(tiles_(column, row))) {
          drawPixels(buffer, triangle, piece, part,
                     {std::max(x0, column * kTile), std::max(y0, row * kTile),
                      std::min(x1, column * kTile + kTile - 1) + 1, std::min(y1, row * kTile + kTile - 1) + 1});
        }
      }
    }
  }

  void drawPixels(VisibilityBuffer& buffer, uint32_t triangle, const GpcPiece& piece, const TransitionTriangle& part,
                  const PixelBounds& pixels) const {
    const auto& [a, b, c, pa, ab, ac, perArea, onEdge] = part;
    for (int y = pixels.y0; y < pixels.y1; ++y) {
      for (int x = pixels.x0; x < pixels.x1; ++x) {
        if (piece.isInner(x, y)) {
          x = piece.inner.x1 - 1;
          continue;
        }
        const PixelSample& sample = samples_(x, y);
        const double px = static_cast<double>(sample.u) - pa.x;
        const double py = static_cast<double>(sample.v) - pa.y;
        const double shareB = (px * ac.y - py * ac.x) * perArea;
        const double shareC = (ab.x * py - ab.y * px) * perArea;
        const double shareA = 1 - shareB - shareC;
        const auto spacing = static_cast<double>(sample.spacing);
        if (shareA < onEdge.x * spacing || shareB < onEdge.y * spacing || shareC < onEdge.z * spacing) {
          continue;
        }
        const glm::dvec3 shares = glm::max(glm::dvec3(shareA, shareB, shareC), 0.0);
        const PixelWeights weights(a, b, c, glm::vec3(shares / (shares.x + shares.y + shares.z)), false);
        buffer.offer(samples_.index(x, y), weights.z(), triangle, weights);
      }
    }
  }

  /// Where the samples of a zone's pixels lie.
  void placeSamples(const GpcPiece& piece) {
    parallelFor(static_cast<size_t>(std::max(piece.outer.y1 - piece.outer.y0, 0)), 8, [&](size_t begin, size_t end) {
      for (size_t row = begin; row < end; ++row) {
        const int y = piece.outer.y0 + static_cast<int>(row);
        for (int x = piece.outer.x0; x < piece.outer.x1; ++x) {
          if (piece.isInner(x, y)) {
            x = piece.inner.x1 - 1;
            continue;
          }
          const glm::dvec2 pixel = glm::dvec2(x, y) + 0.5;
          const GpcProfile& profile = piece.zone->profile();
          const double r = piece.zone->distance(pixel);
          const double scale = profile.sampled(r) / r;
          const glm::vec2 at(piece.zone->center() + (pixel - piece.zone->center()) * scale);
          samples_(x, y) = {at.x, at.y, static_cast<float>(std::max(profile.slope(r), scale))};
        }
      }
    });
  }

  void boundTiles() {
    parallelFor(static_cast<size_t>(tiles_.height()), 1, [&](size_t begin, size_t end) {
      for (int y = static_cast<int>(begin) * kTile; y < std::min(static_cast<int>(end) * kTile, height_); ++y) {
        for (int x = 0; x < width_; ++x) {
          const PixelSample& sample = samples_(x, y);
          if (sample.spacing > 0) {
            TileBounds& tile = tiles_(x / kTile, y / kTile);
            tile.box = {glm::min(tile.box.lower, glm::vec2(sample.u, sample.v)),
                        glm::max(tile.box.upper, glm::vec2(sample.u, sample.v))};
            tile.spacing = std::max(tile.spacing, sample.spacing);
          }
        }
      }
    });
  }

  const ProjectedMesh& projected_;
  PinholeTriangles triangles_;
  int width_;
  int height_;
  std::vector<GpcPiece> pieces_;
  std::vector<Placed> placed_;                            ///< the vertices
  Image<PixelSample> samples_;                            ///< of the pixels in transitions
  Image<TileBounds> tiles_;                               ///< of those samples
  ImageBox around_{glm::vec2(1e30f), glm::vec2(-1e30f)};  ///< all zones
};

}  // namespace

FragmentImage rasterizeGpc(const GpcCamera& camera, const ProjectedMesh& projected) {
  const GpcTriangles triangles(camera, projected);
  return drawParallel(camera.width(), camera.height(), projected.mesh().triangles.size(),
                      [&](VisibilityBuffer& buffer, size_t begin, size_t end) {
                        for (size_t i = begin; i < end; ++i) {
                          triangles.draw(buffer, static_cast<uint32_t>(i));
                        }
                      });
}

FragmentImage rasterizeGpc(const GpcCamera& camera, const Mesh& mesh) {
  return rasterizeGpc(camera, ProjectedMesh(camera.reference(), mesh));
}

SubdivisionOptions gpcSubdivision(const GpcCamera& camera) {
  SubdivisionOptions options;
  options.shortestEdgePixels /= std::max(camera.greatestRate(), 1.0f);
  return options;
}

}  // namespace ocelli
