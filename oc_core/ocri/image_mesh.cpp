#include "oc_core/ocri/image_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <optional>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/grid_cell.h"
#include "oc_core/ocri/sample_join.h"
#include "oc_core/ocri/square_corner.h"

namespace ocelli {
namespace {

constexpr uint32_t kNoVertex = 0xffffffffu;
constexpr uint8_t kJoinedRight = 1;
constexpr uint8_t kJoinedDown = 2;
constexpr float kDeepestPlacedSquare = 2;  ///< footprints
constexpr float kWidestPlacedSquare = 2;

class ImageMesher {
 public:
  ImageMesher(const ReferenceImage& image, const ImageMeshOptions& options)
      : image_(image),
        options_(options),
        camera_(image.reference()),
        vertexOf_(image.width(), image.height(), kNoVertex),
        joins_(image.width(), image.height()),
        cellTriangles_(image.width(), image.height()) {}

  /// Of the mesh without a bound.
  size_t countTriangles() {
    forRows([&](int y) {
      for (int x = 0; x < image_.width(); ++x) {
        vertexOf_(x, y) = image_.pointOf(x, y, camera_) ? 0 : kNoVertex;
      }
    });
    joinPixels();
    std::vector<size_t> ofRow(static_cast<size_t>(image_.height()), 0);
    forRows([&](int y) {
      std::vector<glm::uvec3> triangles;
      addCells(y, triangles);
      ofRow[static_cast<size_t>(y)] = triangles.size();
    });
    return std::accumulate(ofRow.begin(), ofRow.end(), 2 * openSamples().size());
  }

  Mesh mesh(std::vector<uint32_t>* pixelOfVertex) {
    addVertices();
    joinPixels();
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

  /// Rows in parallel: what `body` writes belongs to its row.
  void forRows(const std::function<void(int y)>& body) const {
    parallelFor(static_cast<size_t>(image_.height()), 8, [&](size_t begin, size_t end) {
      for (size_t y = begin; y < end; ++y) {
        body(static_cast<int>(y));
      }
    });
  }

  /// The column where the image goes on beyond its border, if it does.
  int column(int x) const { return image_.wrapsAround ? (x + image_.width()) % image_.width() : x; }
  Pixel beside(const Pixel& p, int dx, int dy) const { return {column(p.x + dx), p.y + dy}; }

  bool valid(const Pixel& p) const { return vertexOf_.contains(p.x, p.y) && vertexOf_(p.x, p.y) != kNoVertex; }

  void addVertices() {
    const auto pointOf = [&](int x, int y) { return image_.pointOf(x, y, camera_); };
    std::vector<uint32_t> firstOfRow(static_cast<size_t>(image_.height()) + 1, 0);
    forRows([&](int y) {
      for (int x = 0; x < image_.width(); ++x) {
        firstOfRow[static_cast<size_t>(y) + 1] += pointOf(x, y).has_value();
      }
    });
    std::partial_sum(firstOfRow.begin(), firstOfRow.end(), firstOfRow.begin());
    mesh_.positions.resize(firstOfRow.back());
    mesh_.colors.resize(firstOfRow.back());
    pixelOfVertex_.resize(firstOfRow.back());
    forRows([&](int y) {
      uint32_t next = firstOfRow[static_cast<size_t>(y)];
      for (int x = 0; x < image_.width(); ++x) {
        if (const std::optional<glm::vec3> point = pointOf(x, y)) {
          vertexOf_(x, y) = next;
          mesh_.positions[next] = *point;
          mesh_.colors[next] = image_.color(x, y);
          pixelOfVertex_[next] = static_cast<uint32_t>(image_.t.index(x, y));
          ++next;
        }
      }
    });
  }

  void joinPixels() {
    forRows([&](int y) {
      for (int x = 0; x < image_.width(); ++x) {
        joins_(x, y) =
            static_cast<uint8_t>((joined({x, y}, 1, 0) ? kJoinedRight : 0) | (joined({x, y}, 0, 1) ? kJoinedDown : 0));
      }
    });
  }
  /// What joined() says, for two pixels side by side or one above the other.
  bool areJoined(const Pixel& p, const Pixel& q) const {
    const bool isLeft = p.y == q.y && column(p.x + 1) == q.x;
    const Pixel first = isLeft || q.y > p.y ? p : q;
    return valid(p) && valid(q) && (joins_(first.x, first.y) & (p.y == q.y ? kJoinedRight : kJoinedDown)) != 0;
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

  /// The undistorted sample, z = 0 where there is none.
  ImagePoint sample(const Pixel& p) const { return valid(p) ? image_.undistorted(p.x, p.y) : ImagePoint{}; }

  PlacedSample placed(const Pixel& p) const {
    return valid(p) ? PlacedSample{image_.position(p.x, p.y), image_.direction(p.x, p.y), true} : PlacedSample{};
  }

  /// Between the ray of a placed sample and the nearer of its neighbours in a direction; no limit where it has none.
  float widthAt(const Pixel& p, int dx, int dy) const {
    float width = std::numeric_limits<float>::max();
    for (const int sign : {-1, 1}) {
      const Pixel q = beside(p, sign * dx, sign * dy);
      if (valid(q)) {
        width = std::min(width, stepBetween(placed(p), placed(q)).footprint);
      }
    }
    return width;
  }

  /// A pixel and one beside it.
  bool joined(const Pixel& p, int dx, int dy) const {
    const Pixel q = beside(p, dx, dy);
    if (!valid(p) || !valid(q) || !sameTile(p, q)) {
      return false;
    }
    if (image_.isPlaced()) {
      return joinedPlaced(p, q, dx, dy);
    }
    const ImagePoint a = image_.undistorted(p.x, p.y);
    const ImagePoint b = image_.undistorted(q.x, q.y);
    if (const auto sure = samplesJoinByThemselves(a, b, camera_.focalPixels(), spacing(p), options_)) {
      return *sure;
    }
    return samplesJoin(sample(beside(p, -dx, -dy)), a, b, sample(beside(q, dx, dy)), false, camera_.focalPixels(),
                       spacing(p), options_);
  }
  bool joinedPlaced(const Pixel& p, const Pixel& q, int dx, int dy) const {
    return placedSamplesJoin(placed(beside(p, -dx, -dy)), placed(p), placed(q), placed(beside(q, dx, dy)),
                             std::min(widthAt(p, dy, dx), widthAt(q, dy, dx)), options_);
  }

  /// Each cell between four samples gives two triangles, one, or none.
  void joinNeighbours() {
    std::vector<std::vector<glm::uvec3>> rows(static_cast<size_t>(image_.height()));
    forRows([&](int y) { addCells(y, rows[static_cast<size_t>(y)]); });
    for (const std::vector<glm::uvec3>& row : rows) {
      mesh_.triangles.insert(mesh_.triangles.end(), row.begin(), row.end());
    }
  }

  void addCells(int y, std::vector<glm::uvec3>& triangles) {
    const int cells = image_.wrapsAround ? image_.width() : image_.width() - 1;
    for (int x = 0; x < cells && y + 1 < image_.height(); ++x) {
      addCell({x, y}, triangles);
    }
  }

  void addCell(const Pixel& a, std::vector<glm::uvec3>& triangles) {
    const Pixel b = beside(a, 0, 1);
    const Pixel c = beside(a, 1, 1);
    const Pixel d = beside(a, 1, 0);
    closeCell(
        a, b, c, d, {areJoined(a, b), areJoined(b, c), areJoined(c, d), areJoined(d, a)},
        [&](const Pixel& p, const Pixel& q) { return joined(p, 1, q.y - p.y); },
        [&](const Pixel& p) { return 1 / image_.t(p.x, p.y); },
        [&](const Pixel& p, const Pixel& q, const Pixel& r) {
          triangles.emplace_back(vertexOf_(p.x, p.y), vertexOf_(q.x, q.y), vertexOf_(r.x, r.y));
          ++cellTriangles_(a.x, a.y);
        });
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
      if (areJoined(p, q)) {
        const ImagePoint b = image_.undistorted(q.x, q.y);
        const glm::vec2 d(b.u - a.u, b.v - a.v);
        rhs += d * (1 / b.t - 1 / a.t);
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
      }
    }
    const float determinant = xx * yy - xy * xy;
    return glm::vec2(yy * rhs.x - xy * rhs.y, xx * rhs.y - xy * rhs.x) / determinant;
  }

  int trianglesAround(int x, int y) const {
    return trianglesOf(x - 1, y - 1) + trianglesOf(x, y - 1) + trianglesOf(x - 1, y) + trianglesOf(x, y);
  }
  int trianglesOf(int x, int y) const {
    const int cell = column(x);
    return cellTriangles_.contains(cell, y) ? cellTriangles_(cell, y) : 0;
  }

  /// Where a surface ends, the most open samples first.
  std::vector<Pixel> openSamples() const {
    std::array<std::vector<Pixel>, kClosedTriangles> rimsByTriangles;
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) {
        const auto around = static_cast<size_t>(trianglesAround(x, y));
        if (vertexOf_(x, y) != kNoVertex && around < rimsByTriangles.size()) {
          rimsByTriangles[around].push_back({x, y});
        }
      }
    }
    std::vector<Pixel> rims;
    for (const std::vector<Pixel>& part : rimsByTriangles) {
      rims.insert(rims.end(), part.begin(), part.end());
    }
    return rims;
  }

  void addSquares() {
    const std::vector<Pixel> rims = openSamples();
    const size_t bound = image_.triangleBound > 0 ? image_.triangleBound : std::numeric_limits<size_t>::max();
    const size_t affordable = bound - std::min(bound, mesh_.triangles.size());
    const size_t covered = std::min(rims.size(), affordable);
    const size_t squares = std::min(covered, affordable - covered);
    for (size_t i = 0; i < covered; ++i) {
      addRim(rims[i], i < squares);
    }
  }

  /// What a step of one pixel is in the undistorted image, from the joined neighbours: longer where samples are
  /// squeezed.
  glm::vec2 sampleStep(const Pixel& p, const glm::ivec2& direction) const {
    glm::vec2 sum(0);
    float count = 0;
    const ImagePoint a = image_.undistorted(p.x, p.y);
    for (const int sign : {1, -1}) {
      const Pixel q{p.x + sign * direction.x, p.y + sign * direction.y};
      if (image_.rows == ImageRows::kAligned && areJoined(p, q)) {
        const ImagePoint b = image_.undistorted(q.x, q.y);
        sum += glm::vec2(b.u - a.u, b.v - a.v) * static_cast<float>(sign);
        ++count;
      }
    }
    const float length = count > 0 ? glm::length(sum) / count : 0;
    if (length <= 1) {
      return direction;
    }
    return sum / count * std::min(options_.longestSquarePixels / length, 1.0f);
  }

  /// Towards the opening around a sample, each component -1, 0 or 1.
  glm::vec2 opening(const Pixel& p) const {
    const auto triangles = [&](int dx, int dy) { return trianglesOf(p.x + dx, p.y + dy); };
    const int right = triangles(-1, -1) + triangles(-1, 0) - triangles(0, -1) - triangles(0, 0);
    const int down = triangles(-1, -1) + triangles(0, -1) - triangles(-1, 0) - triangles(0, 0);
    return {static_cast<float>((right > 0) - (right < 0)), static_cast<float>((down > 0) - (down < 0))};
  }

  /// A square around the sample or, in one triangle, the half of it that points to the opening.
  void addRim(const Pixel& p, bool whole) {
    if (image_.isPlaced() && (placedStep(p, 1, 0) == glm::vec3(0) || placedStep(p, 0, 1) == glm::vec3(0))) {
      return;  // alone, so that nothing says how wide it is
    }
    const auto addCorner = [&](const glm::vec2& side) {
      mesh_.positions.push_back(image_.isPlaced() ? placedCorner(p, side)
                                : inTile(p)       ? tileCorner(p, side)
                                                  : pinholeCorner(p, side));
      mesh_.colors.push_back(image_.color(p.x, p.y));
      pixelOfVertex_.push_back(static_cast<uint32_t>(image_.t.index(p.x, p.y)));
    };
    const auto first = static_cast<uint32_t>(mesh_.positions.size());
    mesh_.triangles.emplace_back(first, first + 1, first + 2);
    if (whole) {
      for (const glm::vec2& side : kSquareSides) {
        addCorner(side);
      }
      mesh_.triangles.emplace_back(first, first + 2, first + 3);
    } else {
      glm::vec2 outward = opening(p);
      outward = outward == glm::vec2(0) ? glm::vec2(1, 0) : outward;
      // A little inwards, so that the sample itself is safely covered.
      constexpr float kOverlap = 0.25f;
      const glm::vec2 along(-outward.y, outward.x);
      addCorner(along - outward * kOverlap);
      addCorner(-along - outward * kOverlap);
      addCorner(outward);
    }
  }

  /// Half a step away from the sample in the pinhole's image, on the plane of the surface.
  glm::vec3 pinholeCorner(const Pixel& p, const glm::vec2& side) const {
    const ImagePoint q = image_.undistorted(p.x, p.y);
    const glm::vec2 offset =
        (sampleStep(p, {1, 0}) * side.x + sampleStep(p, {0, 1}) * side.y) * (options_.squarePixels / 2);
    const ImagePoint step{offset.x, offset.y, glm::dot(gradient(p), offset)};
    return camera_.worldFromCamera(camera_.cameraFromImage(squareCorner(q, step, camera_.focalPixels(), options_)));
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
      if (areJoined(p, q)) {
        sum += static_cast<float>(sign) * (mesh_.positions[vertexOf_(q.x, q.y)] - center);
        ++count;
      }
    }
    if (count > 0) {
      return sum / count;
    }
    const float footprint = image_.t(p.x, p.y) / camera_.focalPixels() * spacing(p);
    const glm::vec3 along(static_cast<float>(step.x) * footprint, static_cast<float>(step.y) * footprint, 0);
    return camera_.worldFromCamera(along) - camera_.worldFromCamera(glm::vec3(0));
  }

  glm::vec3 placedCorner(const Pixel& p, const glm::vec2& side) const {
    const float half = options_.squarePixels / 2;
    return image_.position(p.x, p.y) + side.x * half * placedStep(p, 1, 0) + side.y * half * placedStep(p, 0, 1);
  }

  /// From a placed sample half way to both neighbours of a row or column: as the joined ones say, else at a right angle
  /// to the ray and to the other direction, else as wide as the rays of a neighbour are apart. 0 for one all alone.
  glm::vec3 placedStep(const Pixel& p, int dx, int dy) const {
    const glm::vec3& ray = image_.direction(p.x, p.y);
    // One of the neighbours may be of rays that have bent to somewhere else: the nearer one says how wide is too wide.
    const float widest = kWidestPlacedSquare * widthAt(p, dx, dy);
    const auto atMost = [](const glm::vec3& step, float length) {
      const float is = glm::length(step);
      return is > length ? step * (length / is) : step;
    };
    if (const glm::vec3 step = joinedStep(p, dx, dy); step != glm::vec3(0)) {
      // No viewpoint sees a grazing surface's square as small as its rays do: it must not stand out.
      const float along = glm::dot(step, ray);
      const glm::vec3 across = atMost(step - ray * along, widest);
      const float deepest = kDeepestPlacedSquare * glm::length(across);
      return across + ray * std::clamp(along, -deepest, deepest);
    }
    // Right, down and along the ray are a right-handed system.
    const glm::vec3 other = joinedStep(p, dy, dx);
    const glm::vec3 across = atMost(other - ray * glm::dot(other, ray), widest);
    if (across != glm::vec3(0)) {
      return dx != 0 ? glm::cross(across, ray) : glm::cross(ray, across);
    }
    for (const int sign : {-1, 1}) {
      const Pixel q = beside(p, sign * dx, sign * dy);
      if (valid(q)) {
        const glm::vec3 between = image_.position(q.x, q.y) - image_.position(p.x, p.y);
        return static_cast<float>(sign) * atMost(between - ray * glm::dot(between, ray), widest / kWidestPlacedSquare);
      }
    }
    return glm::vec3(0);
  }
  glm::vec3 joinedStep(const Pixel& p, int dx, int dy) const {
    glm::vec3 sum(0);
    float count = 0;
    for (const int sign : {-1, 1}) {
      const Pixel q = beside(p, sign * dx, sign * dy);
      if (areJoined(p, q)) {
        sum += static_cast<float>(sign) * (image_.position(q.x, q.y) - image_.position(p.x, p.y));
        ++count;
      }
    }
    return count > 0 ? sum / count : sum;
  }

  const ReferenceImage& image_;
  const ImageMeshOptions& options_;
  PinholeCamera camera_;
  Image<uint32_t> vertexOf_;
  Image<uint8_t> joins_;          ///< to the neighbours on the right and below
  Image<uint8_t> cellTriangles_;  ///< of the cell between pixel (x, y) and (x + 1, y + 1)
  Mesh mesh_;
  std::vector<uint32_t> pixelOfVertex_;
};

}  // namespace

size_t imageMeshTriangles(const ReferenceImage& image) {
  const ImageMeshOptions options;
  return ImageMesher(image, options).countTriangles();
}

Mesh imageMesh(const ReferenceImage& image, const ImageMeshOptions& options, std::vector<uint32_t>* pixelOfVertex) {
  return ImageMesher(image, options).mesh(pixelOfVertex);
}

}  // namespace ocelli
