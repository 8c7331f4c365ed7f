#include "oc_core/relief/relief_view.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr float kEyeHeight = 5;     ///< radii
constexpr float kCellHalfSide = 4;  ///< its lowest corners see the tile from 10 degrees over the ground
constexpr double kImageMargin = 1.03;
constexpr double kLongestProportion = 16;

View fromAbove() {
  View view;
  view.eye = {0, kEyeHeight, 0};
  view.target = {0, 0, 0};
  view.up = {0, 0, -1};
  view.zNear = 0.05f;
  view.fovVerticalDegrees = 30;
  return view;
}

/// The tangents of the angles that the box takes to the side and up from the middle of a view.
glm::dvec2 tangentsOf(const View& view, const Box& bounds) {
  const PinholeCamera camera(view, 16, 16);
  glm::dvec2 tangents(0);
  for (const glm::vec3& corner : cornersOf(bounds)) {
    const glm::dvec3 p(camera.cameraFromWorld(corner));
    if (p.z > 0) {
      tangents = glm::max(tangents, glm::abs(glm::dvec2(p)) / p.z);
    }
  }
  return tangents;
}

}  // namespace

glm::ivec2 imageSizeFor(double width, double height, size_t texels) {
  const double proportion =
      height > 0 && width > 0 ? std::clamp(width / height, 1 / kLongestProportion, kLongestProportion) : 1.0;
  const auto wanted = static_cast<double>(texels);
  const auto columns = std::max(1, static_cast<int>(std::floor(std::sqrt(wanted * proportion))));
  return {columns, std::max(1, static_cast<int>(wanted) / columns)};
}

ReliefViews reliefViews(const Box& bounds, size_t texels, bool forCell) {
  ReliefViews views;
  views.reference = fromAbove();
  views.cell.sideRadii = 2 * kCellHalfSide;
  glm::dvec2 tangents = tangentsOf(views.reference, bounds);
  if (forCell) {
    for (const float x : {-1.0f, 1.0f}) {
      for (const float z : {-1.0f, 1.0f}) {
        // The lower corners, which are the nearest ones.
        const View corner = movedEye(views.reference, glm::vec3(x, z, -1) * kCellHalfSide);
        tangents = glm::max(tangents, tangentsOf(corner, bounds));
      }
    }
  }
  tangents = glm::max(tangents * kImageMargin, glm::dvec2(1e-3));
  views.size = imageSizeFor(tangents.x, tangents.y, texels);
  // Pixels are square: the side that is narrower for its pixels gives way.
  const double perPixel = 2 * std::max(tangents.x / views.size.x, tangents.y / views.size.y);
  views.reference.fovVerticalDegrees = 2 * degreesFromRadians(std::atan(perPixel * views.size.y / 2));
  return views;
}

SpocCamera reliefSpoc(const Box& bounds, size_t texels) {
  const View above = fromAbove();
  const float top = kEyeHeight - bounds.upper.y;
  const float bottom = kEyeHeight - bounds.lower.y;
  // Of the ground's footprint: a side as high as the object takes as many pixels as the same length of the top, about.
  const double spread = static_cast<double>(std::max(bottom - top, 1e-4f)) / static_cast<double>(bottom);
  const glm::dvec2 tangents = tangentsOf(above, bounds) * kImageMargin + spread;
  const glm::ivec2 size = imageSizeFor(tangents.x, tangents.y, texels);
  const double perPixel = 2 * std::max(tangents.x / size.x, tangents.y / size.y);
  View view = above;
  view.fovVerticalDegrees = 2 * degreesFromRadians(std::atan(perPixel * size.y / 2));
  const PinholeCamera reference(view, size.x, size.y);
  SpocDistortion distortion;
  distortion.pole = reference.centerPixels();
  distortion.zNear = top;
  distortion.zFar = std::max(bottom, top * 1.0001f);
  distortion.farPixels = static_cast<float>(spread / perPixel);
  return {reference, distortion};
}

}  // namespace ocelli
