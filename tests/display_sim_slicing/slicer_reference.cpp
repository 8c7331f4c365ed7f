#include "tests/display_sim_slicing/slicer_reference.h"

#include <algorithm>
#include <limits>

#include "display_sim/dither/even_light.h"
#include "display_sim/dither/voxel_dither.h"
#include "display_sim/frames/sweep_geometry.h"

namespace ocelli {
namespace {

/// A point of a triangle: screen coordinates of a sector (pixels from the axis outwards, from the slice plane, from the
/// top) and its colour.
struct Point {
  glm::dvec3 at;
  glm::dvec3 color;
};

/// Points p with dot(normal, p) <= limit.
struct HalfSpace {
  glm::dvec3 normal;
  double limit;
};

double dot(const glm::dvec3& a, const glm::dvec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

std::vector<Point> clip(const std::vector<Point>& polygon, const HalfSpace& half) {
  std::vector<Point> kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double outA = dot(half.normal, a.at) - half.limit;
    const double outB = dot(half.normal, b.at) - half.limit;
    if (outA <= 0) {
      kept.push_back(a);
    }
    if ((outA < 0 && outB > 0) || (outA > 0 && outB < 0)) {
      const double t = outA / (outA - outB);
      kept.push_back({a.at + (b.at - a.at) * t, a.color + (b.color - a.color) * t});
    }
  }
  return kept;
}

std::vector<Point> clip(std::vector<Point> polygon, std::initializer_list<HalfSpace> halves) {
  for (const HalfSpace& half : halves) {
    if (polygon.empty()) {
      break;
    }
    polygon = clip(polygon, half);
  }
  return polygon;
}

/// The cells along one direction that points between `lo` and `hi` may touch, one more on either side for the margin.
struct Candidates {
  Candidates(double lo, double hi, int count)
      : first(static_cast<int>(std::clamp(std::floor(lo) - 1, 0.0, count - 1.0))),
        last(static_cast<int>(std::clamp(std::floor(hi) + 1, 0.0, count - 1.0))) {}
  int first;
  int last;
};

class ReferenceSlicer {
 public:
  ReferenceSlicer(const DisplayProfile& profile, const ReferenceOptions& options)
      : sweep_(profile), options_(options), dither_(options.colors), volume_(profile) {}

  void add(const Mesh& mesh, const glm::uvec3& triangle) {
    normal_ = unitNormal(mesh.positions[triangle.x], mesh.positions[triangle.y], mesh.positions[triangle.z]);
    for (int sector = 0; sector < sweep_.sectors(); ++sector) {
      const glm::dvec2& direction = sweep_.sectorDirection(sector);
      std::vector<Point> polygon;
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 p(mesh.positions[triangle[k]]);
        const double outward = p.x * direction.x + p.z * direction.y;
        const double across = p.z * direction.x - p.x * direction.y;
        polygon.push_back(
            {{outward * sweep_.columnsPerRadius(), across * sweep_.columnsPerRadius(), sweep_.rowOfY(p.y)},
             glm::dvec3(mesh.color(triangle[k]))});
      }
      addInSector(sector, polygon);
    }
  }

  Volume take() { return std::move(volume_); }

 private:
  void addInSector(int sector, const std::vector<Point>& triangle) {
    const double slope = sweep_.tanHalfStep();
    const std::vector<Point> polygon =
        clip(triangle, {{{-slope, 1, 0}, options_.margin}, {{-slope, -1, 0}, options_.margin}});
    if (polygon.empty()) {
      return;
    }
    glm::dvec3 lo(std::numeric_limits<double>::infinity());
    glm::dvec3 hi = -lo;
    for (const Point& point : polygon) {
      lo = glm::dvec3(std::min(lo.x, point.at.x), 0, std::min(lo.z, point.at.z));
      hi = glm::dvec3(std::max(hi.x, point.at.x), 0, std::max(hi.z, point.at.z));
    }
    const double side = sweep_.sideOfSector(sector);
    const double axis = sweep_.columnsPerRadius();
    const Candidates columns(std::min(axis + side * lo.x, axis + side * hi.x),
                             std::max(axis + side * lo.x, axis + side * hi.x), sweep_.width());
    const Candidates rows(lo.z, hi.z, sweep_.height());
    for (int row = rows.first; row <= rows.last; ++row) {
      const std::vector<Point> inRow =
          clip(polygon, {{{0, 0, 1}, row + 1 + options_.margin}, {{0, 0, -1}, -row + options_.margin}});
      for (int column = columns.first; column <= columns.last && !inRow.empty(); ++column) {
        // side * outward + axis lies between column and column + 1
        const std::vector<Point> inCell = clip(inRow, {{{side, 0, 0}, column + 1 - axis + options_.margin},
                                                       {{-side, 0, 0}, axis - column + options_.margin}});
        if (!inCell.empty()) {
          light(sector, column, row, meanColor(inCell));
        }
      }
    }
  }

  static glm::vec3 meanColor(const std::vector<Point>& points) {
    glm::dvec3 sum(0);
    for (const Point& point : points) {
      sum += point.color;
    }
    return glm::vec3(sum / static_cast<double>(points.size()));
  }

  void light(int sector, int column, int row, glm::vec3 color) {
    if (options_.evenLightRadius > 0 && options_.colors != ColorReduction::kOccupancy) {
      color *= static_cast<float>(evenLightWeight(sector, column));
    }
    const int slice = sweep_.sliceOfSector(sector);
    store(slice, column, row, color);
    if (volume_.slices() > sweep_.slicesPerHalfTurn()) {
      store(slice + sweep_.slicesPerHalfTurn(), sweep_.width() - 1 - column, row, color);
    }
  }

  double evenLightWeight(int sector, int column) const {
    const glm::dvec2& direction = sweep_.sectorDirection(sector);
    const glm::dvec3 normal(normal_.x * direction.x + normal_.z * direction.y, normal_.y,
                            normal_.z * direction.x - normal_.x * direction.y);
    double even = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& n : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
      even = std::min(even, litCellsPerArea(sweep_, n, options_.evenLightRadius));
    }
    const double radius = EvenLight::columnRadius(sweep_, column);
    return std::min(1.0, even / litCellsPerArea(sweep_, normal, radius));
  }

  void store(int slice, int column, int row, const glm::vec3& color) {
    volume_.raise(slice, column, row, dither_.levels(color, volume_.fullLevel(), slice, column, row));
  }

  SweepGeometry sweep_;
  ReferenceOptions options_;
  VoxelDither dither_;
  Volume volume_;
  glm::dvec3 normal_{0};  ///< of the triangle that is being added
};

}  // namespace

Volume sliceReference(const Mesh& mesh, const DisplayProfile& profile, const ReferenceOptions& options) {
  ReferenceSlicer slicer(profile, options);
  for (const glm::uvec3& triangle : mesh.triangles) {
    slicer.add(mesh, triangle);
  }
  return slicer.take();
}

}  // namespace ocelli
