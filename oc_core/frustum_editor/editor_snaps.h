// What drawing snaps to: portals of the scene, corners of walls, viewpoints and planes of the camera, and a grid.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/frustum_editor/drawn_camera.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/scene_guides.h"

namespace ocelli {

struct SnapPoint {
  std::string what;  ///< "portal", "corner of a wall", "plane of left", "grid"
  glm::dvec2 at{0};  ///< on the paper
};

/// Where a plan cuts a scene: at the eye; where that is outside of all walls, a tenth of the scene's size from below,
/// or in the middle of a plan from a side.
double planCut(const Mesh& mesh, PlanSide side, const glm::dvec3& eye);

/// Of a scene in one plan: its portals, the middles and sides of them, and the ends of the cut of its walls at the
/// coordinate `cut` (plan_section.h).
std::vector<SnapPoint> sceneSnaps(const Mesh& mesh, const SceneGuides& guides, PlanSide side, double cut);

/// Of a camera in a plan: ends and middles of planes, and viewpoints, but those of the frustum `without`.
std::vector<SnapPoint> cameraSnaps(const DrawnCamera& camera, PlanSide side, const std::string& without);

/// The nearest point within `reach` on a plane of the camera as the plan shows it, but on those of the frustum
/// `without`.
std::optional<SnapPoint> snappedToPlane(const DrawnCamera& camera, PlanSide side, const std::string& without,
                                        const glm::dvec2& paper, double reach);

/// Lines of a grid are 1, 2 or 5 times a power of ten apart, and at least kMinGridPixels.
double gridStep(double unitsPerPixel);

/// The nearest of the points within `reach`; else the nearest point of a grid (none for a step of 0) within half of it;
/// else nothing.
std::optional<SnapPoint> snapped(const std::vector<SnapPoint>& points, const glm::dvec2& paper, double reach,
                                 double grid);

}  // namespace ocelli
