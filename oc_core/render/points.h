// Point-based rendering (section 6.1.2): the scene as samples of its surfaces, each projected by the camera and
// splatted onto the pixels around its image point. Connectivity is used to place samples, not to fill between them.
//
// Vertices are samples. A triangle whose image is larger than the spacing of the splats gets more: it is halved until
// no point of the surface is farther from a sample than a splat reaches. So the image has no holes except where the
// camera itself tears it.
#pragma once

#include <functional>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/render/depth_keys.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/image_footprint.h"

namespace ocelli {

struct PointOptions {
  /// Side of a splat, a square; pixels whose centres it holds get the sample.
  float splatPixels = 1;
  /// No edge shorter than this is halved, pixels at its own depth: where the image of an edge stays long however short
  /// it is, the camera tears it.
  float shortestEdgePixels = 1.0f / 64;
};

/// Gives each triangle's samples, in an order that depends on nothing else. Camera and mesh must outlive it.
template <BoundedCamera C>
class PointSampler {
 public:
  PointSampler(const C& camera, const Mesh& mesh, const PointOptions& options)
      : camera_(camera),
        mesh_(mesh),
        options_(options),
        // Where all edges are this long or shorter, no point of a triangle is farther than half a splat from a vertex:
        // the longest edge over sqrt(3) is the most.
        spacing_(options.splatPixels / 2 * 1.732f),
        images_(mesh.positions.size()),
        firstTriangle_(mesh.positions.size(), Fragment::kNoTriangle) {
    parallelFor(images_.size(), 1 << 12, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        images_[i] = camera_.project(mesh_.positions[i]);
      }
    });
    for (size_t i = mesh.triangles.size(); i-- > 0;) {
      for (int corner = 0; corner < 3; ++corner) {
        firstTriangle_[mesh.triangles[i][corner]] = static_cast<uint32_t>(i);
      }
    }
  }

  /// Calls `emit(imagePoint, b1, b2)` for the samples of a triangle. A vertex belongs to the first triangle it is in.
  template <class Emit>
  void sample(uint32_t triangle, const Emit& emit) const {
    const glm::uvec3& t = mesh_.triangles[triangle];
    const Corners corners{mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z]};
    for (int i = 0; i < 3; ++i) {
      if (const std::optional<ImagePoint>& image = images_[t[i]]; image && firstTriangle_[t[i]] == triangle) {
        emit(*image, i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f);
      }
    }
    const PinholeCamera& reference = referenceOf(camera_);
    const ClipPolygon polygon =
        partInView({reference.cameraFromWorld(corners[0]), reference.cameraFromWorld(corners[1]),
                    reference.cameraFromWorld(corners[2])},
                   reference, clipMargin(camera_));
    const auto corner = [&](size_t i) { return sampleAt(corners, polygon.vertices[i].b1, polygon.vertices[i].b2); };
    for (size_t i = 2; i < polygon.count; ++i) {
      split(corners, corner(0), corner(i - 1), corner(i), emit);
    }
  }

 private:
  using Corners = std::array<glm::vec3, 3>;

  struct Sample {
    glm::vec3 p;  ///< in the camera space of the reference pinhole
    float b1 = 0;
    float b2 = 0;
    std::optional<ImagePoint> image;
  };

  Sample sampleAt(const Corners& corners, float b1, float b2) const {
    const glm::vec3 p = corners[0] * (1 - b1 - b2) + corners[1] * b1 + corners[2] * b2;
    return {referenceOf(camera_).cameraFromWorld(p), b1, b2, camera_.project(p)};
  }

  /// Whether the image of an edge is longer than the spacing, and the edge is worth halving. The image of an edge with
  /// an end that has none counts as long.
  bool tooLong(const Sample& a, const Sample& b) const {
    if (a.image && b.image &&
        glm::distance(glm::vec2(a.image->u, a.image->v), glm::vec2(b.image->u, b.image->v)) <= spacing_) {
      return false;
    }
    const PinholeCamera& reference = referenceOf(camera_);
    const float footprint = std::max(std::min(a.p.z, b.p.z), reference.view().zNear) / reference.focalPixels();
    return glm::distance(a.p, b.p) > options_.shortestEdgePixels * footprint;
  }
  /// For the choice of the edge to halve. Depth counts less: it is hardly seen. Halving the longest edge in a fixed
  /// space comes to an end; halving the longest image may go on for ever where the camera folds it.
  static float length(const Sample& a, const Sample& b) {
    constexpr float kDepthWeight = 0.25f;
    const glm::vec3 d = b.p - a.p;
    return glm::length(glm::vec3(d.x, d.y, d.z * kDepthWeight));
  }

  template <class Emit>
  void split(const Corners& corners, const Sample& a, const Sample& b, const Sample& c, const Emit& emit) const {
    if (!tooLong(a, b) && !tooLong(b, c) && !tooLong(c, a)) {
      return;
    }
    const float ab = length(a, b);
    const float bc = length(b, c);
    const float ca = length(c, a);
    if (ab >= bc && ab >= ca) {
      halve(corners, a, b, c, emit);
    } else if (bc >= ca) {
      halve(corners, b, c, a, emit);
    } else {
      halve(corners, c, a, b, emit);
    }
  }
  template <class Emit>
  void halve(const Corners& corners, const Sample& a, const Sample& b, const Sample& c, const Emit& emit) const {
    const Sample middle = sampleAt(corners, (a.b1 + b.b1) / 2, (a.b2 + b.b2) / 2);
    if (middle.image) {
      emit(*middle.image, middle.b1, middle.b2);
    }
    split(corners, a, middle, c, emit);
    split(corners, middle, b, c, emit);
  }

  const C& camera_;
  const Mesh& mesh_;
  PointOptions options_;
  float spacing_;
  std::vector<std::optional<ImagePoint>> images_;
  std::vector<uint32_t> firstTriangle_;  ///< of each vertex
};

/// The closest sample at each pixel; the lower triangle index on a tie. `z`, `b1` and `b2` of a fragment are those of
/// the sample, whose image point may be half a splat from the centre of the pixel.
template <BoundedCamera C>
FragmentImage renderPoints(const C& camera, const Mesh& mesh, const PointOptions& options = {}) {
  const PointSampler<C> sampler(camera, mesh, options);
  FragmentImage fragments(camera.width(), camera.height());
  const auto forPixels = [&](const ImagePoint& q, const auto& visit) {
    const auto first = [&](float centre) {
      return static_cast<int>(std::max(std::ceil(centre - options.splatPixels / 2 - 0.5f), 0.0f));
    };
    const auto last = [&](float centre, int count) {  // a splat holds its left and upper border only
      return static_cast<int>(
          std::min(std::ceil(centre + options.splatPixels / 2 - 0.5f) - 1, static_cast<float>(count - 1)));
    };
    const int x1 = last(q.u, fragments.width());
    const int y1 = last(q.v, fragments.height());
    for (int y = first(q.v); y <= y1; ++y) {
      for (int x = first(q.u); x <= x1; ++x) {
        visit(fragments.index(x, y));
      }
    }
  };
  DepthKeys keys(fragments.size());
  const auto forTriangles = [&](const auto& visit) {
    parallelFor(mesh.triangles.size(), 64, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        visit(static_cast<uint32_t>(i));
      }
    });
  };
  forTriangles([&](uint32_t triangle) {
    sampler.sample(triangle, [&](const ImagePoint& q, float, float) {
      forPixels(q, [&](size_t pixel) { keys.offer(pixel, DepthKeys::key(q.t, triangle)); });
    });
  });
  // Once more for the triangles that can be seen: which of their samples it was, the first where several are as far.
  std::vector<char> seen(mesh.triangles.size(), 0);
  for (size_t i = 0; i < keys.size(); ++i) {
    if (keys.covered(i)) {
      seen[keys.triangle(i)] = 1;
    }
  }
  forTriangles([&](uint32_t triangle) {
    if (!seen[triangle]) {
      return;
    }
    sampler.sample(triangle, [&](const ImagePoint& q, float b1, float b2) {
      forPixels(q, [&](size_t pixel) {
        if (keys.holds(pixel, DepthKeys::key(q.t, triangle)) && !fragments[pixel].covered()) {
          fragments[pixel] = {q.t, triangle, b1, b2};
        }
      });
    });
  });
  return fragments;
}

}  // namespace ocelli
