#include "oc_core/scene/point_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/box.h"
#include "oc_core/scene/point_orientation.h"
#include "oc_core/scene/point_shape.h"
#include "oc_core/scene/point_tree.h"
#include "oc_core/scene/scene.h"

namespace ocelli {
namespace {

constexpr size_t kPointsPerRange = 1 << 12;
/// Enough for a plane that noise does not turn, and few enough to stay on one surface.
constexpr size_t kNeighbors = 10;
static_assert(kNeighbors <= PointTree::kMaxNeighbors && kNeighbors <= kMaxPanelNeighbors);
/// Along which orientation spreads.
constexpr size_t kLinks = 8;
/// As many as a point of an even surface has around it.
constexpr size_t kNearest = 6;
/// Of panels over their cells: what surfaces that bend need, whose cells end in different planes.
constexpr float kOverlap = 1.15f;
/// How far a cell reaches where no neighbour ends it, over the mean distance of the nearest.
constexpr float kOpenReach = 1.4f;
/// The radius of an octahedron over that distance: two of them overlap.
constexpr float kSolidReach = 0.75f;
constexpr float kWidestOverMedian = 4;

constexpr size_t kPanelTriangles = 2;
constexpr size_t kSolidTriangles = 8;
constexpr size_t kPanelVertices = 4;
constexpr size_t kSolidVertices = 6;

constexpr glm::vec3 kNoPlane(0);

class PointMesher {
 public:
  PointMesher(PointCloud cloud, const PointSceneOptions& options, const std::string& where, const Progress& progress,
              std::vector<uint32_t>* sources)
      : cloud_(std::move(cloud)), options_(options), where_(where), progress_(progress), sources_(sources) {}

  PointMesh run() {
    facts_.points = cloud_.positions.size();
    facts_.areWidthsChosen = !options_.width.has_value();
    check();
    report(progress_, "looking at the points", 0);
    normalize();
    dropRepeated();
    if (count() == 1 && !options_.width) {
      throw InputError(facts_.points == 1 ? "this is one point, whose size nothing tells"
                                          : "all points stand at one place, so that nothing tells their size",
                       where_, "give --point-size");
    }
    report(progress_, "looking at the points", 0.1);
    measure();
    report(progress_, "looking at the points", 0.8);
    limitWidths();
    Mesh mesh = build();
    report(progress_, "looking at the points", 1);
    return {std::move(mesh), facts_};
  }

 private:
  size_t count() const { return cloud_.positions.size(); }

  void check() const {
    if (cloud_.positions.empty()) {
      throw InputError("the file has no points", where_, "export it again");
    }
    OC_CHECK(cloud_.colors.empty() || cloud_.colors.size() == count(), "each point has a colour, or none has one");
    OC_CHECK(cloud_.normals.empty() || cloud_.normals.size() == count(), "each point has a normal, or none has one");
    for (size_t i = 0; i < count(); ++i) {
      if (!isFinite(cloud_.positions[i])) {
        throw InputError("point " + std::to_string(i) + " has a coordinate that is not a finite number", where_,
                         "leave it out, or export the points again");
      }
    }
  }

  /// Rounding may have put points at one place that were not.
  void dropRepeated() {
    std::vector<uint32_t> order(count());
    std::iota(order.begin(), order.end(), 0u);
    const auto place = [&](uint32_t i) {
      const glm::vec3& p = cloud_.positions[i];
      return std::tie(p.x, p.y, p.z);
    };
    std::ranges::sort(order,
                      [&](uint32_t a, uint32_t b) { return place(a) != place(b) ? place(a) < place(b) : a < b; });
    std::vector<bool> isRepeated(count(), false);
    for (size_t i = 1; i < order.size(); ++i) {
      if (place(order[i]) == place(order[i - 1])) {
        isRepeated[order[i]] = true;
        ++facts_.repeated;
      }
    }
    if (facts_.repeated > 0) {
      for (std::vector<glm::vec3>* list : {&cloud_.positions, &cloud_.colors, &cloud_.normals}) {
        if (!list->empty()) {
          size_t kept = 0;
          for (size_t i = 0; i < list->size(); ++i) {
            if (!isRepeated[i]) {
              (*list)[kept++] = (*list)[i];
            }
          }
          list->resize(kept);
        }
      }
    }
    for (uint32_t i = 0; sources_ != nullptr && i < isRepeated.size(); ++i) {
      if (!isRepeated[i]) {
        pointsInFile_.push_back(i);
      }
    }
  }

  /// Moves the points into the box from -1 to 1, where squares of distances are numbers.
  void normalize() {
    Box box;
    for (const glm::vec3& p : cloud_.positions) {
      box.add(p);
    }
    center_ = (glm::dvec3(box.lower) + glm::dvec3(box.upper)) * 0.5;
    const glm::dvec3 half = glm::dvec3(box.upper) - center_;
    const double reach = std::max({half.x, half.y, half.z});
    scale_ = reach > 0 ? reach : 1;
    parallelFor(count(), kPointsPerRange, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        cloud_.positions[i] = glm::vec3((glm::dvec3(cloud_.positions[i]) - center_) / scale_);
      }
    });
  }

  /// Finds the plane of each point, and how far its neighbours are.
  void measure() {
    const PointTree tree(cloud_.positions);
    const bool estimate = cloud_.normals.empty();
    planes_.assign(count(), kNoPlane);
    spacings_.assign(count(), 0.0f);
    std::vector<uint8_t> isSurface(count(), 1);
    std::vector<uint32_t> links(estimate ? count() * kLinks : 0, kNoNeighbor);
    parallelFor(count(), kPointsPerRange, [&](size_t begin, size_t end) {
      std::array<PointNeighbor, PointTree::kMaxNeighbors> found;
      for (size_t place = begin; place < end; ++place) {
        const uint32_t i = tree.pointAt(place);
        const std::span<const PointNeighbor> nearest = tree.nearest(i, cloud_.positions[i], kNeighbors, found);
        spacings_[i] = meanDistance(nearest.first(std::min(kNearest, nearest.size())));
        std::array<glm::vec3, kNeighbors> offsets;
        if (!estimate) {
          planes_[i] = unitOrNone(cloud_.normals[i]);
        } else if (!nearest.empty()) {
          const PointPlane plane = fittingPlane(offsetsOf(i, nearest, offsets));
          planes_[i] = plane.normal;
          isSurface[i] = plane.isSurface ? 1 : 0;
        }
        for (size_t k = 0; estimate && k < std::min(kLinks, nearest.size()); ++k) {
          links[i * kLinks + k] = nearest[k].point;
        }
      }
    });
    cloud_.normals = {};
    report(progress_, "looking at the points", 0.4);
    if (estimate) {
      // Points of sharp edges have no panel, but lead from one side to the other.
      orientNormals(cloud_.positions, links, kLinks, planes_);
      links = {};
      for (size_t i = 0; i < count(); ++i) {
        planes_[i] = isSurface[i] != 0 ? planes_[i] : kNoPlane;
      }
    }
    report(progress_, "looking at the points", 0.6);
    panels_.resize(count());
    parallelFor(count(), kPointsPerRange, [&](size_t begin, size_t end) {
      std::array<PointNeighbor, PointTree::kMaxNeighbors> found;
      for (size_t place = begin; place < end; ++place) {
        const uint32_t i = tree.pointAt(place);
        if (planes_[i] != kNoPlane) {
          panels_[i] = panelOf(i, tree.nearest(i, cloud_.positions[i], kNeighbors, found));
        }
      }
    });
  }

  static float meanDistance(std::span<const PointNeighbor> nearest) {
    float sum = 0;
    for (const PointNeighbor& neighbor : nearest) {
      sum += std::sqrt(neighbor.distance2);
    }
    return nearest.empty() ? 0.0f : sum / static_cast<float>(nearest.size());
  }

  static glm::vec3 unitOrNone(const glm::vec3& normal) {
    const double length = glm::length(glm::dvec3(normal));
    return length > 0 && std::isfinite(length) ? glm::vec3(glm::dvec3(normal) / length) : kNoPlane;
  }

  std::span<const glm::vec3> offsetsOf(uint32_t i, std::span<const PointNeighbor> nearest,
                                       std::array<glm::vec3, kNeighbors>& offsets) const {
    for (size_t k = 0; k < nearest.size(); ++k) {
      offsets[k] = cloud_.positions[nearest[k].point] - cloud_.positions[i];
    }
    return {offsets.data(), nearest.size()};
  }

  PointPanel panelOf(uint32_t i, std::span<const PointNeighbor> nearest) const {
    std::array<glm::vec3, kNeighbors> room;
    const std::span<const glm::vec3> offsets = offsetsOf(i, nearest, room);
    if (options_.width) {
      return squarePanel(offsets, planes_[i], static_cast<float>(*options_.width / 2 / scale_));
    }
    PointPanel panel = cellPanel(offsets, planes_[i], kOpenReach * spacings_[i]);
    panel.halfX *= kOverlap;
    panel.halfY *= kOverlap;
    return panel;
  }

  float widthOf(size_t i) const {
    if (planes_[i] != kNoPlane) {
      return 2 * std::max(glm::length(panels_[i].halfX), glm::length(panels_[i].halfY));
    }
    return options_.width ? static_cast<float>(*options_.width / scale_) : 2 * kSolidReach * spacings_[i];
  }

  /// Finds the widths and makes none larger than some times the median.
  void limitWidths() {
    widths_.resize(count());
    parallelFor(count(), kPointsPerRange, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        widths_[i] = widthOf(i);
      }
    });
    std::vector<float> sorted = widths_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const float median = *middle;
    const float most = kWidestOverMedian * median;
    float narrowest = std::numeric_limits<float>::max();
    float widest = 0;
    for (size_t i = 0; i < count(); ++i) {
      if (widths_[i] > most) {
        const float factor = most / widths_[i];
        widths_[i] = most;
        panels_[i] = {panels_[i].center * factor, panels_[i].halfX * factor, panels_[i].halfY * factor};
      }
      narrowest = std::min(narrowest, widths_[i]);
      widest = std::max(widest, widths_[i]);
      ++(planes_[i] != kNoPlane ? facts_.panels : facts_.solids);
    }
    facts_.narrowest = scale_ * static_cast<double>(narrowest);
    facts_.medianWidth = scale_ * static_cast<double>(median);
    facts_.widest = scale_ * static_cast<double>(widest);
  }

  Mesh build() {
    const size_t triangles = kPanelTriangles * facts_.panels + kSolidTriangles * facts_.solids;
    if (triangles > kMaxSceneTriangles) {
      throw InputError(fmt::format("{} of these {} points are no surface, and the closed solids that stand for them "
                                   "make {} triangles, more than the {} that fit into memory",
                                   facts_.solids, count(), triangles, kMaxSceneTriangles),
                       where_, "leave points out, or give them normals");
    }
    Mesh mesh;
    mesh.positions.reserve(kPanelVertices * facts_.panels + kSolidVertices * facts_.solids);
    mesh.colors.reserve(cloud_.colors.empty() ? 0 : mesh.positions.capacity());
    mesh.triangles.reserve(triangles);
    for (size_t i = 0; i < count(); ++i) {
      if (planes_[i] != kNoPlane) {
        addPanel(mesh, i);
      } else {
        addSolid(mesh, i);
      }
      if (!cloud_.colors.empty()) {
        mesh.colors.resize(mesh.positions.size(), cloud_.colors[i]);
      }
      if (sources_ != nullptr) {
        sources_->resize(mesh.positions.size(), pointsInFile_[i]);
      }
    }
    return mesh;
  }

  void addVertex(Mesh& mesh, const glm::vec3& position) const {
    mesh.positions.push_back(glm::vec3(glm::dvec3(position) * scale_ + center_));
  }

  void addPanel(Mesh& mesh, size_t i) const {
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    const PointPanel& panel = panels_[i];
    const glm::vec3 center = cloud_.positions[i] + panel.center;
    addVertex(mesh, center - panel.halfX - panel.halfY);
    addVertex(mesh, center + panel.halfX - panel.halfY);
    addVertex(mesh, center + panel.halfX + panel.halfY);
    addVertex(mesh, center - panel.halfX + panel.halfY);
    mesh.triangles.push_back({base, base + 1, base + 2});
    mesh.triangles.push_back({base, base + 2, base + 3});
  }

  void addSolid(Mesh& mesh, size_t i) const {
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    const float radius = widths_[i] / 2;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      for (const float side : {radius, -radius}) {
        glm::vec3 corner = cloud_.positions[i];
        corner[axis] += side;
        addVertex(mesh, corner);
      }
    }
    // Corners 0 and 1 are on the x axis, 2 and 3 on the y axis, 4 and 5 on the z axis.
    for (uint32_t octant = 0; octant < kSolidTriangles; ++octant) {
      const uint32_t x = base + (octant & 1u);
      const uint32_t y = base + 2 + (octant >> 1u & 1u);
      const uint32_t z = base + 4 + (octant >> 2u & 1u);
      const bool mirrored = (octant == 1 || octant == 2 || octant == 4 || octant == 7);
      mesh.triangles.push_back(mirrored ? glm::uvec3(x, z, y) : glm::uvec3(x, y, z));
    }
  }

  PointCloud cloud_;
  const PointSceneOptions& options_;
  const std::string& where_;
  const Progress& progress_;
  std::vector<uint32_t>* sources_;
  std::vector<uint32_t> pointsInFile_;  ///< of each point that is kept; empty where no one asks
  PointFacts facts_;
  glm::dvec3 center_{0};
  double scale_ = 1;               ///< units of the scene in one of the box
  std::vector<glm::vec3> planes_;  ///< unit normals; kNoPlane for octahedra
  std::vector<float> spacings_;    ///< mean distances of the nearest
  std::vector<PointPanel> panels_;
  std::vector<float> widths_;
};

}  // namespace

PointMesh meshOfPoints(PointCloud cloud, const PointSceneOptions& options, const std::string& where,
                       const Progress& progress, std::vector<uint32_t>* sources) {
  if (sources != nullptr) {
    sources->clear();
  }
  return PointMesher(std::move(cloud), options, where, progress, sources).run();
}

}  // namespace ocelli
