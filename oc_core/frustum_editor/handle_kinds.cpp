#include "oc_core/frustum_editor/handle_kinds.h"

#include "oc_core/base/error.h"
#include "oc_core/frustum_editor/handle_list.h"

namespace ocelli {

const std::vector<HandleKind>& handleKinds() {
  static const std::vector<HandleKind> kinds{
      eyeHandle(),      targetHandle(),     fieldOfViewHandle(), viewpointHandle(),  aimHandle(),
      planeHandle(),    planeEndHandle(),   splitEdgeHandle(),   partBorderHandle(), limitHandle(),
      limitEndHandle(), turnMiddleHandle(), turnLineHandle(),    turnPlaneHandle()};
  return kinds;
}

const HandleKind& handleKind(const std::string& name) {
  std::string names;
  for (const HandleKind& kind : handleKinds()) {
    if (kind.name == name) {
      return kind;
    }
    names += (names.empty() ? "" : ", ") + kind.name;
  }
  throw InputError("there are no handles called \"" + name + "\"", "handle", "use one of these: " + names);
}

std::vector<FrustumHandle> handlesOf(const DrawnCamera& camera, PlanSide side) {
  std::vector<FrustumHandle> handles;
  for (const DrawnFrustum& frustum : camera.frusta) {
    for (const HandleKind& kind : handleKinds()) {
      for (FrustumHandle handle : kind.of(camera, frustum, side)) {
        handle.kind = &kind;
        handle.frustum = frustum.name;
        handle.side = side;
        handles.push_back(std::move(handle));
      }
    }
  }
  return handles;
}

std::vector<HandleNumber> numbersOf(const DrawnCamera& camera, const FrustumHandle& handle) {
  std::vector<HandleNumber> numbers;
  for (int axis = 0; axis < 3; ++axis) {
    numbers.push_back(
        {std::string(1, static_cast<char>('x' + axis)), "", handle.at[axis], [&camera, handle, axis](double value) {
           glm::dvec3 to = handle.at;
           to[axis] = value;
           return handle.kind->drag(camera, handle, to);
         }});
  }
  if (handle.kind->numbers != nullptr) {
    for (HandleNumber& number : handle.kind->numbers(camera, handle)) {
      numbers.push_back(std::move(number));
    }
  }
  return numbers;
}

}  // namespace ocelli
