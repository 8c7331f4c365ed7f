#include "oc_core/ocri/image_mesh.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

constexpr uint32_t kNoVertex = 0xffffffffu;

class ImageMesher {
 public:
  ImageMesher(const ReferenceImage& image, const ImageMeshOptions& options)
      : image_(image), options_(options), camera_(image.reference()), vertexOf_(image.width(), image.height(), kNoVertex) {}

  Mesh mesh() {
    addVertices();
    joinNeighbours();
    addSquares();
    return std::move(mesh_);
  }

 private:
  struct Pixel {
    int x, y;
  };

  bool valid(const Pixel& p) const { return image_.z.contains(p.x, p.y) && image_.z(p.x, p.y) > 0; }

  void addVertices() {
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) {
        if (const auto point = camera_.unproject(image_.undistorted(x, y))) {
          vertexOf_(x, y) = static_cast<uint32_t>(mesh_.positions.size());
          mesh_.positions.push_back(*point);
          mesh_.colors.push_back(image_.color(x, y));
        }
      }
    }
    trianglesOfVertex_.resize(mesh_.positions.size());
  }

  /// The step of 1/z from p to q for each pixel of undistorted distance.
  float slope(const Pixel& p, const Pixel& q) const {
    const ImagePoint a = image_.undistorted(p.x, p.y);
    const ImagePoint b = image_.undistorted(q.x, q.y);
    const float distance = std::max(glm::distance(glm::vec2(a.u, a.v), glm::vec2(b.u, b.v)), 0.1f);
    return (1 / b.z - 1 / a.z) / distance;
  }

  bool joined(const Pixel& p, const Pixel& q) const {
    if (!valid(p) || !valid(q)) {
      return false;
    }
    const ImagePoint a = image_.undistorted(p.x, p.y);
    const ImagePoint b = image_.undistorted(q.x, q.y);
    const float distance = glm::distance(glm::vec2(a.u, a.v), glm::vec2(b.u, b.v));
    if (distance > options_.longestStepPixels) {
      return false;
    }
    const float footprint = std::min(a.z, b.z) / camera_.focalPixels();
    const float depthStep = std::abs(a.z - b.z);
    if (depthStep <= options_.depthStepFootprints * footprint * std::max(distance, 1.0f)) {
      return true;
    }
    // A grazing surface: large steps of z, but an even slope of 1/z.
    const float tolerance = options_.slopeToleranceFootprints * footprint / (a.z * b.z);
    const Pixel before{2 * p.x - q.x, 2 * p.y - q.y};
    const Pixel after{2 * q.x - p.x, 2 * q.y - p.y};
    const float here = slope(p, q);
    return (valid(before) && std::abs(here - slope(before, p)) <= tolerance) ||
           (valid(after) && std::abs(here - slope(q, after)) <= tolerance);
  }

  void addTriangle(const Pixel& a, const Pixel& b, const Pixel& c) {
    const glm::uvec3 t(vertexOf_(a.x, a.y), vertexOf_(b.x, b.y), vertexOf_(c.x, c.y));
    mesh_.triangles.push_back(t);
    for (int i = 0; i < 3; ++i) {
      ++trianglesOfVertex_[t[i]];
    }
  }

  /// Each cell between four samples gives two triangles, one, or none.
  void joinNeighbours() {
    for (int y = 0; y + 1 < image_.height(); ++y) {
      for (int x = 0; x + 1 < image_.width(); ++x) {
        const Pixel a{x, y};
        const Pixel b{x, y + 1};
        const Pixel c{x + 1, y + 1};
        const Pixel d{x + 1, y};
        const bool ab = joined(a, b);
        const bool bc = joined(b, c);
        const bool cd = joined(c, d);
        const bool da = joined(d, a);
        if (ab + bc + cd + da < 2) {
          continue;
        }
        const bool ac = joined(a, c);
        const bool bd = joined(b, d);
        const int alongAc = ac ? (ab && bc) + (cd && da) : 0;
        const int alongBd = bd ? (bc && cd) + (da && ab) : 0;
        if (alongAc == 0 && alongBd == 0) {
          continue;
        }
        if (alongAc > alongBd || (alongAc == alongBd && shorterAc(a, b, c, d))) {
          if (ab && bc) {
            addTriangle(a, b, c);
          }
          if (cd && da) {
            addTriangle(a, c, d);
          }
        } else {
          if (bc && cd) {
            addTriangle(b, c, d);
          }
          if (da && ab) {
            addTriangle(b, d, a);
          }
        }
      }
    }
  }

  bool shorterAc(const Pixel& a, const Pixel& b, const Pixel& c, const Pixel& d) const {
    const auto inverse = [&](const Pixel& p) { return 1 / image_.z(p.x, p.y); };
    return std::abs(inverse(a) - inverse(c)) <= std::abs(inverse(b) - inverse(d));
  }

  void addSquares() {
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) {
        const uint32_t vertex = vertexOf_(x, y);
        if (vertex == kNoVertex || trianglesOfVertex_[vertex] >= options_.leastTriangles) {
          continue;
        }
        const ImagePoint q = image_.undistorted(x, y);
        const auto corner = static_cast<uint32_t>(mesh_.positions.size());
        constexpr std::array<glm::vec2, 4> kCorners{
            glm::vec2(-0.5f, -0.5f), glm::vec2(-0.5f, 0.5f), glm::vec2(0.5f, 0.5f), glm::vec2(0.5f, -0.5f)};
        for (const glm::vec2& offset : kCorners) {
          mesh_.positions.push_back(
              camera_.worldFromCamera(camera_.cameraFromImage({q.u + offset.x, q.v + offset.y, q.z})));
          mesh_.colors.push_back(image_.color(x, y));
        }
        mesh_.triangles.emplace_back(corner, corner + 1, corner + 2);
        mesh_.triangles.emplace_back(corner, corner + 2, corner + 3);
      }
    }
  }

  const ReferenceImage& image_;
  const ImageMeshOptions& options_;
  PinholeCamera camera_;
  Image<uint32_t> vertexOf_;
  std::vector<int> trianglesOfVertex_;
  Mesh mesh_;
};

}  // namespace

Mesh imageMesh(const ReferenceImage& image, const ImageMeshOptions& options) { return ImageMesher(image, options).mesh(); }

}  // namespace ocelli
