// Handles of the borders of a part: which rays of its parent a bend takes. A border is an edge of the part within the
// image, upright in a plan from above and level in one from the side. A neighbour that has the same border moves with
// it.
#include <algorithm>
#include <cmath>
#include <optional>

#include "oc_core/base/error.h"
#include "oc_core/frustum_editor/drawn_edits.h"
#include "oc_core/frustum_editor/drawn_volumes.h"
#include "oc_core/frustum_editor/handle_list.h"

namespace ocelli {
namespace {

constexpr double kSameShare = 2e-4;  // of the image: borders that are nearer to each other are one

/// The coordinate of the image that a plan shows the borders of: u from above, v from a side.
int borderAxis(PlanSide side) {
  return side == PlanSide::kTop ? 0 : 1;
}

/// Whether edge `i` of a part runs across the axis.
bool isBorder(const GraphCamera::Part& part, size_t i, int axis) {
  const glm::dvec2& a = part[i];
  const glm::dvec2& b = part[(i + 1) % part.size()];
  return std::abs(a[axis] - b[axis]) < kSameShare && std::abs(a[1 - axis] - b[1 - axis]) >= kSameShare;
}

bool isBentPart(const DrawnFrustum& frustum) {
  return frustum.operation == "bend" && !frustum.part.empty() && frustum.indices.size() == 1;
}

std::vector<FrustumHandle> bordersOf(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide side) {
  std::vector<FrustumHandle> handles;
  if (!isBentPart(frustum)) {
    return handles;
  }
  const std::vector<glm::dvec3> crossings = crossingsOf(camera.graph(), frustum.indices[0]);
  if (crossings.size() != frustum.part.size()) {
    return handles;
  }
  for (size_t i = 0; i < frustum.part.size(); ++i) {
    if (isBorder(frustum.part, i, borderAxis(side))) {
      FrustumHandle handle;
      handle.index = static_cast<int>(i);
      handle.at = (crossings[i] + crossings[(i + 1) % crossings.size()]) * 0.5;
      handles.push_back(handle);
    }
  }
  return handles;
}

/// What a part has of a border: from where to where along it, and whether the part lies beyond it, to the right or
/// below.
struct BorderPiece {
  double first = 0;
  double last = 0;
  bool isBeyond = false;
};

std::optional<BorderPiece> pieceOfBorder(const GraphCamera::Part& part, int axis, double at) {
  BorderPiece piece{1, 0, GraphCamera::middleOf(part)[axis] > at};
  for (const glm::dvec2& corner : part) {
    if (std::abs(corner[axis] - at) < kSameShare) {
      piece.first = std::min(piece.first, corner[1 - axis]);
      piece.last = std::max(piece.last, corner[1 - axis]);
    }
  }
  return piece.last - piece.first >= kSameShare ? std::optional(piece) : std::nullopt;
}

/// The border of the frustum, and of those on its other side that share a piece of it.
std::string moveBorder(const DrawnCamera& camera, const FrustumHandle& handle, double to) {
  const DrawnFrustum& frustum = *camera.find(handle.frustum);
  const int axis = borderAxis(handle.side);
  const double from = frustum.part.at(static_cast<size_t>(handle.index))[axis];
  const std::optional<BorderPiece> own = pieceOfBorder(frustum.part, axis, from);
  if (!(to >= 0 && to <= 1)) {
    throw InputError("the border would be outside of the image", "\"" + frustum.name + "\"",
                     "keep it between 0 and 100 %");
  }
  std::vector<std::string> edits;
  for (const DrawnFrustum& each : camera.frusta) {
    if (!isBentPart(each) || each.of != frustum.of) {
      continue;
    }
    const std::optional<BorderPiece> piece = pieceOfBorder(each.part, axis, from);
    const bool isShared = own && piece && piece->isBeyond != own->isBeyond &&
                          std::min(piece->last, own->last) - std::max(piece->first, own->first) >= kSameShare;
    if (each.name != frustum.name && !isShared) {
      continue;
    }
    GraphCamera::Part part = each.part;
    for (glm::dvec2& corner : part) {
      corner[axis] = std::abs(corner[axis] - from) < kSameShare ? to : corner[axis];
    }
    edits.push_back(DrawnEdits(camera).part(each.name, part));
  }
  return DrawnEdits::several(edits);
}

std::string dragBorder(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const DrawnFrustum& frustum = *camera.find(handle.frustum);
  const GraphCamera::Frustum& inside = camera.graph().frusta()[static_cast<size_t>(frustum.indices[0])];
  // Seen through the parent: where the rays that come to the plane pass the image.
  const GraphCamera::Frustum& parent = camera.graph().frusta()[static_cast<size_t>(inside.parent)];
  const glm::dvec4 image = parent.pixelFromWorld * glm::dvec4(to, 1);
  if (!(image.w > 0)) {
    throw InputError("the border would be behind the rays", "\"" + frustum.name + "\"", "drag it along the plane");
  }
  const int axis = borderAxis(handle.side);
  const double share = (axis == 0 ? image.x : image.y) / image.w / camera.imageSize()[axis];
  return moveBorder(camera, handle, std::clamp(share, 0.0, 1.0));
}

std::vector<HandleNumber> borderNumbers(const DrawnCamera& camera, const FrustumHandle& handle) {
  const DrawnFrustum& frustum = *camera.find(handle.frustum);
  const int axis = borderAxis(handle.side);
  return {{axis == 0 ? "from the left" : "from the top", "%",
           100 * frustum.part.at(static_cast<size_t>(handle.index))[axis],
           [&camera, handle](double value) { return moveBorder(camera, handle, value / 100); }}};
}

}  // namespace

HandleKind partBorderHandle() {
  return {"part border",
          "moves the border between what bends here and what does not",
          Marker::kTriangleDown,
          bordersOf,
          dragBorder,
          borderNumbers};
}

}  // namespace ocelli
