// The edits (camera_editor.h) that drawing makes, as JSON. Coordinates are rounded, so that files can be read.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "oc_core/frustum_editor/drawn_camera.h"

namespace ocelli {

/// A plane as files have it.
struct DrawnEditPlane {
  glm::dvec3 point{0};
  glm::dvec3 normal{0, 0, -1};
};

class DrawnEdits {
 public:
  explicit DrawnEdits(const DrawnCamera& camera) : camera_(camera) {}

  std::string view(const View& view) const;
  std::string viewpoint(const std::string& name, const glm::dvec3& at) const;
  /// `field` is "plane" of a frustum; "from", "middle" or "to" of a turn.
  std::string plane(const std::string& name, const char* field, const DrawnEditPlane& plane) const;
  std::string part(const std::string& name, const GraphCamera::Part& shares) const;
  std::string limits(const std::string& name, std::span<const DrawnEditPlane> planes) const;
  /// An empty part stands for all rays.
  std::string addBend(const std::string& of, const std::string& name, const DrawnEditPlane& plane,
                      const glm::dvec3& viewpoint, const GraphCamera::Part& shares) const;
  std::string addSplit(const std::string& of, std::span<const std::string, 2> names,
                       std::span<const DrawnEditPlane, 2> planes, const glm::dvec3& viewpoint) const;
  std::string addMerge(std::span<const std::string, 2> of, const std::string& name, const DrawnEditPlane& plane,
                       const glm::dvec3& viewpoint) const;
  std::string addTurn(const std::string& name, std::span<const DrawnEditPlane, 3> planes,
                      const glm::dvec3& viewpoint) const;
  static std::string remove(const std::string& name);
  static std::string rename(const std::string& name, const std::string& to);
  static std::string overlap(bool allowed);
  /// As one step.
  static std::string several(std::span<const std::string> edits);

  /// The limits that a frustum has.
  static std::vector<DrawnEditPlane> limitsOf(const DrawnFrustum& frustum);

 private:
  const DrawnCamera& camera_;
};

/// To the nearest multiple of a power of ten.
double roundedTo(double value, double powerOfTen);

}  // namespace ocelli
