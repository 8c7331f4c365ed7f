// What one takes hold of in a plan of a camera: viewpoints, the ends of planes, borders of parts, limits. A kind of
// handle is a row of handleKinds(): where its handles are, what an edit (camera_editor.h) does when one is dragged, and
// the numbers beside it. To add a kind: a function in one of the *_handles.cpp files that returns its row, declared in
// handle_list.h, and the row in handle_kinds.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oc_core/drawing/drawing.h"
#include "oc_core/frustum_editor/drawn_camera.h"

namespace ocelli {

struct HandleKind;

struct FrustumHandle {
  const HandleKind* kind = nullptr;
  std::string frustum;  ///< its name
  int index = 0;        ///< which of its kind the frustum has
  PlanSide side = PlanSide::kTop;
  glm::dvec3 at{0};

  /// Whether it is the same handle, wherever it is.
  bool isSame(const FrustumHandle& other) const {
    return kind == other.kind && frustum == other.frustum && index == other.index;
  }
};

/// A number beside a handle: one reads it and types another.
struct HandleNumber {
  std::string name;  ///< "x", "heading"
  std::string unit;  ///< "" for lengths of the scene, "degrees", "%"
  double value = 0;
  /// The edit that gives it another value. Throws InputError where it cannot have that.
  std::function<std::string(double)> edit;
};

struct HandleKind {
  std::string name;                 ///< in scripts, and beside the handle: "viewpoint"
  std::string says;                 ///< what dragging it does, in a line
  Marker marker = Marker::kCircle;  ///< what it looks like
  /// Those of a frustum in a plan.
  std::vector<FrustumHandle> (*of)(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide side);
  /// The edit that moves it: the text of an edit of CameraEditor. Throws InputError where it cannot be there.
  std::string (*drag)(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to);
  /// Besides x, y and z, which all have.
  std::vector<HandleNumber> (*numbers)(const DrawnCamera& camera, const FrustumHandle& handle) = nullptr;
};

const std::vector<HandleKind>& handleKinds();
/// Throws InputError for a name that none has.
const HandleKind& handleKind(const std::string& name);

/// All of a camera in a plan, in the order of frusta and of kinds.
std::vector<FrustumHandle> handlesOf(const DrawnCamera& camera, PlanSide side);

/// x, y and z, and what the kind has besides. The camera must live as long as their edits.
std::vector<HandleNumber> numbersOf(const DrawnCamera& camera, const FrustumHandle& handle);

}  // namespace ocelli
