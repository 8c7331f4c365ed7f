#include "oc_core/volume_ocri/volume_matter.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

double diagonalOf(const VolumeScene& scene) {
  const glm::dvec3 size(scene.volume->grid().size);
  const glm::dmat3 axes(scene.worldFromIndex);
  double longest = 0;
  for (const glm::dvec3& corner :
       {glm::dvec3(1, 1, 1), glm::dvec3(-1, 1, 1), glm::dvec3(1, -1, 1), glm::dvec3(1, 1, -1)}) {
    longest = std::max(longest, glm::length(axes * (size * corner)));
  }
  return longest;
}

}  // namespace

VolumeMatter::VolumeMatter(const VolumeScene& scene, double opacity)
    : scene_(scene),
      indexFromWorld_(glm::inverse(scene.worldFromIndex)),
      step_(scene.volume->grid().meanSpacing() * scene.sceneLengthOfUnit() / 2),
      minExtinction_(-std::log1p(-opacity) / (diagonalOf(scene) / scene.sceneLengthOfUnit())) {
  OC_CHECK(opacity > 0 && opacity < 1, "an opacity is above 0 and below 1");
  if (!scene.surfaces.empty()) {
    surfaces_ = std::make_unique<const RayScene>(scene.surfaces);
  }
}

bool VolumeMatter::isShown(const glm::dvec3& point) const {
  return std::ranges::all_of(scene_.clips,
                             [&](const ClipPlane& clip) { return glm::dot(clip.normal, point) >= clip.distance; });
}

bool VolumeMatter::isClearValue(double value) const {
  return scene_.appearance.transfer.at(value).extinction < minExtinction_;
}

bool VolumeMatter::isClearAt(const glm::dvec3& point) const {
  const glm::dvec3 index(indexFromWorld_ * glm::dvec4(point, 1));
  const glm::dvec3 upper = glm::dvec3(scene_.volume->grid().size) - 0.5;
  const bool isInside =
      glm::all(glm::greaterThanEqual(index, glm::dvec3(-0.5))) && glm::all(glm::lessThanEqual(index, upper));
  return !isInside || !isShown(point) || isClearValue(scene_.volume->fieldAt(index));
}

RayPath VolumeMatter::behind(const RayPath& ray, float t) const {
  RayPath rest;
  if (ray.size() < 2) {
    return rest;
  }
  const RayPath::Position hit = ray.positionAt(t);
  glm::dvec3 from(ray.pointAt(hit));
  double along = step_;  // from there to the next place that is looked at
  for (size_t segment = hit.segment; segment + 1 < ray.size(); ++segment) {
    const glm::dvec3 to(ray[segment + 1]);
    const double length = glm::distance(from, to);
    for (; along < length; along += step_) {
      const glm::dvec3 place = glm::mix(from, to, along / length);
      if (!isClearAt(place)) {
        continue;
      }
      const double whole = glm::distance(glm::dvec3(ray[segment]), to);
      const double share = whole > 0 ? glm::distance(glm::dvec3(ray[segment]), place) / whole : 0;
      const float start = ray.t(segment) + (ray.t(segment + 1) - ray.t(segment)) * static_cast<float>(share);
      if (!(start < ray.t(segment + 1))) {
        break;
      }
      rest.add(glm::vec3(place), start);
      for (size_t i = segment + 1; i < ray.size(); ++i) {
        rest.add(ray[i], ray.t(i));
      }
      return rest;
    }
    along -= length;
    from = to;
  }
  return rest;
}

bool VolumeMatter::isNear(const glm::vec3& point, float reach) const {
  if (!isClearAt(point) || (surfaces_ != nullptr && surfaces_->hasSurfaceNear(point, reach))) {
    return true;
  }
  const ScalarVolume& volume = *scene_.volume;
  const glm::dvec3 center(indexFromWorld_ * glm::dvec4(glm::dvec3(point), 1));
  // How far a sphere in the world reaches along each index: by the rows of the matrix.
  const glm::dmat3 rows = glm::transpose(glm::dmat3(indexFromWorld_));
  const glm::dvec3 extent =
      static_cast<double>(reach) * glm::dvec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
  const glm::dvec3 last(volume.grid().size - 1);
  const glm::dvec3 first = glm::ceil(glm::max(center - extent, glm::dvec3(0)));
  const glm::dvec3 end = glm::floor(glm::min(center + extent, last));
  for (double k = first.z; k <= end.z; ++k) {
    for (double j = first.y; j <= end.y; ++j) {
      for (double i = first.x; i <= end.x; ++i) {
        const glm::dvec3 place(scene_.worldFromIndex * glm::dvec4(i, j, k, 1));
        if (glm::distance(place, glm::dvec3(point)) <= static_cast<double>(reach) && isShown(place) &&
            !isClearValue(volume.valueAt({i, j, k}))) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace ocelli
