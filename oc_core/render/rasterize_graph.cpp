#include "oc_core/render/rasterize_graph.h"

#include <array>
#include <cmath>
#include <glm/vec4.hpp>

#include "oc_core/base/finite.h"
#include "oc_core/base/parallel.h"
#include "oc_core/render/draw_parallel.h"

namespace ocelli {
namespace {

constexpr size_t kBlock = 32;  // triangles in a box
/// How far beyond its part of the image a frustum's triangles are kept, pixels: clipping must not move what is inside.
constexpr double kMargin = 2;

/// Half spaces a . (p, 1) >= 0 that hold what a frustum may show.
using HalfSpaces = std::vector<glm::dvec4>;

HalfSpaces halfSpacesOf(const GraphCamera::Frustum& frustum) {
  HalfSpaces spaces{glm::dvec4(frustum.plane.normal, -frustum.plane.distance)};
  const glm::dmat4 worldFromPixel = glm::transpose(frustum.pixelFromWorld);
  for (size_t i = 0; i < frustum.part.size(); ++i) {
    const glm::dvec2 a = frustum.part[i];
    const glm::dvec2 along = glm::normalize(frustum.part[(i + 1) % frustum.part.size()] - a);
    // cross(along, (u, v) - a) + margin >= 0, times the weight of the image point, which is positive beyond the plane.
    const double offset = kMargin - (along.x * a.y - along.y * a.x);
    spaces.push_back(worldFromPixel * glm::dvec4(-along.y, along.x, 0, offset));
  }
  return spaces;
}

/// A corner while a triangle is clipped: its place, and its weights on the triangle.
struct Corner {
  glm::dvec3 p;
  glm::dvec2 b{0};
};
using Polygon = std::vector<Corner>;

void clip(Polygon& polygon, const glm::dvec4& space, Polygon& scratch) {
  scratch.clear();
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double da = glm::dot(space, glm::dvec4(a.p, 1));
    const double db = glm::dot(space, glm::dvec4(b.p, 1));
    if (da >= 0) {
      scratch.push_back(a);
    }
    if ((da >= 0) != (db >= 0)) {
      // From the inner end to the outer one, so that triangles that share an edge cut it alike.
      const Corner& inner = da >= 0 ? a : b;
      const Corner& outer = da >= 0 ? b : a;
      const double t = da >= 0 ? da / (da - db) : db / (db - da);
      scratch.push_back({inner.p + (outer.p - inner.p) * t, inner.b + (outer.b - inner.b) * t});
    }
  }
  polygon.swap(scratch);
}

/// Which frusta the ray of each pixel passes.
class PixelChains {
 public:
  explicit PixelChains(const GraphCamera& camera) : camera_(camera), leaves_(camera.width(), camera.height()) {
    parallelFor(static_cast<size_t>(camera.height()), 8, [&](size_t begin, size_t end) {
      for (size_t row = begin; row < end; ++row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < camera.width(); ++x) {
          int leaf = GraphCamera::kRoot;
          for (int child = leaf; child >= 0; child = camera.childAt(leaf, {x + 0.5, y + 0.5})) {
            leaf = child;
          }
          leaves_(x, y) = leaf;
        }
      }
    });
  }

  /// Whether the ray of a pixel passes frustum `i`, and the frustum it goes on to, -1 for none.
  bool passes(size_t pixel, int i, int& next) const {
    next = -1;
    for (int k = leaves_[pixel]; k >= 0; k = camera_.frusta()[static_cast<size_t>(k)].parent) {
      if (k == i) {
        return true;
      }
      next = k;
    }
    return false;
  }

 private:
  const GraphCamera& camera_;
  Image<int> leaves_;
};

/// The closest sample of one frustum at each pixel.
class FrustumBuffer {
 public:
  explicit FrustumBuffer(size_t pixels) : samples_(pixels) {}

  void offer(size_t pixel, uint64_t key, const glm::vec2& b) {
    if (key < samples_[pixel].key) {
      samples_[pixel] = {key, b.x, b.y};
    }
  }
  void mergePixels(const FrustumBuffer& other, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (other.samples_[i].key < samples_[i].key) {
        samples_[i] = other.samples_[i];
      }
    }
  }
  Fragment fragment(size_t pixel) const { return samples_[pixel].fragment(); }

 private:
  std::vector<KeyedSample> samples_;
};

/// Draws triangles into the image of one frustum.
class FrustumDrawer {
 public:
  FrustumDrawer(const GraphCamera& camera, int frustum, const Mesh& mesh, const PixelChains& chains)
      : camera_(camera),
        frustum_(camera.frusta()[static_cast<size_t>(frustum)]),
        index_(frustum),
        mesh_(mesh),
        chains_(chains),
        spaces_(halfSpacesOf(frustum_)) {}

  bool mayHold(const Box& box) const {
    for (const glm::dvec4& space : spaces_) {
      const glm::dvec3 farthest(space.x > 0 ? box.upper.x : box.lower.x, space.y > 0 ? box.upper.y : box.lower.y,
                                space.z > 0 ? box.upper.z : box.lower.z);
      if (glm::dot(space, glm::dvec4(farthest, 1)) < 0) {
        return false;
      }
    }
    return true;
  }

  /// `triangle` has finite corners.
  void draw(FrustumBuffer& buffer, uint32_t triangle) {
    const glm::uvec3& t = mesh_.triangles[triangle];
    polygon_ = {{glm::dvec3(mesh_.positions[t.x]), {0, 0}},
                {glm::dvec3(mesh_.positions[t.y]), {1, 0}},
                {glm::dvec3(mesh_.positions[t.z]), {0, 1}}};
    for (const glm::dvec4& space : spaces_) {
      if (polygon_.empty()) {
        return;
      }
      clip(polygon_, space, scratch_);
    }
    vertices_.clear();
    for (const Corner& corner : polygon_) {
      const glm::dvec4 h = frustum_.pixelFromWorld * glm::dvec4(corner.p, 1);
      vertices_.push_back({static_cast<float>(h.x / h.w), static_cast<float>(h.y / h.w), static_cast<float>(1 / h.w),
                           static_cast<float>(corner.b.x), static_cast<float>(corner.b.y)});
    }
    for (size_t i = 2; i < vertices_.size(); ++i) {
      fill(buffer, triangle, vertices_[0], vertices_[i - 1], vertices_[i]);
    }
  }

 private:
  void fill(FrustumBuffer& buffer, uint32_t triangle, const RasterVertex& a, const RasterVertex& b,
            const RasterVertex& c) {
    scanTriangle(camera_.width(), camera_.height(), a, b, c, [&](size_t pixel, float weight, const auto& weights) {
      int next = -1;
      if (!chains_.passes(pixel, index_, next)) {
        return;
      }
      const glm::vec2 on = weights();
      if (next >= 0 || !frustum_.limits.empty()) {
        const glm::dvec3 point(positionOf({weight, triangle, on.x, on.y}, mesh_));
        const bool beyond = next >= 0 ? camera_.frusta()[static_cast<size_t>(next)].plane.height(point) > 0
                                      : camera_.isBeyondLimits(index_, point);
        if (beyond) {
          return;  // another frustum shows it, or none
        }
      }
      buffer.offer(pixel, KeyedSample::keyOf(weight, triangle), on);
    });
  }

  const GraphCamera& camera_;
  const GraphCamera::Frustum& frustum_;
  int index_;
  const Mesh& mesh_;
  const PixelChains& chains_;
  HalfSpaces spaces_;
  Polygon polygon_;
  Polygon scratch_;
  std::vector<RasterVertex> vertices_;
};

bool hasFiniteCorners(const Mesh& mesh, size_t triangle) {
  for (int k = 0; k < 3; ++k) {
    if (!isFinite(mesh.positions[mesh.triangles[triangle][k]])) {
      return false;
    }
  }
  return true;
}

/// Boxes around blocks of neighbouring triangles, those with a corner that is not finite left out.
std::vector<Box> blockBoxes(const Mesh& mesh) {
  std::vector<Box> boxes((mesh.triangles.size() + kBlock - 1) / kBlock);
  parallelFor(boxes.size(), 64, [&](size_t begin, size_t end) {
    for (size_t block = begin; block < end; ++block) {
      for (size_t i = block * kBlock; i < std::min((block + 1) * kBlock, mesh.triangles.size()); ++i) {
        if (!hasFiniteCorners(mesh, i)) {
          continue;
        }
        for (int k = 0; k < 3; ++k) {
          boxes[block].add(mesh.positions[mesh.triangles[i][k]]);
        }
      }
    }
  });
  return boxes;
}

}  // namespace

FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh) {
  const auto pixels = static_cast<size_t>(camera.width()) * static_cast<size_t>(camera.height());
  const PixelChains chains(camera);
  const std::vector<Box> boxes = blockBoxes(mesh);
  FragmentImage fragments(camera.width(), camera.height());
  // Children come after their parents, so what is there already is nearer.
  for (int i = 0; i < static_cast<int>(camera.frusta().size()); ++i) {
    const FrustumDrawer frustum(camera, i, mesh, chains);
    std::vector<uint32_t> blocks;
    for (size_t block = 0; block < boxes.size(); ++block) {
      if (!boxes[block].empty() && frustum.mayHold(boxes[block])) {
        blocks.push_back(static_cast<uint32_t>(block));
      }
    }
    if (blocks.empty()) {
      continue;
    }
    const auto draw = [&](FrustumBuffer& buffer, size_t begin, size_t end) {
      FrustumDrawer drawer = frustum;
      for (size_t k = begin; k < end; ++k) {
        const size_t block = blocks[k / kBlock];
        const size_t triangle = block * kBlock + k % kBlock;
        if (triangle < mesh.triangles.size() && hasFiniteCorners(mesh, triangle)) {
          drawer.draw(buffer, static_cast<uint32_t>(triangle));
        }
      }
    };
    const FrustumBuffer drawn = drawOnBuffers(
        pixels, pixels, blocks.size() * kBlock, [&] { return FrustumBuffer(pixels); }, draw);
    parallelFor(pixels, 1 << 12, [&](size_t begin, size_t end) {
      for (size_t pixel = begin; pixel < end; ++pixel) {
        Fragment fragment = drawn.fragment(pixel);
        if (fragment.covered() && !fragments[pixel].covered()) {
          const double z = camera.depth(i, glm::dvec3(positionOf(fragment, mesh)));
          if (z <= static_cast<double>(camera.root().view().zFar)) {
            fragment.z = static_cast<float>(z);
            fragments[pixel] = fragment;
          }
        }
      }
    });
  }
  return fragments;
}

}  // namespace ocelli
