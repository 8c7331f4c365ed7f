#include "oc_core/render/half_spaces.h"

#include <glm/geometric.hpp>

namespace ocelli {
namespace {

double inside(const HalfSpace& space, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(space), p) + space.w;
}

}  // namespace

HalfSpaces within(std::span<const glm::dvec2> polygon, const glm::dmat4& pixelFromWorld, double margin) {
  HalfSpaces spaces;
  const glm::dmat4 worldFromPixel = glm::transpose(pixelFromWorld);
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 along = glm::normalize(polygon[(i + 1) % polygon.size()] - a);
    // cross(along, (u, v) - a) + margin >= 0, times the weight of the image point.
    const double offset = margin - (along.x * a.y - along.y * a.x);
    spaces.push_back(worldFromPixel * glm::dvec4(-along.y, along.x, 0, offset));
  }
  return spaces;
}

Placement placementOf(const Box& box, std::span<const HalfSpace> spaces) {
  const glm::dvec3 center = (glm::dvec3(box.lower) + glm::dvec3(box.upper)) * 0.5;
  const glm::dvec3 half = (glm::dvec3(box.upper) - glm::dvec3(box.lower)) * 0.5;
  Placement placement = Placement::kInside;
  for (const HalfSpace& space : spaces) {
    const double middle = inside(space, center);
    const double reach = glm::dot(glm::abs(glm::dvec3(space)), half);
    if (middle + reach < 0) {
      return Placement::kOutside;
    }
    if (!(middle - reach >= 0)) {
      placement = Placement::kAcross;
    }
  }
  return placement;
}

void Clipper::clipTo(const HalfSpace& space) {
  scratch_.clear();
  for (size_t i = 0; i < polygon_.size(); ++i) {
    const ClipCorner& a = polygon_[i];
    const ClipCorner& b = polygon_[i + 1 == polygon_.size() ? 0 : i + 1];
    const double da = inside(space, a.p);
    const double db = inside(space, b.p);
    if (da >= 0) {
      scratch_.push_back(a);
    }
    if ((da >= 0) != (db >= 0)) {
      // From the inner end to the outer one, so that triangles that share an edge cut it alike.
      const ClipCorner& inner = da >= 0 ? a : b;
      const ClipCorner& outer = da >= 0 ? b : a;
      const double t = da >= 0 ? da / (da - db) : db / (db - da);
      scratch_.push_back({inner.p + (outer.p - inner.p) * t, inner.b + (outer.b - inner.b) * t});
    }
  }
  polygon_.swap(scratch_);
}

const std::vector<ClipCorner>& Clipper::clip(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                                             std::span<const HalfSpace> spaces) {
  polygon_.clear();
  polygon_.push_back({glm::dvec3(a), {0, 0}});
  polygon_.push_back({glm::dvec3(b), {1, 0}});
  polygon_.push_back({glm::dvec3(c), {0, 1}});
  for (const HalfSpace& space : spaces) {
    if (polygon_.empty()) {
      break;
    }
    clipTo(space);
  }
  return polygon_;
}

}  // namespace ocelli
