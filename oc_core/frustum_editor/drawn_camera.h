// A camera as an editor draws it: each frustum of its file by the name that it has there, with the points, planes and
// directions that one takes hold of, and the outlines that its rays fill in a plan.
//
// Of a curved ray camera each turn counts as a frustum: what its rays fill behind it. The root comes first.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/frustum_editor/plan_window.h"

namespace ocelli {

/// A plane, and where the rays that it is for cross it.
struct DrawnPlane {
  Plane plane;
  glm::dvec3 point{0};              ///< of the plane, as the file gives it
  std::vector<glm::dvec3> polygon;  ///< convex; empty where no ray comes to it within the scene
  glm::dvec3 middle{0};             ///< where the middle ray of a frustum crosses it; of others, of the polygon
};

/// Corners of a convex piece of space.
using DrawnVolume = std::vector<glm::dvec3>;

struct DrawnFrustum {
  std::string name;
  std::string operation;        ///< that made it: "root", "bend", "split", "merge", "turn"
  std::vector<std::string> of;  ///< what it comes from: two after a merge
  int depth = 0;                ///< how many are between it and the root, plus 1; 0 for the root
  bool hasChildren = false;
  std::vector<int> indices;  ///< of GraphCamera::frusta(): two after a merge. Of a turn: of CurvedRayCamera::bends()
  glm::dvec3 viewpoint{0};
  DrawnPlane begins;        ///< where it begins: of the root zNear, of a turn its middle plane
  glm::dvec3 direction{0};  ///< unit; of its middle ray, behind that plane
  std::vector<DrawnPlane> limits;
  GraphCamera::Part part;            ///< of a bend that takes a part: in shares of the image
  std::vector<DrawnPlane> turn;      ///< from, middle and to; of a turn alone
  glm::dvec3 turnLine{0};            ///< where these meet, beside the middle of the rays
  glm::dvec3 turnLineDirection{0};   ///< unit
  std::vector<DrawnVolume> volumes;  ///< that its rays fill in the scene
};

struct DrawnOverlap {
  std::string first;  ///< as the camera calls them: "behind of left" after a merge
  std::string second;
  glm::dvec3 point{0};               ///< the witness: both hold it
  std::vector<DrawnVolume> volumes;  ///< that both hold
};

struct DrawnCamera {
  std::shared_ptr<const MultiperspectiveCamera> camera;
  bool overlapAllowed = false;
  View view;
  Box room;             ///< the bounds of the scene and the root's eye: where volumes end
  double rounding = 0;  ///< of coordinates that edits write: a power of ten
  std::vector<DrawnFrustum> frusta;
  std::vector<DrawnOverlap> overlaps;  ///< of a graph camera; each pair once

  bool isGraph() const { return std::holds_alternative<GraphCamera>(*camera); }
  const GraphCamera& graph() const { return std::get<GraphCamera>(*camera); }
  glm::dvec2 imageSize() const;
  /// Nothing where no frustum is called so.
  const DrawnFrustum* find(const std::string& name) const;
  /// A name that none has: "frustum 3".
  std::string freeName() const;
};

/// `text` is the file of `camera`, which CameraEditor::cameraOf() has read. Overlaps are looked for within `world`,
/// which is not empty.
DrawnCamera drawnCamera(const std::string& text, const MultiperspectiveCamera& camera, const Box& world);

/// The outline of points on the paper of a plan, convex; empty where they lie in a line.
std::vector<glm::dvec2> outlineOf(const DrawnVolume& points, PlanSide side);
bool isWithin(const std::vector<glm::dvec2>& outline, const glm::dvec2& paper);

/// The two ends of a plane as a plan shows it: where its polygon reaches farthest to both sides. Nothing where the plan
/// does not see it from the side, or no ray comes to it.
std::optional<std::array<glm::dvec3, 2>> endsOf(const DrawnPlane& plane, PlanSide side);

/// The frustum that a point of a plan belongs to: the deepest in the camera of those whose outlines hold it,
/// `preferred` before others. Null for none.
const DrawnFrustum* frustumAt(const DrawnCamera& camera, PlanSide side, const glm::dvec2& paper,
                              const std::string& preferred = "");

}  // namespace ocelli
