#include "oc_core/frustum_editor/stroke_frusta.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "oc_core/base/error.h"
#include "oc_core/constructor/image_parts.h"

namespace ocelli {
namespace {

constexpr int kStrokeSamples = 32;

const GraphCamera::Frustum& insideOf(const DrawnCamera& camera, const DrawnFrustum& frustum) {
  if (frustum.indices.size() != 1) {
    throw InputError("\"" + frustum.name + "\" is merged from two, which share no part of the image", "plan",
                     "bend all of it with the tool \"bend\"");
  }
  return camera.graph().frusta()[static_cast<size_t>(frustum.indices[0])];
}

/// The largest piece of a part that no child of the frustum takes.
GraphCamera::Part largestFree(const DrawnCamera& camera, const GraphCamera::Frustum& inside,
                              const GraphCamera::Part& part) {
  std::vector<GraphCamera::Part> pieces{part};
  for (const int child : inside.children) {
    std::vector<GraphCamera::Part> left;
    for (const GraphCamera::Part& piece : pieces) {
      for (GraphCamera::Part& each : less(piece, camera.graph().frusta()[static_cast<size_t>(child)].part)) {
        left.push_back(std::move(each));
      }
    }
    pieces = std::move(left);
  }
  const auto area = [](const GraphCamera::Part& piece) {
    double twice = 0;
    for (size_t i = 0; i < piece.size(); ++i) {
      const glm::dvec2& a = piece[i];
      const glm::dvec2& b = piece[(i + 1) % piece.size()];
      twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice);
  };
  const auto largest =
      std::max_element(pieces.begin(), pieces.end(), [&](const auto& a, const auto& b) { return area(a) < area(b); });
  return largest == pieces.end() ? GraphCamera::Part{} : *largest;
}

GraphCamera::Part inShares(GraphCamera::Part part, const glm::dvec2& imageSize) {
  for (glm::dvec2& corner : part) {
    corner /= imageSize;
  }
  return part;
}

[[noreturn]] void failTaken(const DrawnFrustum& frustum) {
  throw InputError("all rays of \"" + frustum.name + "\" that pass there go on to other frusta", "plan",
                   "draw in one of those, or delete one");
}

}  // namespace

const DrawnFrustum& frustumUnder(const DrawnCamera& camera, PlanSide side, const glm::dvec2& paper,
                                 const std::string& selected) {
  const DrawnFrustum* found = frustumAt(camera, side, paper, selected);
  if (found == nullptr) {
    throw InputError("there are no rays of the camera", "plan", "draw where its frusta are");
  }
  return *found;
}

const DrawnFrustum& frustumOfStroke(const DrawnCamera& camera, const PlanStroke& stroke, const std::string& selected) {
  std::map<const DrawnFrustum*, int> crossed;
  for (int i = 0; i <= kStrokeSamples; ++i) {
    const glm::dvec2 paper = stroke.from + (stroke.to - stroke.from) * (static_cast<double>(i) / kStrokeSamples);
    if (const DrawnFrustum* frustum = frustumAt(camera, stroke.side, paper, selected)) {
      ++crossed[frustum];
    }
  }
  const auto most = std::max_element(crossed.begin(), crossed.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == crossed.end() ? frustumUnder(camera, stroke.side, stroke.from) : *most->first;
}

glm::dvec3 onMiddleRays(const DrawnFrustum& frustum, PlanSide side, const glm::dvec2& paper) {
  const int axis = axisOf(side);
  const glm::dvec2 start = paperFromWorld(side, frustum.begins.middle);
  const glm::dvec2 along = paperFromWorld(side, frustum.direction);
  const double length = glm::dot(along, along);
  // Of rays that run along the axis of the plan, no depth is better than another.
  const double steps = length > 1e-6 ? std::max(0.0, glm::dot(paper - start, along) / length) : 0;
  return worldFromPaper(side, paper, frustum.begins.middle[axis] + frustum.direction[axis] * steps);
}

GraphCamera::Part partBetween(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide side,
                              const glm::dvec2& a, const glm::dvec2& b) {
  const GraphCamera::Frustum& inside = insideOf(camera, frustum);
  const int axis = side == PlanSide::kTop ? 0 : 1;
  const glm::dvec2 size = camera.imageSize();
  double low = size[axis];
  double high = 0;
  for (const glm::dvec2& end : {a, b}) {
    const glm::dvec4 image = inside.pixelFromWorld * glm::dvec4(onMiddleRays(frustum, side, end), 1);
    if (!(image.w > 0)) {
      throw InputError("the stroke reaches behind the plane of \"" + frustum.name + "\"", "plan",
                       "draw it across the rays");
    }
    const double at = (axis == 0 ? image.x : image.y) / image.w;
    low = std::min(low, at);
    high = std::max(high, at);
  }
  glm::dvec2 lower(0);
  glm::dvec2 upper = size;
  lower[axis] = std::max(low, 0.0);
  upper[axis] = std::min(high, size[axis]);
  if (!(lower[axis] < upper[axis])) {
    throw InputError("no rays of \"" + frustum.name + "\" pass the stroke", "plan", "draw it across the rays");
  }
  const GraphCamera::Part window{lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
  const GraphCamera::Part part = largestFree(camera, inside, common(inside.part, window));
  if (part.empty()) {
    failTaken(frustum);
  }
  return inShares(part, size);
}

GraphCamera::Part freePart(const DrawnCamera& camera, const DrawnFrustum& frustum) {
  if (frustum.indices.size() != 1) {
    return {};
  }
  const GraphCamera::Frustum& inside = insideOf(camera, frustum);
  if (inside.children.empty()) {
    return {};
  }
  const GraphCamera::Part part = largestFree(camera, inside, inside.part);
  if (part.empty()) {
    failTaken(frustum);
  }
  return inShares(part, camera.imageSize());
}

}  // namespace ocelli
