// Rasterisation for cameras that displace the image of a pinhole: triangles are split until they are about a pixel in
// size, and the pieces are filled as if their edges were straight (section 6.1.3).
//
// Whether an edge is split depends on its two end points alone, and its midpoint on nothing else, so triangles that
// share an edge split it alike: no cracks. Triangles are clipped to the pinhole's frustum first, widened by the longest
// displacement.
//
// Where the camera displaces nothing its image is the pinhole's: those pixels are taken from there, and only what lies
// in or reaches into the displaced part of the image is split and drawn. Most pieces lie between pixel centres, and are
// left out by the cells of their corners (projected_mesh.h).
#pragma once

#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/camera/distorted_pinhole.h"
#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/frustum_clip.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/triangle_part.h"

namespace ocelli {

struct SubdivisionOptions {
  /// An edge is split while its image, with or without the displacement, is longer than this, pixels.
  float longestEdgePixels = 1.0f;
  /// No edge shorter than this is split, pixels at its own depth. What is still torn apart then lies across a
  /// discontinuity of the distortion, and is not drawn.
  float shortestEdgePixels = 0.125f;
  float tornEdgePixels = 2.0f;
};

/// Whether the camera may displace a point with an undistorted image in the box.
template <DistortedPinhole C>
bool displacesWithin(const C& camera, const ImageBox& undistorted) {
  if constexpr (requires { camera.displacesWithin(undistorted); }) {
    return camera.displacesWithin(undistorted);
  } else {
    const ImageBox displacement = camera.displacementOver(undistorted, 0, 1 / camera.reference().view().zNear);
    return displacement.lower != glm::vec2(0) || displacement.upper != glm::vec2(0);
  }
}

template <DistortedPinhole C>
class SubdividingRasterizer {
 public:
  SubdividingRasterizer(const C& camera, const SubdivisionOptions& options) : camera_(camera), options_(options) {}

  struct Vertex {
    glm::vec3 p;            ///< in the camera space of the reference pinhole
    glm::vec2 undistorted;  ///< pixels
    RasterVertex image;
    CentreCell cell;  ///< of the image
  };

  Vertex vertex(const glm::vec3& p, float b1, float b2) const {
    const ImagePoint q = camera_.reference().imageFromCamera(p);
    const ImagePoint d = camera_.distort(q);
    return {p, {q.u, q.v}, {d.u, d.v, 1 / q.t, b1, b2}, CentreCell::at(d.u, d.v)};
  }

  /// Draws the part of a scene triangle that the piece abc covers, less what is displaced nowhere.
  void draw(VisibilityBuffer& buffer, uint32_t triangle, const Vertex& a, const Vertex& b, const Vertex& c,
            int depth = 0) const {
    const bool splitAb = mustSplit(a, b);
    const bool splitBc = mustSplit(b, c);
    const bool splitCa = mustSplit(c, a);
    const int splits = splitAb + splitBc + splitCa;
    if (splits == 0 || depth >= kDeepest) {
      if (!CentreCell::missCentres(a.cell, b.cell, c.cell) && !torn(a, b) && !torn(b, c) && !torn(c, a)) {
        buffer.draw(triangle, a.image, b.image, c.image);
      }
      return;
    }
    if (staysPut(a, b, c)) {
      return;
    }
    if (splits == 3) {
      const Vertex ab = midpoint(a, b);
      const Vertex bc = midpoint(b, c);
      const Vertex ca = midpoint(c, a);
      draw(buffer, triangle, a, ab, ca, depth + 1);
      draw(buffer, triangle, ab, b, bc, depth + 1);
      draw(buffer, triangle, ca, bc, c, depth + 1);
      draw(buffer, triangle, ab, bc, ca, depth + 1);
    } else if (splits == 2) {
      // Bend the triangle so that its unsplit edge is ca, cut off the corner b, and cut the rest in two.
      if (!splitAb) {
        drawTwoSplits(buffer, triangle, b, c, a, depth);
      } else if (!splitBc) {
        drawTwoSplits(buffer, triangle, c, a, b, depth);
      } else {
        drawTwoSplits(buffer, triangle, a, b, c, depth);
      }
    } else if (splitAb) {
      drawOneSplit(buffer, triangle, a, b, c, depth);
    } else if (splitBc) {
      drawOneSplit(buffer, triangle, b, c, a, depth);
    } else {
      drawOneSplit(buffer, triangle, c, a, b, depth);
    }
  }

 private:
  static constexpr int kDeepest = 24;  ///< 2^24 pieces along an edge: only guards against numbers gone wrong

  void drawOneSplit(VisibilityBuffer& buffer, uint32_t triangle, const Vertex& a, const Vertex& b, const Vertex& c,
                    int depth) const {
    const Vertex ab = midpoint(a, b);
    draw(buffer, triangle, a, ab, c, depth + 1);
    draw(buffer, triangle, ab, b, c, depth + 1);
  }
  void drawTwoSplits(VisibilityBuffer& buffer, uint32_t triangle, const Vertex& a, const Vertex& b, const Vertex& c,
                     int depth) const {
    const Vertex ab = midpoint(a, b);
    const Vertex bc = midpoint(b, c);
    draw(buffer, triangle, ab, b, bc, depth + 1);
    draw(buffer, triangle, a, ab, bc, depth + 1);
    draw(buffer, triangle, a, bc, c, depth + 1);
  }

  static float squared(const glm::vec2& v) { return v.x * v.x + v.y * v.y; }
  static glm::vec2 image(const Vertex& v) { return {v.image.u, v.image.v}; }

  bool mustSplit(const Vertex& a, const Vertex& b) const {
    const float longest = options_.longestEdgePixels * options_.longestEdgePixels;
    if (squared(a.undistorted - b.undistorted) <= longest && squared(image(a) - image(b)) <= longest) {
      return false;
    }
    const float footprint = std::min(a.p.z, b.p.z) / camera_.reference().focalPixels();
    return glm::distance(a.p, b.p) > options_.shortestEdgePixels * footprint;
  }
  bool torn(const Vertex& a, const Vertex& b) const {
    return squared(image(a) - image(b)) > options_.tornEdgePixels * options_.tornEdgePixels;
  }
  bool staysPut(const Vertex& a, const Vertex& b, const Vertex& c) const {
    return !displacesWithin(camera_, boxAround(a.undistorted, b.undistorted, c.undistorted));
  }
  Vertex midpoint(const Vertex& a, const Vertex& b) const {
    return vertex((a.p + b.p) * 0.5f, (a.image.b1 + b.image.b1) * 0.5f, (a.image.b2 + b.image.b2) * 0.5f);
  }

  const C& camera_;
  SubdivisionOptions options_;
};

/// The triangles with something to draw that the camera may displace.
template <DistortedPinhole C>
TrianglePart displacedPart(const C& camera, std::shared_ptr<const ProjectedMesh> mesh) {
  return selectTriangles(std::move(mesh),
                         [&](const ImageBox& undistorted) { return displacesWithin(camera, undistorted); });
}
template <DistortedPinhole C>
TrianglePart displacedPart(const C& camera, const Mesh& mesh) {
  return displacedPart(camera, std::make_shared<const ProjectedMesh>(camera.reference(), mesh));
}

/// Whether the camera leaves the sample at a pixel centre where the reference pinhole sees it.
template <DistortedPinhole C>
bool keepsPlace(const C& camera, int x, int y, float t) {
  const ImagePoint q{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, t};
  if (!displacesWithin(camera, ImageBox{{q.u, q.v}, {q.u, q.v}})) {
    return true;
  }
  const ImagePoint d = camera.distort(q);
  return d.u == q.u && d.v == q.v;
}

/// A sample of the pinhole's that is not displaced stays where it is, behind nothing but what was drawn nearer.
template <DistortedPinhole C>
void keepUndisplaced(const C& camera, const FragmentImage& seen, FragmentImage& fragments) {
  parallelFor(static_cast<size_t>(seen.height()), 16, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < seen.width(); ++x) {
        const Fragment& sample = seen(x, y);
        Fragment& drawn = fragments(x, y);
        if (sample.covered() && (!drawn.covered() || sample.t < drawn.t) && keepsPlace(camera, x, y, sample.t)) {
          drawn = sample;
        }
      }
    }
  });
}

/// The triangles of a mesh as a camera sees them: their vertices displaced once.
template <DistortedPinhole C>
class DisplacedTriangles {
 public:
  /// All must outlive it.
  DisplacedTriangles(const C& camera, const ProjectedMesh& mesh, const SubdivisionOptions& options)
      : reference_(camera.reference()),
        mesh_(mesh),
        renderer_(camera, options),
        // No edge of a small triangle is split for its undistorted length, or torn, where options are as usual.
        unsplit_(options.longestEdgePixels >= 1 && options.tornEdgePixels >= 1 ? 1.0f : -1.0f),
        margin_(camera.longestDisplacement() + 2),
        upper_(glm::vec2(reference_.width(), reference_.height()) + margin_),
        images_(mesh.mesh().positions.size()) {
    parallelFor(images_.size(), 1 << 12, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const ProjectedVertex& q = mesh.vertex(static_cast<uint32_t>(i));
        if (!isOutside(q)) {
          const ImagePoint d = displacesWithin(camera, ImageBox{{q.u, q.v}, {q.u, q.v}})
                                   ? camera.distort({q.u, q.v, reference_.cameraFromWorld(mesh.mesh().positions[i]).z})
                                   : ImagePoint{q.u, q.v, 0};
          images_[i] = {{d.u, d.v}, CentreCell::at(d.u, d.v)};
        }
      }
    });
  }

  /// `isSmall` as TrianglePart::Block has it.
  void draw(VisibilityBuffer& buffer, uint32_t triangle, bool isSmall) const {
    const glm::uvec3& t = mesh_.mesh().triangles[triangle];
    if (isSmall && drawSmall(buffer, triangle, t)) {
      return;
    }
    if (isOutside(mesh_.vertex(t.x)) || isOutside(mesh_.vertex(t.y)) || isOutside(mesh_.vertex(t.z))) {
      drawClipped(buffer, triangle);
      return;
    }
    renderer_.draw(buffer, triangle, corner(t.x, 0, 0), corner(t.y, 1, 0), corner(t.z, 0, 1));
  }

 private:
  using Rasterizer = SubdividingRasterizer<C>;
  using Vertex = typename Rasterizer::Vertex;

  struct Displaced {
    glm::vec2 image{0};
    CentreCell cell;
  };

  bool isOutside(const ProjectedVertex& q) const {
    return q.inverseZ <= 0 || q.u < -margin_ || q.v < -margin_ || q.u > upper_.x || q.v > upper_.y;
  }
  bool isShort(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) const {
    const auto squared = [](const glm::vec2& v) { return v.x * v.x + v.y * v.y; };
    return squared(a - b) <= unsplit_ && squared(b - c) <= unsplit_ && squared(c - a) <= unsplit_;
  }
  /// Draws a small triangle, unless it has to be split or clipped: most of a dense scene, and of those most cover no
  /// pixel centre.
  bool drawSmall(VisibilityBuffer& buffer, uint32_t triangle, const glm::uvec3& t) const {
    const Displaced& a = images_[t.x];
    const Displaced& b = images_[t.y];
    const Displaced& c = images_[t.z];
    if (!isShort(a.image, b.image, c.image)) {
      return false;
    }
    if (CentreCell::missCentres(a.cell, b.cell, c.cell)) {
      return true;
    }
    const ProjectedVertex& qa = mesh_.vertex(t.x);
    const ProjectedVertex& qb = mesh_.vertex(t.y);
    const ProjectedVertex& qc = mesh_.vertex(t.z);
    if (isOutside(qa) || isOutside(qb) || isOutside(qc)) {
      return false;
    }
    buffer.draw(triangle, {a.image.x, a.image.y, qa.inverseZ, 0, 0}, {b.image.x, b.image.y, qb.inverseZ, 1, 0},
                {c.image.x, c.image.y, qc.inverseZ, 0, 1});
    return true;
  }
  Vertex corner(uint32_t i, float b1, float b2) const {
    const ProjectedVertex& q = mesh_.vertex(i);
    const Displaced& d = images_[i];
    return {reference_.cameraFromWorld(mesh_.mesh().positions[i]),
            {q.u, q.v},
            {d.image.x, d.image.y, q.inverseZ, b1, b2},
            d.cell};
  }
  void drawClipped(VisibilityBuffer& buffer, uint32_t triangle) const {
    const glm::uvec3& t = mesh_.mesh().triangles[triangle];
    const auto point = [&](uint32_t i) { return reference_.cameraFromWorld(mesh_.mesh().positions[i]); };
    const ClipPolygon polygon = clipToFrustum({point(t.x), point(t.y), point(t.z)}, reference_, margin_);
    const auto clipped = [&](size_t k) {
      return renderer_.vertex(polygon.vertices[k].p, polygon.vertices[k].b1, polygon.vertices[k].b2);
    };
    for (size_t k = 2; k < polygon.count; ++k) {
      renderer_.draw(buffer, triangle, clipped(0), clipped(k - 1), clipped(k));
    }
  }

  const PinholeCamera& reference_;
  const ProjectedMesh& mesh_;
  Rasterizer renderer_;
  float unsplit_;  ///< edges up to this, squared, of small triangles are neither split nor torn
  float margin_;
  glm::vec2 upper_;
  std::vector<Displaced> images_;  ///< of vertices that are not outside
};

/// As below, for scenes that are drawn more than once. `seen` is what the reference pinhole sees of the scene, `part`
/// holds at least what displacedPart() gives.
template <DistortedPinhole C>
FragmentImage rasterize(const C& camera, const FragmentImage& seen, const TrianglePart& part,
                        const SubdivisionOptions& options = {}) {
  FragmentImage fragments(camera.width(), camera.height());
  if (!part.blocks.empty()) {
    const DisplacedTriangles<C> triangles(camera, *part.mesh, options);
    constexpr size_t kEach = TrianglePart::kTriangles;
    fragments = drawParallel(
        camera.width(), camera.height(), part.blocks.size() * kEach,
        [&](VisibilityBuffer& buffer, size_t begin, size_t end) {
          for (size_t i = begin / kEach; i < end / kEach; ++i) {
            part.blocks[i].forEach([&](uint32_t triangle, bool isSmall) { triangles.draw(buffer, triangle, isSmall); });
          }
        });
  }
  keepUndisplaced(camera, seen, fragments);
  return fragments;
}

/// The closest fragment at each pixel of `camera`; both sides of triangles are drawn.
template <DistortedPinhole C>
FragmentImage rasterize(const C& camera, const Mesh& mesh, const SubdivisionOptions& options = {}) {
  const auto projected = std::make_shared<const ProjectedMesh>(camera.reference(), mesh);
  return rasterize(camera, rasterize(*projected), displacedPart(camera, projected), options);
}

}  // namespace ocelli
