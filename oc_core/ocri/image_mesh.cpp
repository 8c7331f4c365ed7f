#include "oc_core/ocri/image_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/grid_cell.h"
#include "oc_core/ocri/sample_join.h"
#include "oc_core/ocri/sample_pairs.h"
#include "oc_core/ocri/sample_spacing.h"
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
        firstOfRow_(static_cast<size_t>(image.height()) + 1, 0),
        joins_(image.width(), image.height()),
        cells_(image.width(), image.height()),
        spacings_(sampleSpacings(image)),
        firstTriangleOfRow_(static_cast<size_t>(image.height()) + 1, 0) {}

  /// Of the mesh without a bound.
  size_t countTriangles() {
    findVertices();
    joinPixels();
    closeCells();
    return firstTriangleOfRow_.back() + 2 * openSamples().size();
  }

  Mesh mesh(std::vector<uint32_t>* pixelOfVertex) {
    findVertices();
    joinPixels();
    closeCells();
    planSquares(openSamples());
    allocate(pixelOfVertex);
    addVertices();
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

  /// Rows in parallel, some at a time: what `body(begin, end)` writes belongs to its rows.
  template <class Body>
  void forBands(const Body& body) const {
    parallelFor(static_cast<size_t>(image_.height()), 8,
                [&](size_t begin, size_t end) { body(static_cast<int>(begin), static_cast<int>(end)); });
  }
  template <class Body>
  void forRows(const Body& body) const {
    forBands([&](int y, int end) {
      for (; y < end; ++y) {
        body(y);
      }
    });
  }

  /// The column where the image goes on beyond its border, if it does.
  int column(int x) const { return image_.wrapsAround ? (x + image_.width()) % image_.width() : x; }
  Pixel beside(const Pixel& p, int dx, int dy) const { return {column(p.x + dx), p.y + dy}; }

  bool valid(const Pixel& p) const { return vertexOf_.contains(p.x, p.y) && vertexOf_(p.x, p.y) != kNoVertex; }

  /// Whether the sample has a world point: ReferenceImage::pointOf().
  bool hasPoint(int x, int y) const {
    if (!image_.holds(x, y) || image_.isPlaced()) {
      return image_.holds(x, y);
    }
    const float t = image_.t(x, y);
    const glm::vec2& d = image_.displacement(x, y);
    return t >= camera_.view().zNear && t <= camera_.view().zFar && std::isfinite(d.x) && std::isfinite(d.y);
  }

  bool isEmpty(int y) const { return firstOfRow_[static_cast<size_t>(y)] == firstOfRow_[static_cast<size_t>(y) + 1]; }

  /// Numbers the samples that have a point.
  void findVertices() {
    forRows([&](int y) {
      uint32_t count = 0;
      for (int x = 0; x < image_.width(); ++x) {
        vertexOf_(x, y) = hasPoint(x, y) ? count++ : kNoVertex;
      }
      firstOfRow_[static_cast<size_t>(y) + 1] = count;
    });
    std::partial_sum(firstOfRow_.begin(), firstOfRow_.end(), firstOfRow_.begin());
    forRows([&](int y) {
      for (int x = 0; x < image_.width(); ++x) {
        vertexOf_(x, y) += vertexOf_(x, y) != kNoVertex ? firstOfRow_[static_cast<size_t>(y)] : 0;
      }
    });
  }

  /// What the mesh takes, all at once: vectors fill themselves with zeros.
  void allocate(const std::vector<uint32_t>* pixelOfVertex) {
    const size_t vertices = firstOfRow_.back() + squareVertices_;
    parallelChunks(2, 2, [&](size_t chunk, size_t, size_t) {
      if (chunk == 0) {
        mesh_.triangles.resize(firstTriangleOfRow_.back() + squareTriangles_);
      } else {
        mesh_.positions.resize(vertices);
        mesh_.colors.resize(image_.color.empty() ? 0 : vertices);
        pixelOfVertex_.resize(pixelOfVertex != nullptr ? vertices : 0);
      }
    });
  }

  void setVertex(size_t vertex, const glm::vec3& position, const Pixel& p) {
    mesh_.positions[vertex] = position;
    if (!mesh_.colors.empty()) {
      mesh_.colors[vertex] = image_.color(p.x, p.y);
    }
    if (!pixelOfVertex_.empty()) {
      pixelOfVertex_[vertex] = static_cast<uint32_t>(image_.t.index(p.x, p.y));
    }
  }

  /// The samples, and the triangles of cells.
  void addVertices() {
    forRows([&](int y) {
      for (int x = 0; x < image_.width(); ++x) {
        if (vertexOf_(x, y) != kNoVertex) {
          setVertex(vertexOf_(x, y), *image_.pointOf(x, y, camera_), {x, y});
        }
      }
      glm::uvec3* next = mesh_.triangles.data() + firstTriangleOfRow_[static_cast<size_t>(y)];
      for (int x = 0; x < cellColumns() && y + 1 < image_.height(); ++x) {
        const uint8_t triangles = cells_(x, y);
        if (triangles == 0) {
          continue;
        }
        const int right = column(x + 1);
        const uint32_t a = vertexOf_(x, y);
        const uint32_t b = vertexOf_(x, y + 1);
        const uint32_t c = vertexOf_(right, y + 1);
        const uint32_t d = vertexOf_(right, y);
        forTrianglesOf(triangles, a, b, c, d, [&](uint32_t i, uint32_t j, uint32_t k) { *next++ = {i, j, k}; });
      }
    });
  }

  /// Whether pairs of samples of rows up to this one can be judged many at a time.
  bool isPlain(int lastRow) const {
    return !image_.isPlaced() && image_.layout.regions.empty() &&
           (image_.tileSide <= 0 || lastRow < image_.pinholeSize.y);
  }
  void undistort(int y, UndistortedRow& row) const {
    for (int x = 0; x < image_.width(); ++x) {
      const ImagePoint q = image_.undistorted(x, y);
      const auto i = static_cast<size_t>(x);
      row.u[i] = q.u;
      row.v[i] = q.v;
      row.t[i] = vertexOf_(x, y) != kNoVertex ? q.t : 0;
    }
  }
  bool decided(int said, const Pixel& p, int dx, int dy) const {
    return said == kNeighboursDecide ? joined(p, dx, dy) : said == kJoined;
  }

  /// Calls `body(y, here, below)` for each row, with its undistorted samples and those of the next one, or with none
  /// where pairs of them must be judged one by one.
  template <class Body>
  void forRowPairs(const Body& body) const {
    forBands([&](int begin, int end) {
      UndistortedRow here(image_.width());
      UndistortedRow below(image_.width());
      if (isPlain(begin)) {
        undistort(begin, below);
      }
      for (int y = begin; y < end; ++y) {
        std::swap(here, below);
        const bool isPair = y + 1 < image_.height() && isPlain(y + 1);
        if (isPair) {
          undistort(y + 1, below);
        }
        body(y, isPair ? &here : nullptr, below);
      }
    });
  }
  /// pairsByThemselves() of all samples of a row that have a partner.
  std::vector<int> judged(const UndistortedRow* a, size_t firstA, const UndistortedRow& b, size_t firstB) const {
    const auto width = static_cast<size_t>(image_.width());
    std::vector<int> said(width, kNeighboursDecide);
    if (a != nullptr) {
      pairsByThemselves(*a, firstA, b, firstB, width - std::max(firstA, firstB), camera_.focalPixels(), options_,
                        said.data());
    }
    return said;
  }

  void joinPixels() {
    forRowPairs([&](int y, const UndistortedRow* here, const UndistortedRow& below) {
      if (isEmpty(y)) {
        return;
      }
      const std::vector<int> right = here != nullptr ? judged(here, 0, *here, 1) : judged(nullptr, 0, below, 0);
      const std::vector<int> down = judged(here, 0, below, 0);
      for (int x = 0; x < image_.width(); ++x) {
        const auto i = static_cast<size_t>(x);
        joins_(x, y) = static_cast<uint8_t>((decided(right[i], {x, y}, 1, 0) ? kJoinedRight : 0) |
                                            (decided(down[i], {x, y}, 0, 1) ? kJoinedDown : 0));
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
  float spacing(const Pixel& p) const { return spacings_.empty() ? 1 : spacings_(p.x, p.y); }
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
      return placedSamplesJoin(placed(beside(p, -dx, -dy)), placed(p), placed(q), placed(beside(q, dx, dy)),
                               std::min(widthAt(p, dy, dx), widthAt(q, dy, dx)), options_);
    }
    const ImagePoint a = image_.undistorted(p.x, p.y);
    const ImagePoint b = image_.undistorted(q.x, q.y);
    if (const auto sure = samplesJoinByThemselves(a, b, camera_.focalPixels(), spacing(p), options_)) {
      return *sure;
    }
    return samplesJoin(sample(beside(p, -dx, -dy)), a, b, sample(beside(q, dx, dy)), false, camera_.focalPixels(),
                       spacing(p), options_);
  }

  int cellColumns() const { return image_.wrapsAround ? image_.width() : image_.width() - 1; }

  /// Each cell between four samples gives two triangles, one, or none.
  void closeCells() {
    forRowPairs([&](int y, const UndistortedRow* here, const UndistortedRow& below) {
      if (y + 1 >= image_.height() || isEmpty(y)) {
        return;
      }
      const std::vector<int> falling = judged(here, 0, below, 1);
      const std::vector<int> rising = judged(here, 1, below, 0);
      size_t count = 0;
      for (int x = 0; x < cellColumns(); ++x) {
        cells_(x, y) = trianglesOfCell({x, y}, falling[static_cast<size_t>(x)], rising[static_cast<size_t>(x)]);
        count += static_cast<size_t>(triangleCount(cells_(x, y)));
      }
      firstTriangleOfRow_[static_cast<size_t>(y) + 1] = count;
    });
    std::partial_sum(firstTriangleOfRow_.begin(), firstTriangleOfRow_.end(), firstTriangleOfRow_.begin());
  }

  /// `falling` and `rising` are what the ends of its diagonals say alone.
  uint8_t trianglesOfCell(const Pixel& a, int falling, int rising) const {
    const int right = column(a.x + 1);
    const uint8_t joinsA = joins_(a.x, a.y);
    const CellSides sides{(joinsA & kJoinedDown) != 0, (joins_(a.x, a.y + 1) & kJoinedRight) != 0,
                          (joins_(right, a.y) & kJoinedDown) != 0, (joinsA & kJoinedRight) != 0};
    uint8_t triangles = 0;
    // Corners a to d are 0 to 3.
    closeCell(
        0, 1, 2, 3, sides,
        [&](int p, int) {
          return p == 0 ? decided(falling, a, 1, 1) : decided(rising, {a.x, a.y + 1}, 1, -1);
        },
        [&](int p) { return 1 / image_.t(p < 2 ? a.x : right, p == 0 || p == 3 ? a.y : a.y + 1); },
        [&](int p, int q, int) { triangles |= bitOfTriangle(p, q); });
    return triangles;
  }

  /// The change of 1/z for a pixel to the right and a pixel down in the undistorted image, from the joined neighbours.
  glm::vec2 gradient(const Pixel& p) const {
    glm::vec2 rhs(0);
    float xx = 1e-3f * spacing(p) * spacing(p);
    float xy = 0;
    float yy = xx;
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
    return cells_.contains(cell, y) ? triangleCount(cells_(cell, y)) : 0;
  }

  /// Where a surface ends, the most open samples first.
  std::vector<Pixel> openSamples() const {
    using Rims = std::array<std::vector<Pixel>, kClosedTriangles>;  // by triangles around
    std::vector<Rims> ofRow(static_cast<size_t>(image_.height()));
    forRows([&](int y) {
      for (int x = 0; x < image_.width(); ++x) {
        if (vertexOf_(x, y) == kNoVertex) {
          continue;
        }
        const auto around =
            static_cast<size_t>(y > 0 && x > 0 ? triangleCount(cells_(x - 1, y - 1)) + triangleCount(cells_(x, y - 1)) +
                                                     triangleCount(cells_(x - 1, y)) + triangleCount(cells_(x, y))
                                               : trianglesAround(x, y));
        if (around < kClosedTriangles) {
          ofRow[static_cast<size_t>(y)][around].push_back({x, y});
        }
      }
    });
    std::vector<Pixel> rims;
    for (size_t around = 0; around < kClosedTriangles; ++around) {
      for (const Rims& row : ofRow) {
        rims.insert(rims.end(), row[around].begin(), row[around].end());
      }
    }
    return rims;
  }

  struct Square {
    Pixel sample;
    bool whole;  ///< or half
  };

  void planSquares(const std::vector<Pixel>& rims) {
    const size_t bound = image_.triangleBound > 0 ? image_.triangleBound : std::numeric_limits<size_t>::max();
    const size_t affordable = bound - std::min(bound, firstTriangleOfRow_.back());
    const size_t covered = std::min(rims.size(), affordable);
    const size_t whole = std::min(covered, affordable - covered);
    std::vector<char> wanted(covered, 1);
    if (image_.isPlaced()) {
      parallelFor(covered, 256, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          wanted[i] = hasWidth(rims[i]);
        }
      });
    }
    for (size_t i = 0; i < covered; ++i) {
      if (wanted[i] != 0) {
        wholeSquares_ += i < whole;
        squares_.push_back({rims[i], i < whole});
      }
    }
    squareVertices_ = 3 * squares_.size() + wholeSquares_;
    squareTriangles_ = squares_.size() + wholeSquares_;
  }
  /// A placed sample that is all alone has none: nothing says how wide it is.
  bool hasWidth(const Pixel& p) const {
    return placedStep(p, 1, 0) != glm::vec3(0) && placedStep(p, 0, 1) != glm::vec3(0);
  }

  void addSquares() {
    parallelFor(squares_.size(), 64, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const size_t before = std::min(i, wholeSquares_);  // whole ones come first
        addSquare(squares_[i], firstOfRow_.back() + 3 * i + before, firstTriangleOfRow_.back() + i + before);
      }
    });
  }

  /// A step of one pixel in the undistorted image, from the joined neighbours: longer where samples are squeezed.
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
    if (length <= spacing(p)) {
      return glm::vec2(direction) * spacing(p);
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

  void addSquare(const Square& square, size_t vertex, size_t triangle) {
    const Pixel& p = square.sample;
    const auto first = static_cast<uint32_t>(vertex);
    Surface surface;
    if (!image_.isPlaced() && !inTile(p)) {
      surface = {image_.undistorted(p.x, p.y), sampleStep(p, {1, 0}), sampleStep(p, {0, 1}), gradient(p)};
    }
    const auto addCorner = [&](const glm::vec2& side) {
      setVertex(vertex++,
                image_.isPlaced() ? placedCorner(p, side)
                : inTile(p)       ? tileCorner(p, side)
                                  : pinholeCorner(surface, side),
                p);
    };
    mesh_.triangles[triangle] = {first, first + 1, first + 2};
    if (square.whole) {
      for (const glm::vec2& side : kSquareSides) {
        addCorner(side);
      }
      mesh_.triangles[triangle + 1] = {first, first + 2, first + 3};
    } else {
      const glm::vec2 open = opening(p);
      const glm::vec2 outward = open == glm::vec2(0) ? glm::vec2(1, 0) : open;
      // A little inwards, so that the sample itself is safely covered.
      constexpr float kOverlap = 0.25f;
      const glm::vec2 along(-outward.y, outward.x);
      addCorner(along - outward * kOverlap);
      addCorner(-along - outward * kOverlap);
      addCorner(outward);
    }
  }

  struct Surface {
    ImagePoint center;
    glm::vec2 right, down;  ///< steps of a pixel
    glm::vec2 gradient;
  };
  /// Half a step away from the sample in the pinhole's image, on the plane of the surface.
  glm::vec3 pinholeCorner(const Surface& s, const glm::vec2& side) const {
    const glm::vec2 offset = (s.right * side.x + s.down * side.y) * (options_.squarePixels / 2);
    const ImagePoint q =
        squareCorner(s.center, {offset.x, offset.y, glm::dot(s.gradient, offset)}, camera_.focalPixels(), options_);
    return camera_.worldFromCamera(camera_.cameraFromImage(q));
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
  std::vector<uint32_t> firstOfRow_;  ///< vertex
  Image<uint8_t> joins_;              ///< to the neighbours on the right and below
  Image<uint8_t> cells_;              ///< triangles of the cell between pixel (x, y) and (x + 1, y + 1)
  Image<float> spacings_;             ///< empty where all are a pixel
  std::vector<size_t> firstTriangleOfRow_;
  std::vector<Square> squares_;
  size_t wholeSquares_ = 0;
  size_t squareVertices_ = 0;
  size_t squareTriangles_ = 0;
  Mesh mesh_;
  std::vector<uint32_t> pixelOfVertex_;
};

}  // namespace

size_t imageMeshTriangles(const ReferenceImage& image) {
  return ImageMesher(image, ImageMeshOptions{}).countTriangles();
}

Mesh imageMesh(const ReferenceImage& image, const ImageMeshOptions& options, std::vector<uint32_t>* pixelOfVertex) {
  return ImageMesher(image, options).mesh(pixelOfVertex);
}

}  // namespace ocelli
