#include "oc_core/shade/ray_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/scene/box.h"

namespace ocelli {
namespace {

constexpr size_t kEnoughRays = 8192;  ///< to be looked at
constexpr size_t kMinRays = 16;
constexpr double kRaysInCell = 0.98;
constexpr float kMinCellShare = 0.01f;  ///< of the distance to what is seen
constexpr int kEyes = 32;               ///< that are tried between the meeting point and the middle
constexpr double kMaxTangent = 1;       ///< of half the vertical angle: 90 degrees in all
constexpr double kFieldMargin = 1.02;

/// A piece of a line.
struct RayPiece {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0};
  double first = 0;
  double last = 0;

  glm::dvec3 at(double distance) const { return origin + direction * distance; }
  double distanceTo(const glm::dvec3& point) const {
    const glm::dvec3 way = point - origin;
    return glm::length(way - direction * glm::dot(way, direction));
  }
};

/// Which cells of a grid may hold surfaces: those that boxes around triangles, or parts of them, touch.
class OccupiedGrid {
 public:
  explicit OccupiedGrid(const Mesh& mesh) : box_(boundsOf(mesh)), cells_(kSide * kSide * kSide, 0) {
    const glm::vec3 least = glm::vec3(1e-6f * glm::length(box_.size()));
    cellSize_ = glm::max(box_.size(), least) / static_cast<float>(kSide);
    for (const glm::uvec3& t : mesh.triangles) {
      occupy(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], 0);
    }
  }

  /// From the first to the last occupied cell that the ray passes, give or take half a cell.
  std::optional<RayPiece> piece(const SecondaryRay& ray) const {
    double near = 0;
    double far = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (static_cast<double>(box_.lower[axis]) - static_cast<double>(ray.origin[axis])) /
                       static_cast<double>(ray.direction[axis]);
      const double b = (static_cast<double>(box_.upper[axis]) - static_cast<double>(ray.origin[axis])) /
                       static_cast<double>(ray.direction[axis]);
      // A ray in the plane of a side gives no number, and is left out there.
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    // Also of a ray whose coordinates are no numbers, which std::max() passes over.
    if (!(near < far) || !std::isfinite(glm::dot(ray.origin, ray.direction))) {
      return std::nullopt;
    }
    const double step = 0.5 * static_cast<double>(std::min({cellSize_.x, cellSize_.y, cellSize_.z}));
    // No more than across the box along its diagonal: flat boxes have thin cells.
    const auto steps = static_cast<int>(std::min(std::ceil((far - near) / step), 4096.0));
    RayPiece piece{glm::dvec3(ray.origin), glm::dvec3(ray.direction), -1, -1};
    for (int i = 0; i <= steps; ++i) {
      const double distance = near + (far - near) * i / std::max(steps, 1);
      if (cells_[indexOf(cellAt(glm::vec3(piece.at(distance))))] != 0) {
        piece.first = piece.first < 0 ? distance : piece.first;
        piece.last = distance;
      }
    }
    return piece.first >= 0 ? std::optional(piece) : std::nullopt;
  }

 private:
  static constexpr int kSide = 48;

  /// The cells of a box around the triangle, which is halved until those are few.
  void occupy(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int halvings) {
    constexpr int kFewCells = 64;
    constexpr int kMaxHalvings = 24;  // a triangle across the grid has 48 x 48 cells: 12 suffice
    Box around;
    for (const glm::vec3& corner : {a, b, c}) {
      around.add(corner);
    }
    const glm::ivec3 lower = cellAt(around.lower);
    const glm::ivec3 upper = cellAt(around.upper);
    const glm::ivec3 count = upper - lower + 1;
    if (count.x * count.y * count.z > kFewCells && halvings < kMaxHalvings) {
      const float ab = glm::distance(a, b);
      const float bc = glm::distance(b, c);
      const float ca = glm::distance(c, a);
      const auto halve = [&](const glm::vec3& p, const glm::vec3& q, const glm::vec3& apex) {
        const glm::vec3 middle = (p + q) / 2.0f;
        occupy(p, middle, apex, halvings + 1);
        occupy(middle, q, apex, halvings + 1);
      };
      ab >= bc&& ab >= ca ? halve(a, b, c) : bc >= ca ? halve(b, c, a) : halve(c, a, b);
      return;
    }
    for (int z = lower.z; z <= upper.z; ++z) {
      for (int y = lower.y; y <= upper.y; ++y) {
        for (int x = lower.x; x <= upper.x; ++x) {
          cells_[indexOf({x, y, z})] = 1;
        }
      }
    }
  }
  glm::ivec3 cellAt(const glm::vec3& point) const {
    return glm::clamp(glm::ivec3((point - box_.lower) / cellSize_), glm::ivec3(0), glm::ivec3(kSide - 1));
  }
  static size_t indexOf(const glm::ivec3& cell) {
    return static_cast<size_t>((cell.z * kSide + cell.y) * kSide + cell.x);
  }

  Box box_;
  glm::vec3 cellSize_{1};
  std::vector<uint8_t> cells_;
};

/// Nothing where the lines are all but parallel.
std::optional<glm::dvec3> meetingPoint(const std::vector<RayPiece>& pieces) {
  glm::dmat3 sum(0);
  glm::dvec3 moment(0);
  for (const RayPiece& piece : pieces) {
    const glm::dmat3 across = glm::dmat3(1) - glm::outerProduct(piece.direction, piece.direction);
    sum += across;
    moment += across * piece.origin;
  }
  const auto count = static_cast<double>(pieces.size());
  constexpr double kMinDeterminant = 1e-9;
  if (!(std::abs(glm::determinant(sum / count)) > kMinDeterminant)) {
    return std::nullopt;
  }
  return glm::inverse(sum) * moment;
}

/// The view from `view.eye` that holds all points, the nearest of them at zNear; nothing where none does.
std::optional<View> viewHolding(const std::vector<glm::vec3>& points, View view, int width, int height) {
  constexpr int kRounds = 4;          // of turning towards the middle of them
  constexpr float kMinCosine = 0.2f;  // what stands farther aside is behind, or nearly
  const float aspect = static_cast<float>(height) / static_cast<float>(width);
  for (int round = 0; round < kRounds; ++round) {
    view.fovVerticalDegrees = 90;
    const glm::vec3 way = view.target - view.eye;
    if (!(glm::length(way) > 0)) {
      return std::nullopt;
    }
    view.up = std::abs(way.y) > 0.95f * glm::length(way) ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    view.zNear = 1e-3f * glm::length(way);
    const PinholeCamera wide(view, width, height);
    glm::vec2 lower(std::numeric_limits<float>::max());
    glm::vec2 upper(std::numeric_limits<float>::lowest());
    float nearest = std::numeric_limits<float>::max();
    for (const glm::vec3& point : points) {
      const glm::vec3 p = wide.cameraFromWorld(point);
      if (!(p.z > kMinCosine * glm::length(p))) {
        return std::nullopt;
      }
      const glm::vec2 q = glm::vec2(p) / p.z;
      lower = glm::min(lower, q);
      upper = glm::max(upper, q);
      nearest = std::min(nearest, p.z);
    }
    const glm::vec2 farthest = glm::max(glm::abs(lower), glm::abs(upper));
    const double tangent = kFieldMargin * static_cast<double>(std::max(farthest.y, farthest.x * aspect));
    if (round + 1 < kRounds) {
      view.target = wide.worldFromCamera({(lower + upper) / 2.0f, 1});
      continue;
    }
    if (!(tangent <= kMaxTangent) || !(tangent > 0)) {
      return std::nullopt;
    }
    view.fovVerticalDegrees = 2 * degreesFromRadians(std::atan(tangent));
    view.zNear = nearest;
    return view;
  }
  return std::nullopt;
}

float cellSideAround(const glm::vec3& eye, const std::vector<RayPiece>& pieces, float nearest) {
  std::vector<double> distances;
  for (const RayPiece& piece : pieces) {
    distances.push_back(piece.distanceTo(glm::dvec3(eye)));
  }
  const auto last = static_cast<double>(distances.size() - 1);
  const auto within = distances.begin() + static_cast<std::ptrdiff_t>(std::ceil(kRaysInCell * last));
  std::nth_element(distances.begin(), within, distances.end());
  return std::max(2 * static_cast<float>(*within), kMinCellShare * nearest);
}

}  // namespace

std::optional<RayView> viewOfRays(std::span<const SecondaryRay> rays, const Mesh& cast, const glm::vec3& middle,
                                  int width, int height) {
  if (cast.empty()) {
    return std::nullopt;
  }
  const OccupiedGrid grid(cast);
  std::vector<RayPiece> pieces;
  std::vector<glm::vec3> points;
  glm::dvec3 sum(0);
  for (size_t i = 0; i < rays.size(); i += 1 + rays.size() / kEnoughRays) {
    if (const std::optional<RayPiece> piece = grid.piece(rays[i])) {
      pieces.push_back(*piece);
      for (const double distance : {piece->first, piece->last}) {
        points.emplace_back(piece->at(distance));
        sum += piece->at(distance);
      }
    }
  }
  if (pieces.size() < kMinRays) {
    return std::nullopt;
  }
  const std::optional<glm::dvec3> meeting = meetingPoint(pieces);
  if (!meeting) {
    return std::nullopt;
  }
  for (int i = 0; i <= kEyes; ++i) {
    View view;
    view.eye = glm::vec3(glm::mix(*meeting, glm::dvec3(middle), static_cast<double>(i) / kEyes));
    view.target = glm::vec3(sum / static_cast<double>(points.size()));
    if (const std::optional<View> held = viewHolding(points, view, width, height)) {
      RayView found{*held, cellSideAround(held->eye, pieces, held->zNear)};
      // What stands before all that the rays may meet would hide it, seen from any viewpoint of the cell: it stands
      // behind the mirror, or in its place.
      constexpr float kBefore = 0.98f;
      constexpr float kMinShare = 1e-3f;
      found.view.zNear = std::max(kBefore * held->zNear - found.cellSide / 2, kMinShare * held->zNear);
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
