#include "oc_core/sea/sea_projection.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/image_codecs/image_codec.h"

namespace ocelli {
namespace {

constexpr auto kTurn = static_cast<float>(2 * kPi);
constexpr auto kHalfTurn = static_cast<float>(kPi);

}  // namespace

glm::vec3 SeaProjection::direction(const glm::vec2& pixel) const {
  if (kind == SeaProjectionKind::kPanorama) {
    const float longitude = (pixel.x / static_cast<float>(width) - 0.5f) * kTurn;
    const float latitude = (0.5f - pixel.y / static_cast<float>(height)) * kHalfTurn;
    const float level = std::cos(latitude);
    return {std::sin(longitude) * level, std::sin(latitude), -std::cos(longitude) * level};
  }
  const glm::dvec2 away = (glm::dvec2(pixel) - center) / focal;
  return glm::normalize(glm::vec3(static_cast<float>(away.x), static_cast<float>(-away.y), -1.0f));
}

std::optional<glm::vec2> SeaProjection::pixel(const glm::vec3& direction) const {
  if (kind == SeaProjectionKind::kPanorama) {
    const float longitude = std::atan2(direction.x, -direction.z);
    const float latitude = std::atan2(direction.y, std::hypot(direction.x, direction.z));
    return glm::vec2((longitude / kTurn + 0.5f) * static_cast<float>(width),
                     (0.5f - latitude / kHalfTurn) * static_cast<float>(height));
  }
  if (direction.z >= 0) {
    return std::nullopt;
  }
  const glm::dvec2 away = glm::dvec2(direction.x, -direction.y) / static_cast<double>(-direction.z);
  return glm::vec2(center + away * focal);
}

SeaProjection SeaProjection::scaled(double share) const {
  const auto side = [&](int pixels) { return std::max(1, static_cast<int>(std::lround(pixels * share))); };
  const glm::ivec2 size{side(width), side(height)};
  const glm::dvec2 factor{static_cast<double>(size.x) / width, static_cast<double>(size.y) / height};
  return {kind, size.x, size.y, focal * factor, center * factor};
}

double SeaProjection::pixelAngle() const {
  return kind == SeaProjectionKind::kPanorama ? 2 * kPi / width : 1 / focal.x;
}

void validate(const SeaProjection& projection, const std::string& where) {
  const int64_t pixels = int64_t{projection.width} * projection.height;
  if (projection.width < 8 || projection.height < 8 || projection.width > kMaxCodedSide ||
      projection.height > kMaxCodedSide || pixels > kMaxCodedPixels) {
    throw InputError("images of a sea have 8 to 16383 pixels a side, and at most 16 million in all", where,
                     "scale the images");
  }
  const bool isLens = projection.kind == SeaProjectionKind::kPinhole;
  const auto isFine = [](double focal) { return std::isfinite(focal) && focal > 1e-3 && focal < 1e9; };
  if (isLens && (!isFine(projection.focal.x) || !isFine(projection.focal.y) || !std::isfinite(projection.center.x) ||
                 !std::isfinite(projection.center.y))) {
    throw InputError("a focal length must be a positive number of pixels", where, "check the camera's parameters");
  }
}

SeaPose movedBy(const SeaPose& pose, const glm::dvec3& translation, const glm::dvec3& rotation) {
  const double angle = glm::length(rotation);
  const glm::dquat turn = angle > 0 ? glm::angleAxis(angle, rotation / angle) : glm::dquat(1, 0, 0, 0);
  return {pose.position + pose.worldFromCamera * translation, glm::normalize(pose.worldFromCamera * turn)};
}

}  // namespace ocelli
