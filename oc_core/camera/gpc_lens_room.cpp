#include "oc_core/camera/gpc_lens_room.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

namespace ocelli {
namespace {

bool isWithin(const glm::dvec2& p, const LensBox& box) {
  const glm::dvec2 deep = glm::min(p - box.lower, box.upper - p);
  return deep.x > kLensTouch && deep.y > kLensTouch;
}

/// Along one axis: the wanted coordinate, and the borders of what is taken, as far as they lie in the room.
std::vector<double> coordinates(int axis, double wanted, const LensBox& room, std::span<const LensBox> taken) {
  std::vector<double> found{wanted};
  for (const LensBox& box : taken) {
    for (const double border : {box.lower[axis], box.upper[axis]}) {
      if (border >= room.lower[axis] && border <= room.upper[axis]) {
        found.push_back(border);
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

std::optional<glm::dvec2> nearestFreePoint(const glm::dvec2& wanted, const LensBox& room,
                                           std::span<const LensBox> taken, const glm::dvec2& scale) {
  const auto isFree = [&](const glm::dvec2& p) {
    return std::none_of(taken.begin(), taken.end(), [&](const LensBox& box) { return isWithin(p, box); });
  };
  const glm::dvec2 inRoom = glm::clamp(wanted, room.lower, room.upper);
  if (isFree(inRoom)) {
    return inRoom;
  }
  struct Candidate {
    double distance;
    glm::dvec2 point;
  };
  std::vector<Candidate> candidates;
  const std::vector<double> rows = coordinates(1, inRoom.y, room, taken);
  for (const double x : coordinates(0, inRoom.x, room, taken)) {
    for (const double y : rows) {
      const glm::dvec2 point(x, y);
      candidates.push_back({glm::length((point - wanted) * scale), point});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  const auto found =
      std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& each) { return isFree(each.point); });
  return found == candidates.end() ? std::nullopt : std::optional(found->point);
}

}  // namespace ocelli
