#include "oc_core/frustum_editor/editor_snaps.h"

#include <cmath>

#include "oc_core/multiperspective/plan_section.h"

namespace ocelli {
namespace {

constexpr double kMinGridPixels = 12;

/// Where a frustum begins, and its limits.
std::vector<const DrawnPlane*> planesOfDrawn(const DrawnFrustum& frustum) {
  std::vector<const DrawnPlane*> planes;
  if (frustum.operation != "root") {
    planes.push_back(&frustum.begins);
  }
  for (const DrawnPlane& limit : frustum.limits) {
    planes.push_back(&limit);
  }
  return planes;
}

}  // namespace

double planCut(const Mesh& mesh, PlanSide side, const glm::dvec3& eye) {
  const int axis = axisOf(side);
  if (!sectionOf(mesh, side, static_cast<float>(eye[axis])).empty()) {
    return eye[axis];
  }
  const Box bounds = boundsOf(mesh);
  const double share = side == PlanSide::kTop ? 0.1 : 0.5;
  return static_cast<double>(bounds.lower[axis]) + share * static_cast<double>(bounds.size()[axis]);
}

std::vector<SnapPoint> sceneSnaps(const Mesh& mesh, const SceneGuides& guides, PlanSide side, double cut) {
  std::vector<SnapPoint> points;
  const auto addPortal = [&](const Portal& portal, const std::string& name) {
    const glm::dvec3 center(portal.center);
    const glm::dvec3 half(side == PlanSide::kTop ? portal.halfRight : portal.halfUp);
    points.push_back({"middle of " + name, paperFromWorld(side, center)});
    points.push_back({"side of " + name, paperFromWorld(side, center - half)});
    points.push_back({"side of " + name, paperFromWorld(side, center + half)});
  };
  for (size_t i = 0; i < guides.portals.size(); ++i) {
    addPortal(guides.portals[i], "portal " + std::to_string(i + 1));
  }
  if (guides.walk) {
    for (size_t i = 0; i < guides.walk->portals.size(); ++i) {
      addPortal(guides.walk->portals[i].opening, "opening " + std::to_string(i + 1));
    }
  }
  for (const SectionLine& line : sectionOf(mesh, side, static_cast<float>(cut))) {
    points.push_back({"corner of a wall", glm::dvec2(line[0])});
    points.push_back({"corner of a wall", glm::dvec2(line[1])});
  }
  return points;
}

std::vector<SnapPoint> cameraSnaps(const DrawnCamera& camera, PlanSide side, const std::string& without) {
  std::vector<SnapPoint> points;
  for (const DrawnFrustum& frustum : camera.frusta) {
    if (frustum.name == without) {
      continue;
    }
    points.push_back({"viewpoint of " + frustum.name, paperFromWorld(side, frustum.viewpoint)});
    for (const DrawnPlane* plane : planesOfDrawn(frustum)) {
      if (const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(*plane, side)) {
        points.push_back({"plane of " + frustum.name, paperFromWorld(side, (*ends)[0])});
        points.push_back({"plane of " + frustum.name, paperFromWorld(side, (*ends)[1])});
        points.push_back({"middle of the plane of " + frustum.name, paperFromWorld(side, plane->middle)});
      }
    }
  }
  return points;
}

std::optional<SnapPoint> snappedToPlane(const DrawnCamera& camera, PlanSide side, const std::string& without,
                                        const glm::dvec2& paper, double reach) {
  std::optional<SnapPoint> nearest;
  for (const DrawnFrustum& frustum : camera.frusta) {
    if (frustum.name == without) {
      continue;
    }
    for (const DrawnPlane* plane : planesOfDrawn(frustum)) {
      const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(*plane, side);
      if (!ends) {
        continue;
      }
      const glm::dvec2 from = paperFromWorld(side, (*ends)[0]);
      const glm::dvec2 along = paperFromWorld(side, (*ends)[1]) - from;
      const double length = glm::dot(along, along);
      const double share = length > 0 ? glm::clamp(glm::dot(paper - from, along) / length, 0.0, 1.0) : 0;
      const glm::dvec2 at = from + along * share;
      if (glm::distance(at, paper) <= (nearest ? glm::distance(nearest->at, paper) : reach)) {
        nearest = SnapPoint{"on the plane of " + frustum.name, at};
      }
    }
  }
  return nearest;
}

double gridStep(double unitsPerPixel) {
  const double wanted = unitsPerPixel * kMinGridPixels;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= wanted) {
      return factor * power;
    }
  }
  return 10 * power;
}

std::optional<SnapPoint> snapped(const std::vector<SnapPoint>& points, const glm::dvec2& paper, double reach,
                                 double grid) {
  const SnapPoint* nearest = nullptr;
  for (const SnapPoint& point : points) {
    const double distance = glm::distance(point.at, paper);
    if (distance <= reach && (nearest == nullptr || distance < glm::distance(nearest->at, paper))) {
      nearest = &point;
    }
  }
  if (nearest != nullptr) {
    return *nearest;
  }
  if (grid > 0) {
    const SnapPoint onGrid{"grid", glm::round(paper / grid) * grid};
    if (glm::distance(onGrid.at, paper) <= reach / 2) {
      return onGrid;
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
