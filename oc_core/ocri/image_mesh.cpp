#include "oc_core/ocri/image_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace ocelli {
namespace {

/// Neighbours farther apart than this get no more tolerance of depth for it: a longer join is more likely to be a skin
/// across a gap.
constexpr float kLongestScaledStep = 1.5f;
constexpr uint32_t kNoVertex = 0xffffffffu;

class ImageMesher {
 public:
  ImageMesher(const ReferenceImage& image, const ImageMeshOptions& options)
      : image_(image),
        options_(options),
        camera_(image.reference()),
        vertexOf_(image.width(), image.height(), kNoVertex),
        cellTriangles_(image.width(), image.height()) {}

  Mesh mesh(std::vector<uint32_t>* pixelOfVertex) {
    addVertices();
    joinNeighbours();
    addSquares();
    if (pixelOfVertex != nullptr) {
      *pixelOfVertex = std::move(pixelOfVertex_);
    }
    return std::move(mesh_);
  }

 private:
  struct Pixel {
    int x, y;
  };

  bool valid(const Pixel& p) const { return vertexOf_.contains(p.x, p.y) && vertexOf_(p.x, p.y) != kNoVertex; }

  void addVertices() {
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) {
        if (const auto point = camera_.unproject(image_.undistorted(x, y))) {
          vertexOf_(x, y) = static_cast<uint32_t>(mesh_.positions.size());
          mesh_.positions.push_back(*point);
          mesh_.colors.push_back(image_.color(x, y));
          pixelOfVertex_.push_back(static_cast<uint32_t>(image_.z.index(x, y)));
        }
      }
    }
  }

  /// Whether nothing says that the two have nothing to do with each other.
  bool sameTile(const Pixel& p, const Pixel& q) const {
    const int firstRow = image_.pinholeSize.y;
    if (image_.tileSide <= 0 || (p.y < firstRow && q.y < firstRow)) {
      return true;
    }
    return p.y >= firstRow && q.y >= firstRow && p.x / image_.tileSide == q.x / image_.tileSide &&
           (p.y - firstRow) / image_.tileSide == (q.y - firstRow) / image_.tileSide;
  }

  bool inTile(const Pixel& p) const { return image_.tileSide > 0 && p.y >= image_.pinholeSize.y; }
  /// Pixels of the pinhole from a sample to the next.
  float spacing(const Pixel& p) const { return inTile(p) ? image_.tileSpacing : 1; }

  /// The step of 1/z from p to q for each pixel of undistorted distance.
  float slope(const Pixel& p, const Pixel& q) const {
    const ImagePoint a = image_.undistorted(p.x, p.y);
    const ImagePoint b = image_.undistorted(q.x, q.y);
    const float distance = std::max(glm::distance(glm::vec2(a.u, a.v), glm::vec2(b.u, b.v)), 0.1f);
    return (1 / b.z - 1 / a.z) / distance;
  }

  bool joined(const Pixel& p, const Pixel& q) const {
    if (!valid(p) || !valid(q) || !sameTile(p, q)) {
      return false;
    }
    const ImagePoint a = image_.undistorted(p.x, p.y);
    const ImagePoint b = image_.undistorted(q.x, q.y);
    const float distance = glm::distance(glm::vec2(a.u, a.v), glm::vec2(b.u, b.v));
    if (distance > options_.longestStepPixels) {
      return false;
    }
    const float footprint = std::min(a.z, b.z) / camera_.focalPixels() * spacing(p);
    if (std::abs(a.z - b.z) <=
        options_.depthStepFootprints * footprint * std::clamp(distance / spacing(p), 1.0f, kLongestScaledStep)) {
      return true;
    }
    // A grazing or a stretched surface: large steps of z, but 1/z goes on as on one of the two sides.
    const float tolerance = options_.slopeToleranceFootprints * footprint / (a.z * b.z);
    const Pixel before{2 * p.x - q.x, 2 * p.y - q.y};
    const Pixel after{2 * q.x - p.x, 2 * q.y - p.y};
    const float step = 1 / b.z - 1 / a.z;
    return (valid(before) && std::abs(step - slope(before, p) * distance) <= tolerance) ||
           (valid(after) && std::abs(step - slope(q, after) * distance) <= tolerance);
  }

  void addTriangle(const Pixel& cell, const Pixel& a, const Pixel& b, const Pixel& c) {
    mesh_.triangles.emplace_back(vertexOf_(a.x, a.y), vertexOf_(b.x, b.y), vertexOf_(c.x, c.y));
    ++cellTriangles_(cell.x, cell.y);
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
            addTriangle(a, a, b, c);
          }
          if (cd && da) {
            addTriangle(a, a, c, d);
          }
        } else {
          if (bc && cd) {
            addTriangle(a, b, c, d);
          }
          if (da && ab) {
            addTriangle(a, b, d, a);
          }
        }
      }
    }
  }

  bool shorterAc(const Pixel& a, const Pixel& b, const Pixel& c, const Pixel& d) const {
    const auto inverse = [&](const Pixel& p) { return 1 / image_.z(p.x, p.y); };
    return std::abs(inverse(a) - inverse(c)) <= std::abs(inverse(b) - inverse(d));
  }

  /// The change of 1/z for a pixel to the right and a pixel down in the undistorted image, from the joined neighbours.
  glm::vec2 gradient(const Pixel& p) const {
    glm::vec2 rhs(0);
    float xx = 1e-3f;
    float xy = 0;
    float yy = 1e-3f;
    const ImagePoint a = image_.undistorted(p.x, p.y);
    for (const Pixel& step : {Pixel{1, 0}, Pixel{-1, 0}, Pixel{0, 1}, Pixel{0, -1}}) {
      const Pixel q{p.x + step.x, p.y + step.y};
      if (joined(p, q)) {
        const ImagePoint b = image_.undistorted(q.x, q.y);
        const glm::vec2 d(b.u - a.u, b.v - a.v);
        rhs += d * (1 / b.z - 1 / a.z);
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
      }
    }
    const float determinant = xx * yy - xy * xy;
    return glm::vec2(yy * rhs.x - xy * rhs.y, xx * rhs.y - xy * rhs.x) / determinant;
  }

  int trianglesAround(int x, int y) const {
    const auto triangles = [&](int cx, int cy) { return cellTriangles_.contains(cx, cy) ? cellTriangles_(cx, cy) : 0; };
    return triangles(x - 1, y - 1) + triangles(x, y - 1) + triangles(x - 1, y) + triangles(x, y);
  }

  /// Six of the eight triangles around a sample leave no opening that matters; with fewer, its surface ends here.
  void addSquares() {
    constexpr size_t kClosed = 6;
    std::array<std::vector<Pixel>, kClosed> rims;  // by the number of triangles around: the most open first
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) {
        const auto around = static_cast<size_t>(trianglesAround(x, y));
        if (vertexOf_(x, y) != kNoVertex && around < rims.size()) {
          rims[around].push_back({x, y});
        }
      }
    }
    const size_t bound = image_.triangleBound > 0 ? image_.triangleBound : std::numeric_limits<size_t>::max();
    for (const std::vector<Pixel>& rim : rims) {
      for (const Pixel& p : rim) {
        if (mesh_.triangles.size() + 2 <= bound) {
          addSquare(p);
        }
      }
    }
  }

  void addSquare(const Pixel& p) {
    const auto corner = static_cast<uint32_t>(mesh_.positions.size());
    for (const glm::vec2& side : {glm::vec2(-1, -1), glm::vec2(-1, 1), glm::vec2(1, 1), glm::vec2(1, -1)}) {
      mesh_.positions.push_back(inTile(p) ? tileCorner(p, side) : pinholeCorner(p, side));
      mesh_.colors.push_back(image_.color(p.x, p.y));
      pixelOfVertex_.push_back(static_cast<uint32_t>(image_.z.index(p.x, p.y)));
    }
    mesh_.triangles.emplace_back(corner, corner + 1, corner + 2);
    mesh_.triangles.emplace_back(corner, corner + 2, corner + 3);
  }

  /// Half a pixel away from the sample in the pinhole's image, on the plane of the surface.
  glm::vec3 pinholeCorner(const Pixel& p, const glm::vec2& side) const {
    const ImagePoint q = image_.undistorted(p.x, p.y);
    const glm::vec2 offset = side * (options_.squarePixels / 2);
    const float inverseZ = std::max(1 / q.z + glm::dot(gradient(p), offset), 0.5f / q.z);
    return camera_.worldFromCamera(camera_.cameraFromImage({q.u + offset.x, q.v + offset.y, 1 / inverseZ}));
  }

  /// Half way to the next samples of the tile. Another viewpoint took them: the surface may lie along the rays of the
  /// pinhole, where half a pixel of its image is a long way.
  glm::vec3 tileCorner(const Pixel& p, const glm::vec2& side) const {
    const glm::vec3 center = mesh_.positions[vertexOf_(p.x, p.y)];
    const float half = options_.squarePixels / 2;
    return center + side.x * half * tileStep(p, {1, 0}) + side.y * half * tileStep(p, {0, 1});
  }

  /// From sample to sample along a row or column of the tile; as the pinhole would step where the surface is one sample
  /// wide.
  glm::vec3 tileStep(const Pixel& p, const Pixel& step) const {
    const glm::vec3 center = mesh_.positions[vertexOf_(p.x, p.y)];
    glm::vec3 sum(0);
    float count = 0;
    for (const int sign : {-1, 1}) {
      const Pixel q{p.x + sign * step.x, p.y + sign * step.y};
      if (joined(p, q)) {
        sum += static_cast<float>(sign) * (mesh_.positions[vertexOf_(q.x, q.y)] - center);
        ++count;
      }
    }
    if (count > 0) {
      return sum / count;
    }
    const float footprint = image_.z(p.x, p.y) / camera_.focalPixels() * spacing(p);
    const glm::vec3 along(static_cast<float>(step.x) * footprint, static_cast<float>(step.y) * footprint, 0);
    return camera_.worldFromCamera(along) - camera_.worldFromCamera(glm::vec3(0));
  }

  const ReferenceImage& image_;
  const ImageMeshOptions& options_;
  PinholeCamera camera_;
  Image<uint32_t> vertexOf_;
  Image<uint8_t> cellTriangles_;  ///< of the cell between pixel (x, y) and (x + 1, y + 1)
  Mesh mesh_;
  std::vector<uint32_t> pixelOfVertex_;
};

}  // namespace

Mesh imageMesh(const ReferenceImage& image, const ImageMeshOptions& options, std::vector<uint32_t>* pixelOfVertex) {
  return ImageMesher(image, options).mesh(pixelOfVertex);
}

}  // namespace ocelli
